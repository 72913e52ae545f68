# Two operations in another order.
set(original [[
    m_vy += GRAVITY * dt;
    m_vx *= AIR_DRAG;
    m_vy *= AIR_DRAG;
]])
set(mutated [[
    m_vx *= AIR_DRAG;
    m_vy *= AIR_DRAG;
    m_vy += GRAVITY * dt;
]])
