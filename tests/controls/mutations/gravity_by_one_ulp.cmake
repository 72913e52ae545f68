# One constant, by one unit in the last place.
set(original "GRAVITY = 1200.0;")
set(mutated "GRAVITY = 1200.0000000000002;")
