#include "sim/reference/phi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/sim/reference/wide.h"

namespace hyrax {
namespace {

double relative_error(double value, const Wide& truth) {
  return std::fabs(((Wide(value) - truth) / truth).rounded());
}
double relative_error(const DoubleDouble& value, const Wide& truth) {
  return std::fabs(((Wide(value.hi) + value.lo - truth) / truth).rounded());
}

// z from -1e-18 to -1e6, evenly in its logarithm.
double random_z(std::mt19937_64& random) {
  return -std::pow(10.0, std::uniform_real_distribution<>(-18.0, 6.0)(random));
}

// Twelve terms and their sums cost an ulp or two, each of at most eight doublings another half.
TEST(Phi, AgreesWith256BitsAtAnyDamping) {
  std::mt19937_64 random(1);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double z = random_z(random);
    const Phi p = phi(z);
    const WideTextbookPhi truth{Wide(z)};
    worst = std::max({worst, relative_error(p.one, truth.one), relative_error(p.two, truth.two)});
  }
  EXPECT_LT(worst, 1e-15);
}

TEST(WidePhi, HasAHundredBits) {
  for (const double z : {-90.0, -3.0, -1.0, -0.5, -1e-3, -1e-9}) {
    const WidePhi p = wide_phi({z, 0.0});
    const WideTextbookPhi truth{Wide(z)};
    EXPECT_LT(relative_error(p.one, truth.one), 0x1p-100) << z;
    EXPECT_LT(relative_error(p.two, truth.two), 0x1p-100) << z;
  }
}

TEST(WideLog, HasAHundredBits) {
  for (const double a : {0.5, 0.75, 0.999, 0.99996, 1.0 - 0x1p-40})
    EXPECT_LT(relative_error(wide_log(a), log(Wide(a))), 0x1p-99) << a;
}

}  // namespace
}  // namespace hyrax
