# Nothing but `update`: its halves stay as they are, so only a replay that calls it itself goes red.
set(original [[
    collide(screenW, screenH, objW, objH);
  }]])
set(mutated [[
    collide(screenW, screenH, objW, objH);
    m_x = std::nextafter(m_x, 1e300);
  }]])
