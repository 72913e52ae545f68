/* Loaded into another program (LD_PRELOAD), this changes its floating-point arithmetic before main, as
 * a library linked with -ffast-math does. HYRAX_DISTURBED says how: "flush" flushes subnormal results
 * and operands to zero, "round" rounds upwards. */
#include <fenv.h>
#include <stdlib.h>
#include <string.h>

#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
static void flush_subnormals(void) { _mm_setcsr(_mm_getcsr() | 0x8040u); }
#elif defined(__aarch64__)
static void flush_subnormals(void) {
  unsigned long long control;
  __asm__ volatile("mrs %0, fpcr" : "=r"(control));
  __asm__ volatile("msr fpcr, %0" : : "r"(control | 1ull << 24));
}
#else
static void flush_subnormals(void) { exit(77); }
#endif

__attribute__((constructor)) static void disturb(void) {
  const char* how = getenv("HYRAX_DISTURBED");
  if (how != NULL && strcmp(how, "flush") == 0) flush_subnormals();
  if (how != NULL && strcmp(how, "round") == 0) fesetround(FE_UPWARD);
}
