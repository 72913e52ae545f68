# Something put right: a frame of no time does not drag.
set(original [[
    m_vx *= AIR_DRAG;
    m_vy *= AIR_DRAG;
]])
set(mutated [[
    if (dt > 0.0) {
      m_vx *= AIR_DRAG;
      m_vy *= AIR_DRAG;
    }
]])
