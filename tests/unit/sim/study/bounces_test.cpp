// What the study of bounces says of energies that exact impacts must not change.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/study/bounces/bounces.h"

namespace hyrax {
namespace {

TEST(BouncesResult, ARuleIsBrokenByExactImpactsThatLoseEnergy) {
  const KeptEnergy paper{BounceMethod::paper, 60.0, 0, 500.0, 0.5, 0.4},
      euler{BounceMethod::explicit_euler, 60.0, 0, 500.0, 1.5, 1.7},
      exact{BounceMethod::exact, 0.0, 0, 500.0, 1.0, 1.0 + 1e-10};
  EXPECT_TRUE(bounces_result({paper, euler, exact}).verdict.broken.empty());
  for (double KeptEnergy::*const part : {&KeptEnergy::minute, &KeptEnergy::ten_minutes})
    for (const auto& [kept, change] :
         {std::pair(1.0 - 1e-8, "-1e-08"), {1.0 + 1e-8, "1e-08"}, {std::nan(""), "nan"}}) {
      KeptEnergy changed = exact;
      changed.number = 7;
      changed.*part = kept;
      EXPECT_EQ(bounces_result({paper, euler, exact, changed}).verdict.broken,
                std::vector<std::string>{std::string("exact impacts: throw 7 changes its energy by ") +
                                         change + " of it, more than 1e-09"});
    }
}

}  // namespace
}  // namespace hyrax
