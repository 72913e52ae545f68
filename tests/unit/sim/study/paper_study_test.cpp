// The study paper: verdicts that follow from numbers, and the comparison with expected verdicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "sim/core/core_of.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/study/paper/paper_claim.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

TEST(SpeedClaim, HoldsOnlyForAFastStep) {
  EXPECT_EQ(speed_claims(1.66e-5).front().verdict, ClaimVerdict::holds);
  EXPECT_EQ(speed_claims(1.67e-5).front().verdict, ClaimVerdict::does_not_hold);
}

// Of a hundred throws 63, 54, 43 and 34 settle near each other: the interval decides, or does not.
TEST(FrameRateClaim, IsDecidedByMoreThanChance) {
  Constants constants = shipped_core().constants.value();
  std::vector<ClaimVerdict> verdicts;
  for (constants.ground_friction = 0.1; constants.ground_friction < 0.26; constants.ground_friction += 0.05)
    verdicts.push_back(frame_rate_claim(listing_core(constants), {}).verdict);
  EXPECT_EQ(verdicts, (std::vector{ClaimVerdict::holds, ClaimVerdict::not_measured,
                                   ClaimVerdict::not_measured, ClaimVerdict::does_not_hold}));
}

// Claims of the shipped core at 1 ns a step; computed on first use.
const std::vector<Claim>& claims() {
  static const std::vector<Claim> all = paper_claims(shipped_core(), 1e-9);
  return all;
}

std::size_t row_of(const std::string& id) {
  const auto claim = std::ranges::find(claims(), id, &Claim::id);
  if (claim == claims().end()) throw std::logic_error("no claim " + id);
  return static_cast<std::size_t>(claim - claims().begin());
}

// Gravity in steps and drag that grows with the speed in x; walls of different restitution that rub, a
// ceiling that stops, no walls without room, and a ground that a fast sprite passes, that does not rub, and
// that stops every bounce.
class OtherCore : World {
 public:
  static constexpr double GRAVITY = 1000.0, RESTITUTION = 0.5, AIR_DRAG = 0.99, GROUND_FRICTION = 0.7,
                          REST_THRESHOLD = 6.0;
  OtherCore(double x_px, double y_px, double vx_px_per_s, double vy_px_per_s) {
    state = {x_px, y_px, vx_px_per_s, vy_px_per_s};
  }
  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px) {
    const Bounds bounds = bounds_of({window_width_px, window_height_px}, {sprite_width_px, sprite_height_px});
    State& s = state;
    s.x_px += s.vx_px_per_s * dt_s;
    s.y_px += s.vy_px_per_s * dt_s;
    s.vx_px_per_s *= 1.0 - 1e-6 * std::fabs(s.vx_px_per_s);
    s.vy_px_per_s = AIR_DRAG * s.vy_px_per_s + GRAVITY * dt_s * (dt_s > 0.05 ? 2.0 : 1.0);
    if (bounds.right_px < 0.0) return;
    if (s.x_px < 0.0 || s.x_px > bounds.right_px) {
      s.vx_px_per_s *= s.x_px < 0.0 ? -0.5 : -0.7;
      s.vy_px_per_s *= 0.75;
      s.x_px = s.x_px < 0.0 ? 0.0 : bounds.right_px;
    }
    if (s.y_px < 0.0) s.y_px = s.vy_px_per_s = 0.0;
    if (s.y_px > bounds.bottom_px && s.vy_px_per_s < 1500.0) {
      s.y_px = bounds.bottom_px;
      s.vy_px_per_s = 0.0;
    }
  }
  [[nodiscard]] double x() const { return state.x_px; }
  [[nodiscard]] double y() const { return state.y_px; }
  [[nodiscard]] double vx() const { return state.vx_px_per_s; }
  [[nodiscard]] double vy() const { return state.vy_px_per_s; }
  using World::setPos, World::setVelocity;
  void resetVelocity() { setVelocity(0.0, 0.5 * state.vy_px_per_s); }
};

// Moves nothing.
struct StillStep {
  void operator()(State&, double, const Bounds&) const {}
};
struct StillCores : StepCores<StillStep> {
  [[nodiscard]] Constants constants() const { return *shipped_core().constants; }
};

// What the paper's own core never shows: the other verdicts and remarks.
TEST(Paper, WhatIsSaidOfOtherCoresIsWhatWasApproved) {
  const Core still{.name = kPhysicsModel,
                   .constants = shipped_core().constants,
                   .kernel = std::make_shared<const KernelOf<StillCores>>()};
  std::string text;
  for (const auto& [name, core] :
       {std::pair("no loss", listing_core({1200.0, 1.0, 1.0, 1.0, 0.0})),
        std::pair("no gravity", listing_core({0.0, 0.6, 0.999, 0.8, 5.0})),
        std::pair("lively", listing_core({1200.0, 0.9, 0.3, 1.1, 20.0})), std::pair("still", still),
        std::pair("other", core_of<OtherCore>(kPhysicsModel, {}))}) {
    text += std::string(name) + "\n";
    // Energy of the listing's step alone is measured, which takes long.
    const bool is_listing = core.shape.constants.has_value();
    std::vector<Claim> measured = is_listing ? std::vector<Claim>() : paper_claims(core, 1e-9);
    for (const auto& measure : {flight_claims, wall_claims, time_step_claims, order_claims, constant_claims,
                                use_claims, +[](const Core& of) { return accuracy_claims(of); }})
      if (is_listing) std::ranges::move(measure(core), std::back_inserter(measured));
    for (const Claim& claim : measured) {
      const Claim& of_paper = claims()[row_of(claim.id)];
      if (claim.verdict == of_paper.verdict && claim.remark == of_paper.remark) continue;
      text += "  " + claim.id + ": " + std::string(name_of(claim.verdict)) + ", " +
              (std::isnan(claim.number) ? "no number" : six_digits(claim.number) + " " + claim.unit) +
              (claim.range ? ", a range" : "") + ", expected " + claim.expected +
              (claim.remark.empty() ? "" : "; " + claim.remark) + "\n";
    }
  }
  expect_approved("tests/unit/sim/study/approved/paper-of-others.txt", text);
}

Result run_paper(const std::optional<ExpectedVerdicts>& expected) { return paper_result(claims(), expected); }

// The verdicts that this core has.
ExpectedVerdicts own_verdicts() {
  ExpectedVerdicts expected{.path = "expected.json"};
  for (const Claim& claim : claims())
    expected.verdicts.emplace_back(claim.id, std::string(name_of(claim.verdict)));
  return expected;
}

std::string& verdict_on(const std::string& name, ExpectedVerdicts& expected) {
  return expected.verdicts[row_of(name)].second;
}

// The fields of one claim in the picture: section, sentence, verdict, expected (if there is a file), number.
std::vector<ListField> shown_claim(const Result& result, const std::string& name) {
  return std::get<Listing>(result.figures.front().body).rows[row_of(name)];
}

TEST(Paper, OnlyAnotherOrMissingVerdictIsBrokenAndColoured) {
  EXPECT_EQ(shown_claim(run_paper({}), "2.3-energy").size(), 4u);
  ExpectedVerdicts expected = own_verdicts();
  verdict_on("5-restitution", expected) = "not measured";
  verdict_on("5-air-drag", expected) = "does not hold";
  std::erase_if(expected.verdicts, [](const auto& entry) { return entry.first == "5-gravity"; });
  const Result result = run_paper(expected);
  EXPECT_EQ(result.verdict.broken,
            (std::vector<std::string>{
                "5-gravity: holds, but expected.json has no verdict for it",
                "5-restitution: holds, but expected.json expects: not measured (the core's value: 0.6)",
                "5-air-drag: holds, but expected.json expects: does not hold (the core's value: 0.999)"}));
  EXPECT_EQ(shown_claim(result, "5-restitution")[3].fill, Tone::hairline);
  EXPECT_EQ(shown_claim(result, "5-gravity")[3].text, "no verdict");
  const std::vector<ListField> drag = shown_claim(result, "5-air-drag");
  ASSERT_EQ(drag.size(), 5u);
  EXPECT_EQ(drag[2].fill, Tone::good);
  EXPECT_EQ(drag[3].text, "does not hold");
  EXPECT_EQ(drag[3].fill, Tone::bad);
  EXPECT_EQ(
      result.figures.front().subtitle,
      "Each sentence against the core: 26 hold, 6 hold on a condition, 9 do not hold; an expected verdict "
      "that differs is coloured");
  std::vector<Claim> unmeasured = claims();
  unmeasured[row_of("2.3-energy")].verdict = ClaimVerdict::not_measured;
  EXPECT_EQ(
      std::get<std::string>(paper_result(unmeasured, {}).verdict.text.front()),
      "paper: 41 claims measured: 26 hold, 6 hold on a condition, 8 do not hold, 1 could not be measured");
  const ListField same = shown_claim(result, "2.2-stokes")[3];
  EXPECT_EQ(same.text, "holds when");
  EXPECT_EQ(same.fill, Tone::none);
}

TEST(Paper, UnknownClaimsAndVerdictsAreRefusedAllAtOnce) {
  ExpectedVerdicts expected = own_verdicts();
  verdict_on("5-gravity", expected) = "maybe";
  expected.verdicts.insert(expected.verdicts.begin(), {"9-moon", "holds"});
  expected.verdicts.emplace_back("9-sun", "maybe");
  try {
    (void)run_paper(expected);
    FAIL() << "not refused";
  } catch (const RequestRefused& refused) {
    EXPECT_STREQ(refused.what(),
                 "expected.json: /verdicts/5-gravity: unknown verdict (found maybe); allowed: holds, holds "
                 "when, does not hold, not measured\n"
                 "expected.json: /verdicts: unknown claim (found 9-moon, 9-sun); `hyrax-sim study paper` "
                 "prints all claims");
  }
}

}  // namespace
}  // namespace hyrax
