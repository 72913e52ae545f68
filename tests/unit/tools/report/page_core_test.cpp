// What the page's core gives the page, compiled for this system: every number at its place and under its
// name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/reference/exact_fling.h"
#include "sim/replay/fingerprint.h"
#include "sim/trace/listing_step.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/reference/test_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tools/report/wasm/scenario_record.h"
#include "tools/report/wasm/shown_run.h"

namespace hyrax {

// As tools/report/page/core.js calls them.
extern "C" {
double* input_room(std::int32_t count);
const double* output();
std::int32_t output_count();
const char* text();
std::int32_t text_length();
void fingerprint();
std::int32_t use_step(std::int32_t count);
void use_constants(std::int32_t count);
void measure_by(std::int32_t count);
void expect_rows(std::int32_t count);
void expect_blocks(std::int32_t count);
double load(std::int32_t count);
double play_to(double step);
void finish();
std::int32_t row_column(std::size_t index);
std::int32_t contact_column(std::size_t index);
std::int32_t error_column(std::size_t index);
std::int32_t contact_error_column(std::size_t index);
std::int32_t cause_column(std::size_t index);
void live_start();
void live_grab(std::int32_t x_px, std::int32_t y_px, double ticks);
void live_drag(std::int32_t x_px, std::int32_t y_px, double ticks);
void live_release(std::int32_t x_px, std::int32_t y_px, double ticks);
void live_velocity(double ticks);
void live_frame(double dt_s);
void live_scenario();
void flight(double rate_hz, double duration_s);
}

namespace {

using Numbers = std::vector<double>;
using NumbersByName = std::map<std::string, Numbers>;

std::int32_t give(const Numbers& numbers) {
  const auto count = static_cast<std::int32_t>(numbers.size());
  std::ranges::copy(numbers, input_room(count));
  return count;
}
Numbers given() { return {output(), output() + output_count()}; }
std::string given_text() { return {text(), static_cast<std::size_t>(text_length())}; }

NumbersByName columns(std::int32_t (*column)(std::size_t)) {
  NumbersByName all;
  for (std::size_t index = 0; column(index) != 0; ++index) all[given_text()] = given();
  return all;
}

template <class Record>
Numbers each(const std::vector<Record>& records, const auto& number) {
  Numbers numbers;
  for (const Record& record : records) numbers.push_back(static_cast<double>(std::invoke(number, record)));
  return numbers;
}

std::string fingerprint_in_page() {
  fingerprint();
  return given_text();
}

struct PlayedInPage {
  explicit PlayedInPage(const Scenario& scenario) {
    steps = load(give(record_of(scenario)));
    reached = play_to(steps);
    finish();
    came_to = given();
    hash = given_text();
  }
  double steps = 0.0, reached = 0.0;
  Numbers came_to;
  std::string hash;
};

// As hyrax-sim gives the step of a core of one's own.
bool plays_by(const Constants& constants) {
  const std::string step = step_text(canonical(listing_step(constants)));
  return use_step(give(Numbers(step.begin(), step.end()))) == 1;
}

TEST(PageCore, PlaysAndMeasuresByTheStepThatItIsGiven) {
  Constants moon = paper_constants();
  moon.gravity_px_per_s2 = 200.0;
  ASSERT_TRUE(plays_by(moon));
  EXPECT_EQ(fingerprint_in_page(), hex(fingerprint_of(listing_core(moon))));
  const Scenario scenario = fling_at(60.0, 300);
  measure_by(
      give({200.0, moon.restitution, moon.air_drag, moon.ground_friction, moon.rest_threshold_px_per_s}));
  const PlayedInPage measured(scenario);
  EXPECT_EQ(measured.hash, hex(replay(listing_core(moon), scenario).state_hash));
  EXPECT_LT(measured.came_to[7], 1e-9);  // Its step is that of these laws.
  measure_by(give({}));
  EXPECT_TRUE(std::isnan(PlayedInPage(scenario).came_to[7]));
  EXPECT_TRUE(columns(error_column).at("step").empty());
  // Other constants serve until there are none; then the step does again.
  use_constants(give({900.0, 0.5, 0.99, 0.75, 40.0}));
  EXPECT_EQ(fingerprint_in_page(), hex(fingerprint_of(listing_core({900.0, 0.5, 0.99, 0.75, 40.0}))));
  use_constants(give({}));
  // What is no step changes nothing.
  EXPECT_EQ(use_step(give({104.0, 121.0})), 0);
  EXPECT_EQ(fingerprint_in_page(), hex(fingerprint_of(listing_core(moon))));
  ASSERT_TRUE(plays_by(paper_constants()));
  EXPECT_EQ(fingerprint_in_page(), hex(fingerprint_of(shipped_core())));
  const Constants paper = paper_constants();
  measure_by(give({paper.gravity_px_per_s2, paper.restitution, paper.air_drag, paper.ground_friction,
                   paper.rest_threshold_px_per_s}));
}

TEST(PageCore, GivesWhatTheReplayAndTheReferenceGive) {
  Scenario scenario = fling_at(144.0, 700);
  scenario.start_velocity = {5000.0, -700.0};  // Each wall another number of times.
  const PlayedInPage played(scenario);
  TraceSink trace;
  const RunSummary summary = replay(shipped_core(), scenario, trace);
  Measured measured(true);
  measure(scenario, measured);
  const DriftSummary& errors = measured.summary;
  EXPECT_EQ(played.steps, 700.0);
  EXPECT_EQ(played.reached, 700.0);
  EXPECT_EQ(played.hash, hex(summary.state_hash));
  ASSERT_EQ(played.came_to.size(), 19u);
  for (const std::size_t none : {2u, 5u, 6u}) EXPECT_TRUE(std::isnan(played.came_to[none])) << none;
  EXPECT_EQ(Numbers(played.came_to.begin(), played.came_to.begin() + 2), (Numbers{700.0, 1.0}));
  EXPECT_EQ(Numbers(played.came_to.begin() + 7, played.came_to.end()),
            (Numbers{errors.implementation_px->value, errors.truncation_px->value, errors.model_px->value,
                     errors.energy_drift_rel_max->value, 1.0, 2.0, 0.0, 9.0, 1.0, 2.0, 0.0, 6.0}));
  NumbersByName rows{{"step", each(trace.rows(), &Row::step)},
                     {"contact", each(trace.rows(), &Row::contact)}};
  for (const RowColumn& column : kRowColumns)
    rows[std::string(column.name)] =
        each(trace.rows(), [&](const Row& row) { return column.number(row).value(); });
  EXPECT_EQ(columns(row_column), rows);
  const NumbersByName contacts = columns(contact_column);
  EXPECT_EQ(contacts.at("step"), each(trace.contacts(), &Contact::step));
  EXPECT_EQ(contacts.at("last_step"), each(trace.contacts(), &Contact::last_step));
  EXPECT_EQ(columns(error_column),
            (NumbersByName{{"step", each(measured.rows, &RowErrors::step)},
                           {"implementation", each(measured.rows, &RowErrors::implementation_px)},
                           {"truncation", each(measured.rows, &RowErrors::truncation_px)},
                           {"model", each(measured.rows, &RowErrors::model_px)}}));
  EXPECT_EQ(columns(contact_error_column).at("overshoot"),
            each(measured.contacts, &ImpactErrors::overshoot_px));
  const NumbersByName causes = columns(cause_column);
  EnergyCauseSum all(1200.0);
  for (const ArcErrors& arc : measured.arcs) all.add(arc.energy_parts);
  for (const ImpactErrors& contact : measured.contacts) all.add(contact);
  EXPECT_NEAR(causes.at("gravity").back(), all.now().gravity, 1e-9);
  EXPECT_NEAR(causes.at("drag").back(), all.now().drag, 1e-9);
  EXPECT_NEAR(causes.at("lift").back(), all.now().lift, 1e-9);
  EXPECT_NEAR(causes.at("bounce").back(), all.now().bounce, 1e-9);
  EXPECT_NEAR(causes.at("sum").back(),
              causes.at("gravity").back() + causes.at("drag").back() + causes.at("lift").back() +
                  causes.at("bounce").back(),
              1e-9);
  EXPECT_EQ(causes.at("step").front(), 0.0);
  EXPECT_EQ(causes.at("step").back(), double(trace.contacts().back().step));
  EXPECT_TRUE(std::ranges::is_sorted(causes.at("step")));
}

TEST(PageCore, HasTheCoresFingerprintAndPlaysARecordAsFarAsAsked) {
  EXPECT_EQ(fingerprint_in_page(), hex(fingerprint_of(shipped_core())));
  EXPECT_EQ(load(give({1.0})), -1.0) << "no record";
  const Scenario scenario = fling_at(60.0, 600);
  EXPECT_EQ(load(give(record_of(scenario))), 600.0);
  EXPECT_EQ(play_to(5.0), 5.0);
  EXPECT_EQ(play_to(1e9), 600.0);
  finish();
  TraceSink trace;
  EXPECT_EQ(given()[6], replay(shipped_core(), scenario, trace).at_rest_since_s.value());
}

TEST(PageCore, MeasuresTwoHundredThousandStepsAndDrawsAMillionRowsAndTenThousandContacts) {
  for (const std::int64_t steps : {200'000, 200'001})
    EXPECT_EQ(std::isnan(PlayedInPage(fling_at(60.0, steps)).came_to[7]), steps > 200'000) << steps;
  EXPECT_EQ(ShownRows(999'999).every(), 1);
  EXPECT_EQ(ShownRows(1'000'000).every(), 2);
  ShownRows shown(1);
  for (std::int64_t contact = 0; contact < 10'001; ++contact) {
    shown.contact_began({.step = contact});
    shown.contact_ended(contact, contact + 1);
  }
  EXPECT_EQ(shown.contacts().size(), 10'000u);
  EXPECT_EQ(shown.contacts().back().last_step, 10'000);
}

TEST(PageCore, FindsTheFirstRowOrBlockThatDiffersFromTheFiles) {
  const Scenario scenario = fling_at(60.0, 4200);
  TraceSink trace;
  static_cast<void>(replay(shipped_core(), scenario, trace));
  const auto difference = [&](std::size_t changed_row, std::size_t changed_block, std::size_t number = 3) {
    Numbers rows, digests;
    for (const std::size_t step : {0u, 7u, 4199u}) {
      const Row& row = trace.rows()[step];
      rows.insert(rows.end(), {double(row.step), row.t_s, row.dt_s, row.x_px, row.y_px, row.vx_px_per_s,
                               row.vy_px_per_s, double(row.contact)});
      if (step == changed_row) rows[rows.size() - 8 + number] += 1.0;
    }
    for (const TraceSink::BlockSeen& block : trace.blocks())
      for (const std::uint8_t byte : block.digest) digests.push_back(byte);
    if (changed_block < 2)
      digests[16 * changed_block + number] = 255.0 - digests[16 * changed_block + number];
    expect_rows(give(rows));
    expect_blocks(give(digests));
    const Numbers found = PlayedInPage(scenario).came_to;
    EXPECT_EQ(found[3], 3.0) << "rows compared";
    EXPECT_EQ(found[4], 1.0) << "all of the file was played";
    return found[2];
  };
  EXPECT_TRUE(std::isnan(difference(1, 2)));
  for (std::size_t number = 1; number < 8; ++number) EXPECT_EQ(difference(7, 2, number), 7.0) << number;
  for (const std::size_t byte : {0u, 15u}) EXPECT_EQ(difference(1, 1, byte), 4096.0) << byte;
  EXPECT_EQ(difference(4199, 1), 4199.0) << "a row says more than its block";
  EXPECT_EQ(difference(4199, 0), 0.0);
  expect_rows(give({4201.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(PlayedInPage(scenario).came_to[4], 0.0) << "a row beyond the run";
  expect_blocks(give(Numbers(3 * sizeof(Digest))));
  EXPECT_EQ(PlayedInPage(scenario).came_to[4], 0.0) << "a block beyond the run";
}

TEST(PageCore, AFlingByHandIsTheScenarioThatItHandsOut) {
  const Numbers start{300.0, 200.0, 30.0, 40.0, 1000.0, 800.0, 100.0, 50.0};
  static_cast<void>(give(start));
  live_start();
  live_frame(0.016);
  const State flown =
      shipped_core().step({300.0, 200.0, 30.0, 40.0}, 0.016, bounds_of({1000, 800}, {100, 50}));
  EXPECT_EQ(given(),
            (Numbers{0.016, flown.x_px, flown.y_px, flown.vx_px_per_s, flown.vy_px_per_s, 0.0, 1.0}));
  live_grab(310, 220, 1'000'000.0);
  live_drag(320, 210, 1'020'000.0);  // A frame has one place of the hand, its last.
  live_drag(350, 200, 1'050'000.0);
  live_velocity(1'050'000.0);
  EXPECT_EQ(given(), (Numbers{800.0, -400.0}));
  live_frame(0.05);
  live_release(390, 180, 1'100'000.0);
  EXPECT_EQ(given(), (Numbers{flown.x_px + 80.0, flown.y_px - 40.0, 800.0, -400.0}));
  live_frame(0.02);
  const double frames = given().back();
  live_scenario();
  const Numbers record = given();
  const std::string hash = given_text();
  EXPECT_EQ(frames, 3.0);
  EXPECT_EQ(scenario_of(record)->events,
            (std::vector<Event>{{std::int64_t{1}, Grab{}},
                                {std::int64_t{1}, Place{{flown.x_px + 40.0, flown.y_px - 20.0}}},
                                {std::int64_t{2}, Place{{flown.x_px + 80.0, flown.y_px - 40.0}}},
                                {std::int64_t{2}, Release{{800.0, -400.0}}}}));
  EXPECT_EQ(load(give(record)), 3.0);
  play_to(3.0);
  finish();
  EXPECT_EQ(given_text(), hash);
  static_cast<void>(give(start));
  live_start();
  live_grab(310, 220, 0.0);
  live_frame(0.016);  // A hand that rests gives no place.
  live_release(2310, 220, 1'000'000.0);
  EXPECT_EQ(given()[0], 900.0) << "let go past the edge";
  static_cast<void>(give(start));
  live_start();
  live_grab(310, 220, 0.0);
  live_frame(0.016);
  live_scenario();
  EXPECT_EQ(scenario_of(given())->events, (std::vector<Event>{{std::int64_t{0}, Grab{}}}));
}

TEST(PageCore, FliesAtADisplaysRateOrExactly) {
  const Numbers start{300.0, 500.0, 2400.0, -700.0, 1920.0, 1080.0, 128.0, 128.0};
  static_cast<void>(give(start));
  flight(50.0, 2.0);
  Numbers expected;
  TraceSink trace;
  static_cast<void>(replay(shipped_core(), fling_at(50.0, 100), trace));
  for (const Row& row : trace.rows()) expected.insert(expected.end(), {row.t_s, row.x_px, row.y_px});
  EXPECT_EQ(given(), expected);
  flight(0.0, 0.5);
  ExactFling exact;
  exact.start({300.0, 500.0, 2400.0, -700.0}, bounds_of(kDesktopWindow, kHyrax));
  const State end = exact.at(0.5);
  ASSERT_EQ(output_count(), 3 * 121);
  EXPECT_EQ(output()[360], 0.5);
  EXPECT_NEAR(output()[361], end.x_px, 1e-9);
  EXPECT_NEAR(output()[362], end.y_px, 1e-9);
  for (const Size& window : {Size{127, 1080}, Size{1920, 127}}) {
    static_cast<void>(
        give({0.0, 0.0, 0.0, 0.0, double(window.width_px), double(window.height_px), 128.0, 128.0}));
    flight(0.0, 0.5);
    EXPECT_EQ(output_count(), 0) << "no exact fling";
  }
}

}  // namespace
}  // namespace hyrax
