# A ground contact that turns the speed and leaves the sprite where it is.
set(original "m_y = bottomBound;")
set(mutated "")
