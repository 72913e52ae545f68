// Members of a sweep: their numbers and their scenarios.
#include "sim/scenario/sweep.h"

#include <gtest/gtest.h>

namespace hyrax {
namespace {

Sweep sweep_of(std::vector<VariedKey> vary, std::int64_t members = 12) {
  Sweep sweep;
  sweep.base.clock.base = FixedRate{60.0};
  sweep.base.length = std::int64_t{10};
  sweep.members = members;
  sweep.seed = 7;
  sweep.vary = std::move(vary);
  return sweep;
}

VariedKey x(decltype(VariedKey::variation) variation) {
  return {"/start/x_px", ScenarioNumberKind::real, std::move(variation)};
}

TEST(Sweep, WholeDrawsNeverRoundBeyondTheirEnd) {
  for (const double low : {0x1p52, 0x1p53 - 1.0}) {
    const UniformDraw range{low, low + 1.0};
    const Sweep sweep = sweep_of({{"/steps", ScenarioNumberKind::integer, range}}, 100);
    for (std::int64_t member = 0; member < sweep.members; ++member)
      EXPECT_LE(std::get<std::int64_t>(value_of(sweep, 0, member)), static_cast<std::int64_t>(range.high));
  }
}

TEST(Sweep, GridsEndAtBothEnds) {
  const GridAxis grid{0.1, 0.7, 4};
  EXPECT_EQ(value_of(grid, 0), 0.1);
  EXPECT_EQ(value_of(grid, 1), 0.1 + ((0.7 - 0.1) * 1.0) / 3.0);
  EXPECT_EQ(value_of(grid, 3), 0.7);
  EXPECT_EQ(value_of(GridAxis{-0.3, 0.1, 2}, 1), 0.1) << "the formula gives the number above";
  EXPECT_EQ(value_of(GridAxis{5.0, 9.0, 1}, 0), 5.0);
}

TEST(Sweep, MembersHaveTheirNumbers) {
  const Sweep seeds = sweep_of({{"/clock/jitter/seed", ScenarioNumberKind::seed, MemberNumber{}}});
  EXPECT_EQ(std::get<std::uint64_t>(value_of(seeds, 0, 5)), 5u);
  const Sweep sweep = sweep_of({x(MemberNumber{}), {"/steps", ScenarioNumberKind::integer, MemberNumber{}}});
  SweepMembers members(sweep);
  for (const std::int64_t member : {3, 1}) {
    EXPECT_EQ(members.scenario(member).start.x_px, static_cast<double>(member));
    EXPECT_EQ(std::get<std::int64_t>(members.scenario(member).length), member);
  }
}

TEST(Sweep, FindsTheFirstMemberWithoutFrames) {
  Sweep sweep = sweep_of({{"/events/0/step", ScenarioNumberKind::integer, MemberNumber{}}}, 10);
  sweep.base.events = {{std::int64_t{0}, Stop{}}};
  EXPECT_EQ(first_inconsistent_member(sweep), std::nullopt);
  sweep.members = 20;
  EXPECT_EQ(first_inconsistent_member(sweep), 10);
  // A duration needs a dt, and has no more than so many frames.
  sweep = sweep_of({{"/clock/dt_s", ScenarioNumberKind::real, GridAxis{1.0, 0.0, 10}}}, 10);
  sweep.base.clock.base = FixedStep{1.0};
  EXPECT_EQ(first_inconsistent_member(sweep), std::nullopt);
  sweep.base.length = 5.0;
  EXPECT_EQ(first_inconsistent_member(sweep), 9);
  sweep.vary = {{"/duration_s", ScenarioNumberKind::real, GridAxis{0.0, 4.5e12, 10}}};
  EXPECT_EQ(first_inconsistent_member(sweep), 3);  // 1.5e12 frames of 1 s; member 2 has 1e12, the most.
}

}  // namespace
}  // namespace hyrax
