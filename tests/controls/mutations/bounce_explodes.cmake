# A bounce that leads to numbers beyond all numbers.
set(original "RESTITUTION = 0.6;")
set(mutated "RESTITUTION = 1e30;")
