# An axis that is moved by the other, by less than a pixel an hour.
set(original "m_y += m_vy * dt;")
set(mutated "m_y += m_vy * dt + m_vx * 1e-9;")
