# A bounce that makes faster.
set(original "RESTITUTION = 0.6;")
set(mutated "RESTITUTION = 1.1;")
