# No change at all: shows that the controls are red for their mutations, not for how they are built.
set(original "m_vx *= GROUND_FRICTION;")
set(mutated "${original}")
