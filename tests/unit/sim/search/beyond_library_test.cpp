// Random flings by two cores: what is counted is what runs of them show.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/search/beyond_library.h"
#include "sim/search/random_scenario.h"

namespace hyrax {
namespace {

constexpr std::int64_t kFlings = 60;

Core core_with(double Constants::*constant, double value) {
  Constants constants = shipped_core().constants.value();
  constants.*constant = value;
  return listing_core(constants);
}

const ExactEnd kNoExactEnd = [](const Scenario&, double) { return std::optional<State>(); };

double apart_px(const RunSummary& a, const RunSummary& b) {
  return std::hypot(a.final.x_px - b.final.x_px, a.final.y_px - b.final.y_px);
}

// Of both runs of each fling.
struct Counted {
  std::int64_t bounces = 0;
  std::int64_t settle = 0;
  std::vector<double> apart_px;
};
Counted counted_by_hand(const Core& accepted, const Core& current) {
  Counted counted;
  for (std::uint64_t number = 0; number < kFlings; ++number) {
    const Scenario fling = random_fling(accepted, 1, number);
    const RunSummary a = replay(accepted, fling), b = replay(current, fling);
    counted.bounces += a.contacts == b.contacts ? 0 : 1;
    counted.settle += !a.at_rest_since_s == !b.at_rest_since_s ? 0 : 1;
    if (apart_px(a, b) > 0.5) counted.apart_px.push_back(apart_px(a, b));
  }
  std::ranges::sort(counted.apart_px);
  return counted;
}

TEST(BeyondLibrary, OfOneCoreHasNoDifference) {
  const BeyondLibrary found = measure_beyond(shipped_core(), shipped_core(), kFlings, kNoExactEnd);
  for (const Share& share :
       {found.other_bits, found.ends_elsewhere, found.other_bounces, found.settles_in_one}) {
    EXPECT_EQ(share.count, 0);
    EXPECT_EQ(share.of, kFlings);
  }
  EXPECT_FALSE(found.apart_px.has_value() || found.end_error_px || found.farthest);
}

TEST(BeyondLibrary, CountsWhatItsRunsShow) {
  const Core accepted = shipped_core(), current = core_with(&Constants::restitution, 0.99);
  const BeyondLibrary found = measure_beyond(accepted, current, kFlings, kNoExactEnd);
  const Counted counted = counted_by_hand(accepted, current);
  EXPECT_GT(found.other_bits.count, found.ends_elsewhere.count);
  EXPECT_GT(found.ends_elsewhere.count, 10);
  EXPECT_EQ(found.ends_elsewhere.count, std::ssize(counted.apart_px));
  EXPECT_GT(found.other_bounces.count, 0);
  EXPECT_EQ(found.other_bounces.count, counted.bounces);
  EXPECT_GT(found.settles_in_one.count, 0);
  EXPECT_EQ(found.settles_in_one.count, counted.settle);
  EXPECT_EQ(found.apart_px.value().median, quantile(counted.apart_px, 0.5));
  EXPECT_EQ(found.apart_px.value().high, quantile(counted.apart_px, 0.9));
  const Scenario farthest = found.farthest.value();
  EXPECT_EQ(apart_px(replay(accepted, farthest), replay(current, farthest)), counted.apart_px.back());
}

TEST(BeyondLibrary, OfSpeedsThatDifferEndsNowhereElse) {
  const BeyondLibrary found =
      measure_beyond(shipped_core(), core_with(&Constants::gravity_px_per_s2, std::nextafter(1200.0, 2000.0)),
                     kFlings, kNoExactEnd);
  EXPECT_GT(found.other_bits.count, kFlings / 2);
  EXPECT_LT(found.ends_elsewhere.count, kFlings / 10);
}

TEST(BeyondLibrary, IsInfinitelyFarWhereOneRunAloneStaysFinite) {
  const Core exploding = core_with(&Constants::air_drag, 1e200);
  const BeyondLibrary found = measure_beyond(shipped_core(), exploding, kFlings, kNoExactEnd);
  EXPECT_EQ(found.apart_px.value().median, std::numeric_limits<double>::infinity());
  const BeyondLibrary both = measure_beyond(exploding, exploding, kFlings, kNoExactEnd);
  EXPECT_EQ(both.ends_elsewhere.count, 0);
}

// Measured from a place at which both cores never are.
TEST(BeyondLibrary, TakesTheErrorOfBothEndsWhereTheExactOneIsKnown) {
  std::int64_t asked = 0;
  std::vector<double> times_s;
  const auto every_other = [&](const Scenario&, double t_s) {
    times_s.push_back(t_s);
    return asked++ % 2 == 0 ? std::optional(State{-3e12, -4e12, 0.0, 0.0}) : std::nullopt;
  };
  const BeyondLibrary found = measure_beyond(shipped_core(), shipped_core(), kFlings, every_other);
  EXPECT_EQ(asked, kFlings);
  EXPECT_EQ(std::ranges::count_if(times_s, [](double t_s) { return t_s > 5.0 && t_s < 21.0; }), kFlings);
  EXPECT_NEAR(found.end_error_px.value().accepted, 5e12, 1e12);
  EXPECT_EQ(found.end_error_px.value().accepted, found.end_error_px.value().current);
}

}  // namespace
}  // namespace hyrax
