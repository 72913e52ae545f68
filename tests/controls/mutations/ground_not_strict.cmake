# One comparison.
set(original "m_y > bottomBound")
set(mutated "m_y >= bottomBound")
