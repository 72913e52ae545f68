# One wall that is not like the other.
set(original [[
      m_x = rightBound;
      m_vx = -m_vx * RESTITUTION;]])
set(mutated [[
      m_x = rightBound;
      m_vx = -m_vx * 0.5;]])
