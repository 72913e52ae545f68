// Final states of flings by display rate, and what the study of rest says of them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/study/rest/rest_map.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

constexpr double kBottom_px = 952.0;

// By the listing's laws at 60 Hz.
TEST(FinalState, IsToldByTwoRowsInARow) {
  const Constants core = *shipped_core().constants;
  const double thrown = -core.restitution * core.air_drag * core.gravity_px_per_s2 / 60.0;
  const double residual = thrown / (1.0 + core.air_drag * core.restitution);
  const struct {
    double vy, next_vy;
    FinalState state;
    double above_px = 0.0;
  } cases[] = {{0.0, -0.0, FinalState::zero_speed},
               {residual, std::nextafter(residual, 0.0), FinalState::residual_speed},
               {0.0, thrown, FinalState::two_cycle},
               {thrown, 0.0, FinalState::two_cycle},
               {-3.0, 0.0, FinalState::moving},
               {0.0, 0.0, FinalState::moving, 1e-9}};
  for (const auto& [vy, next_vy, state, above_px] : cases)
    EXPECT_EQ(final_state(shipped_core(), {0.0, kBottom_px - above_px, 0.0, vy},
                          {0.0, kBottom_px, 0.0, next_vy}, 60.0),
              state)
        << vy << ", " << next_vy;
}

// It stops bounces below 8 px/s and says 5: at 120 Hz it keeps none of 5.99 px/s, at 60 Hz it leaves 11.99.
TEST(RestMap, CountsTheFinalStatesThatTheBoundariesDoNotAllow) {
  Constants laws = *shipped_core().constants;
  laws.rest_threshold_px_per_s = 8.0;
  Core lying = listing_core(laws);
  lying.constants = shipped_core().constants;
  const std::vector<RateEnds> map = rest_map(lying, {60.0, 120.0}, 5);
  EXPECT_EQ(map[0].unforeseen, 0);
  EXPECT_EQ(map[1].unforeseen, 5);
  EXPECT_EQ(map[1].count(FinalState::zero_speed), 5);
  for (const RestBoundary& boundary : rest_boundaries(lying))
    EXPECT_FALSE(boundary.agrees()) << boundary.name;
}

// At 1000 Hz it falls at 1.2 px/s.
TEST(RestMap, DoesNotTakeAFlingThatStillFallsForOneThatEnded) {
  Constants laws = *shipped_core().constants;
  laws.air_drag = 0.5;
  const std::vector<RateEnds> map = rest_map(listing_core(laws), {1000.0}, 5);
  EXPECT_EQ(map[0].count(FinalState::moving), 5);
  EXPECT_EQ(map[0].unforeseen, 0);
}

TEST(RestMap, PercentIsRoundedOnce) {
  EXPECT_EQ((RateEnds{.rate_hz = 60.0, .flings = {0, 85, 115, 0}}).percent(FinalState::residual_speed), 57.5);
}

TEST(RestVerdict, SaysWhatMovesAndWhatIsBroken) {
  RateEnds ends{.rate_hz = 60.0, .flings = {1, 0, 0, 2}, .unforeseen = 1};
  const Verdict verdict =
      rest_verdict({.boundaries = {{"a", "first", 100.0, 100.5}, {"b", "second", 50.0, {}}}, .map = {ends}});
  EXPECT_NE(described(verdict).find("settles_after,_s: : 1: '-'"), std::string::npos) << "none has settled";
  EXPECT_EQ(std::get<std::string>(verdict.text[1]), "2 of 3 flings still move after 15 s.");
  EXPECT_EQ(verdict.broken,
            (std::vector<std::string>{"first: analytic 100 Hz, measured 100.5 Hz",
                                      "second: analytic 50 Hz, measured none",
                                      "60 Hz: 2 flings still move after 15 s",
                                      "60 Hz: 1 flings end in a way that the boundaries do not allow"}));
}

}  // namespace
}  // namespace hyrax
