// All that is measured of two cores, from a small library and few flings: the card is the one approved.
#include <gtest/gtest.h>

#include "sim/card/card.h"
#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

// Bounces higher and slides farther than the constants that it has say.
Core lively_core() {
  Constants constants = shipped_core().constants.value();
  constants.restitution = 0.9;
  constants.ground_friction = 0.95;
  Core lively = listing_core(constants);
  lively.constants = shipped_core().constants;
  return lively;
}

TEST(MeasuredCard, IsTheOneApproved) {
  PlayWatch watch{};
  const auto compared = [&watch](int number, const Core& core, const CoreRecord& record) {
    return compared_core(number, {.counted = core, .timed = core, .lacking = {}}, record, watch);
  };
  const ComparedCore base = compared(0, shipped_core(), shipped_core().record);
  const ComparedCore candidate = compared(1, lively_core(), {.why_incomplete = "not traced"});
  Scenario high = fling_at(60.0, 60);  // Bounces for half a minute by the candidate.
  high.window.height_px = 5000;
  std::int64_t now_ns = 0, calls = 0;
  CardRequest request{.library = {{"flings/calm.json", fling_at(60.0, 400)},
                                  {"recorded/eventful.json", eventful_fling()},
                                  {"hard/slow.json", fling_at(24.0, 100)},
                                  {"high.json", high}},
                      .seed = 3,
                      .flings = 6,
                      .now_ns = [&] { return now_ns += 100'000 + 400 * (++calls % 7); }};
  request.recordings = {request.library[1]};
  request.hard = {request.library[2]};
  request.rows_hash = {rows_hash(base, request), rows_hash(candidate, request)};
  const Card card = measure_card(base, candidate, request);
  const Result result = card_result(card);
  std::string text = "at most " + six_digits(card.displays.distance_max_px) + " px apart on a display\n";
  Constants springy = shipped_core().constants.value();
  springy.restitution = 1.0;
  const RestLine rest =
      measure_rest(base, compared(1, listing_core(springy), {.why_incomplete = "not traced"}));
  text += "a drop moves " + described(rest.moved_px.before) + "; springy " + described(rest.moved_px.after) +
          "\n";
  text += described(result.verdict);
  for (const Table& table : result.summary) text += described(table);
  for (const Figure& figure : result.figures) text += described(figure);
  expect_approved("tests/unit/sim/card/measured.txt", text);
}

// Each core is timed once, then the base and the candidate, the candidate and the base, and so on: 30,000
// steps in 1 and 3 ns each.
TEST(MeasuredCost, IsOfTheCandidateOverTheBaseWhicheverIsTimedFirst) {
  PlayWatch watch{};
  const ComparedCore core = compared_core(
      0, {.counted = shipped_core(), .timed = shipped_core(), .lacking = {}}, shipped_core().record, watch);
  std::int64_t now_ns = 0, calls = 0;
  const CostLine cost = measure_cost(core, core, 1, [&] {
    const std::int64_t sample = calls / 2 % 4;
    if (calls++ % 2 == 1) now_ns += sample == 1 || sample == 2 ? 30'000 : 90'000;
    return now_ns;
  });
  EXPECT_EQ(cost.step_ns.before.median, 1.0);
  EXPECT_EQ(cost.step_ns.after.median, 3.0);
  EXPECT_EQ(cost.ratio.low, 3.0);
  EXPECT_EQ(cost.ratio.high, 3.0);
}

}  // namespace
}  // namespace hyrax
