# A core that remembers what no row tells, so that no run is like the one before.
set(original [[
    collide(screenW, screenH, objW, objH);
  }]])
set(mutated [[
    collide(screenW, screenH, objW, objH);
    static long calls = 0;
    if (++calls % 1009 == 0) m_vx = m_vx * 0.5;
  }]])
