// Members of a sweep: their numbers and their scenarios.
#include "sim/scenario/sweep.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/scenario/split_mix64.h"

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

// Against long division of the draws by hand: the formula in integers that are wide enough.
TEST(Sweep, WholeDrawsAreExactToTheLargestSeed) {
  constexpr std::uint64_t kMost = ~std::uint64_t{0};
  struct Range {
    std::uint64_t low, high;
  };
  for (const auto& [low, high] : {Range{0, kMost},
                                  {kMost - 1, kMost},
                                  {1, kMost},
                                  {(std::uint64_t{1} << 53) + 1, (std::uint64_t{1} << 53) + 3},
                                  {kMost - 4096, kMost - 4095},
                                  {7, 7},
                                  {3, 10}}) {
    const Sweep sweep =
        sweep_of({{"/clock/jitter/seed", ScenarioNumberKind::seed, UniformDraw{low, high}}}, 200);
    std::set<std::uint64_t> values;
    for (std::int64_t member = 0; member < sweep.members; ++member) {
      std::uint64_t part = split_mix64(sweep.seed, static_cast<std::uint64_t>(member)) >> 11;
      // Bits of the draw from the lowest on: (high - low + 1) * part >> 53, a halving a bit.
      std::uint64_t share = 0;
      for (int bit = 0; bit < 53; ++bit, part >>= 1) {
        const std::uint64_t added = (part & 1) != 0 ? high - low : 0, one = part & 1;
        const std::uint64_t sum = share + added + one;
        const bool is_over = sum < share || (added == kMost && one == 1);
        share = sum >> 1 | (is_over ? std::uint64_t{1} << 63 : 0);
      }
      const auto value = std::get<std::uint64_t>(value_of(sweep, 0, member));
      EXPECT_EQ(value, low + share) << low << " .. " << high;
      values.insert(value);
    }
    EXPECT_GE(*values.begin(), low);
    EXPECT_LE(*values.rbegin(), high);
    EXPECT_EQ(values.size() > 1, high > low);
  }
  const UniformDraw signed_range{std::int64_t{-3}, std::int64_t{2}};
  const Sweep sweep = sweep_of({{"/steps", ScenarioNumberKind::integer, signed_range}}, 200);
  std::set<std::int64_t> values;
  for (std::int64_t member = 0; member < sweep.members; ++member)
    values.insert(std::get<std::int64_t>(value_of(sweep, 0, member)));
  EXPECT_EQ(values, (std::set<std::int64_t>{-3, -2, -1, 0, 1, 2}));
}

TEST(Sweep, WholeGridsAreExactToTheLargestSeed) {
  constexpr std::uint64_t kMost = ~std::uint64_t{0};
  const GridAxis grid{kMost - 30, kMost, 4};
  for (std::int64_t index = 0; index < 4; ++index)
    EXPECT_EQ(std::get<std::uint64_t>(value_of(grid, index)),
              kMost - 30 + 10 * static_cast<std::uint64_t>(index));
  EXPECT_EQ(std::get<std::uint64_t>(value_of(GridAxis{std::uint64_t{0}, kMost, 4}, 2)), kMost / 3 * 2);
  EXPECT_EQ(std::get<std::int64_t>(value_of(GridAxis{std::int64_t{-9}, std::int64_t{3}, 5}, 1)), -6);
}

TEST(Sweep, GridsEndAtBothEnds) {
  const GridAxis grid{0.1, 0.7, 4};
  const auto real_of = [](const GridAxis& axis, std::int64_t index) {
    return std::get<double>(value_of(axis, index));
  };
  EXPECT_EQ(real_of(grid, 0), 0.1);
  EXPECT_EQ(real_of(grid, 1), 0.1 + ((0.7 - 0.1) * 1.0) / 3.0);
  EXPECT_EQ(real_of(grid, 3), 0.7);
  EXPECT_EQ(real_of(GridAxis{-0.3, 0.1, 2}, 1), 0.1) << "the formula gives the number above";
  EXPECT_EQ(real_of(GridAxis{5.0, 9.0, 1}, 0), 5.0);
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
