// Packed rows, their blocks, and the state hash against the published vectors; the apex and the position at
// each second; the inputs of a frame, applied again.
#include "sim/trajectory/state_hash.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "sim/trajectory/input_playback.h"
#include "sim/trajectory/waypoints.h"
#include "tests/oracle/vectors.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

std::vector<Row> rows_of(const Json& entry) {
  std::vector<Row> rows;
  if (const Json* listed = entry.find("rows")) {
    for (const Json& row : *listed->get<Json::Array>())
      rows.push_back({.dt_s = exact(row, "dt"),
                      .x_px = exact(row, "x"),
                      .y_px = exact(row, "y"),
                      .vx_px_per_s = exact(row, "vx"),
                      .vy_px_per_s = exact(row, "vy"),
                      .contact = static_cast<std::uint8_t>(integer_of(row, "contact"))});
    return rows;
  }
  // Long vectors give a count only; this rule makes their rows.
  for (std::int64_t i = 0; i < integer_of(entry, "count"); ++i) {
    const auto at = static_cast<double>(i);
    rows.push_back({.dt_s = 1.0 / 64.0,
                    .x_px = at,
                    .y_px = at * 0.5,
                    .vx_px_per_s = 0.0 - at,
                    .vy_px_per_s = 1000.0 - at,
                    .contact = static_cast<std::uint8_t>(i % 32)});
  }
  return rows;
}

std::vector<Digest> block_digests(const std::vector<Row>& rows) {
  std::vector<Digest> digests;
  RowBlock block;
  for (const Row& row : rows) {
    block.append(row);
    if (block.room() > 0) continue;
    digests.push_back(digest(block));
    block.shrink(0);
  }
  if (block.size() > 0) digests.push_back(digest(block));
  return digests;
}

std::string state_hash(const std::vector<Row>& rows) {
  StateHash hash;
  for (const Digest& block : block_digests(rows)) hash.add(block);
  return hex(hash.value());
}

TEST(StateHash, AndTheBlockDigestsThatItIsMadeOfAreThePublishedOnes) {
  for (const Json& entry : vectors("state_hash")) {
    const std::vector<Row> rows = rows_of(entry);
    EXPECT_EQ(state_hash(rows), text_of(entry, "state_hash")) << text_of(entry, "name");
    const std::vector<Digest> digests = block_digests(rows);
    const Json::Array& published = *entry.find("block_digests")->get<Json::Array>();
    ASSERT_EQ(digests.size(), published.size()) << text_of(entry, "name");
    for (std::size_t block = 0; block < digests.size(); ++block)
      EXPECT_EQ(hex(digests[block]), *published[block].get<std::string>()) << text_of(entry, "name");
  }
}

TEST(RowBlock, GivesBackTheBitsOfItsRows) {
  RowBlock block;
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const Row row{0, 0.0, 0.1, -0.0, not_a_number, 5e-324, -1.7976931348623157e308, 31};
  block.append(row);
  EXPECT_TRUE(same_row(block.row(0), row));
}

TEST(FiniteState, ChecksEveryField) {
  EXPECT_TRUE(is_finite(State{}));
  for (double State::*const field : {&State::x_px, &State::y_px, &State::vx_px_per_s, &State::vy_px_per_s}) {
    State state;
    state.*field = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(is_finite(state));
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Waypoints waypoints_of(const std::vector<Row>& rows) {
  WaypointMeter meter(static_cast<std::int64_t>(rows.size()) - 1);
  for (const Row& row : rows) {
    Columns batch;
    batch.append(row);
    meter.rows(batch);
  }
  return meter.take();
}

// Frames of one dt; y by row.
std::vector<Row> run_of(double dt_s, const std::vector<double>& y_px) {
  std::vector<Row> rows;
  for (std::size_t step = 0; step < y_px.size(); ++step)
    rows.push_back({.step = static_cast<std::int64_t>(step),
                    .t_s = static_cast<double>(step) * dt_s,
                    .dt_s = step == 0 ? 0.0 : dt_s,
                    .y_px = y_px[step]});
  return rows;
}

std::vector<std::int64_t> steps_at_seconds(const Waypoints& waypoints) {
  std::vector<std::int64_t> steps;
  for (const Row& row : waypoints.at_seconds) steps.push_back(row.step);
  return steps;
}

TEST(Waypoints, TheApexIsTheFirstOfTheHighestRows) {
  EXPECT_EQ(waypoints_of(run_of(0.25, {5.0, 3.0, 4.0, 3.0, 9.0})).apex.step, 1);
  EXPECT_EQ(waypoints_of(run_of(0.25, {1.0, 3.0})).apex.step, 0);
  EXPECT_EQ(waypoints_of(run_of(0.25, {5.0})).apex.y_px, 5.0) << "a run of no frames";
  EXPECT_EQ(waypoints_of(run_of(0.25, {5.0, kNan, 4.0})).apex.step, 2) << "a NaN is none";
}

TEST(Waypoints, ARowIsShownUntilTheNext) {
  const auto steps_of = [](double dt_s, std::size_t rows) {
    return steps_at_seconds(waypoints_of(run_of(dt_s, std::vector<double>(rows))));
  };
  using Steps = std::vector<std::int64_t>;
  EXPECT_EQ(steps_of(0.25, 1), Steps());
  EXPECT_EQ(steps_of(0.25, 10), (Steps{4, 8}));
  EXPECT_EQ(steps_of(0.4, 7), (Steps{2, 5}));
  EXPECT_EQ(steps_of(2.5, 3), (Steps{0, 0, 1, 1, 2}));
  EXPECT_EQ(steps_of(0.5, 100).size(), 10u) << "they end after ten seconds";
}

TEST(Waypoints, ATimeMayBeOffByRounding) {
  std::vector<Row> rows = run_of(0.5, std::vector<double>(5));
  rows[2].t_s = std::nextafter(1.0, 2.0);
  rows[4].t_s = std::nextafter(2.0, 0.0);
  EXPECT_EQ(steps_at_seconds(waypoints_of(rows)), (std::vector<std::int64_t>{2, 4}));
  rows[2].t_s = 1.0 + 1e-6;
  rows[4].t_s = 2.0 - 1e-6;
  EXPECT_EQ(steps_at_seconds(waypoints_of(rows)), (std::vector<std::int64_t>{1}));
}

std::array<bool, 4> change_of(const std::vector<Action>& actions) {
  std::vector<Input> inputs;
  for (const Action& action : actions) inputs.push_back({.frame = 0, .action = action});
  Row row{};
  const InputChange change = InputPlayback(fling_at(60.0, 1), inputs).apply(row);
  return {change.ends_arc, change.grabs, change.sets_position, change.sets_velocity};
}

TEST(InputPlayback, ChangesInAFrameWhatAnyOfItsInputsChanges) {
  const Action actions[] = {Fling{{1.0, 2.0}},          Place{{3.0, 4.0}},  Stop{},
                            Resize{Size{900, 500}, {}}, Hitch{.dt_s = 0.1}, Grab{},
                            Release{{5.0, 6.0}}};
  for (const Action& first : actions)
    for (const Action& second : actions) {
      std::array<bool, 4> either = change_of({first});
      for (std::size_t each = 0; each < either.size(); ++each) either[each] |= change_of({second})[each];
      EXPECT_EQ(change_of({first, second}), either) << name_of(first) << ", " << name_of(second);
    }
}

}  // namespace
}  // namespace hyrax
