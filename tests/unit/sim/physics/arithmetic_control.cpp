// Built with flags that spoil arithmetic, the guards lifted: prints what the self-test finds.
#include <cstdio>

#include "sim/physics/strict_arithmetic.h"

namespace {

constexpr int kSkipped = 77;

// Whether this machine has the instructions that this file was built for.
bool can_run() {
#ifdef __FMA__
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

}  // namespace

int main() {
  if (!can_run()) return kSkipped;
  const auto fault = hyrax::arithmetic_fault();
  std::puts(fault ? fault->data() : "strict");
}
