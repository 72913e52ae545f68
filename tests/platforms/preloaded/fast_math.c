/* Nothing but a library: what -ffast-math links into it flushes subnormal numbers to zero in every
 * program that loads it. */
int hyrax_fast_math;
