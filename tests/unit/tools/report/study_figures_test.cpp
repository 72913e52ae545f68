// The scripts of the studies' pictures.
#include <gtest/gtest.h>

#include "tools/report/rest_figures.h"

namespace hyrax {
namespace {

bool has(const std::string& script, const std::string& words) { return script.find(words) != script.npos; }

// From all in residual speed to all at zero speed, at the boundary between the two rates.
TEST(RestMap, StepsAtTheBoundaryBetweenTwoRates) {
  RateEnds slow, fast;
  slow.rate_hz = 60.0;
  slow.flings[static_cast<std::size_t>(FinalState::buzz)] = 5;
  fast.rate_hz = 240.0;
  fast.flings[static_cast<std::size_t>(FinalState::rest)] = 5;
  EXPECT_TRUE(has(rest_map_script({slow, fast}, {{"some", 144.0, std::nullopt}}),
                  "60 100 100 100\n144 100 100 100\n144 0 0 100\n240 0 0 100\n"));
  EXPECT_TRUE(has(rest_map_script({slow, fast}, {}), "\n120 100 100 100\n120 0 0 100\n"));
}

}  // namespace
}  // namespace hyrax
