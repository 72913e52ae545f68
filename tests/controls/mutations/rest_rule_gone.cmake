# No rest rule.
set(original "if (std::fabs(m_vy) < REST_THRESHOLD) m_vy = 0.0;")
set(mutated "")
