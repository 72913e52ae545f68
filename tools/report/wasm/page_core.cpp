// What the page calls: plain functions over one run and one playground. Numbers pass as doubles (steps and
// ticks are exact), lists in the module's memory. tools/report/page/core.js is the only caller.
#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/core/traced_stepper.h"
#include "sim/reference/drift_columns.h"
#include "sim/reference/exact_fling.h"
#include "sim/replay/fingerprint.h"
#include "sim/trace/step_text.h"
#include "tools/hyrax/hand.h"
#include "tools/recorder/frame_player.h"
#include "tools/recorder/tape.h"
#include "tools/report/wasm/scenario_record.h"
#include "tools/report/wasm/shown_run.h"

#ifdef __wasm__
#define HYRAX_EXPORT(name) extern "C" [[clang::export_name(#name)]]
#else  // A unit test calls them.
#define HYRAX_EXPORT(name) extern "C"
#endif

namespace hyrax {
namespace {

constexpr std::int64_t kTicksPerSecond = 1'000'000;

constexpr ScreenPoint kOrigin{};  // The window's corner.

// The reader's own fling: a hand on the hyrax, frames of any length, and what a replay of them needs. Points
// are in px of the window.
struct Playground {
  Playground(const Core& core, const Keyframe& start) : player(core, start), tape(start) {}

  void apply(const Action& action) {
    player.apply(action);
    tape.add_input(action);
  }
  // One `place` a frame, however often the hand moved.
  void follow_hand() {
    if (!hold) return;
    if (const auto corner = hold->follow(kOrigin)) apply(Place{*corner});
  }

  FramePlayer player;
  Tape tape;
  std::optional<Hold> hold;
};

struct Page {
  std::vector<double> input;   // Written by the page.
  std::vector<double> output;  // Read by it.
  std::string text;
  Core own = shipped_core();  // Or that of the step that the page carries.
  Core core = own;            // What all is played by: it, or its step with other constants.
  std::optional<Model> model = Model();
  FileEvidence evidence;
  std::unique_ptr<ShownRun> run;
  std::optional<Playground> playground;
};

// Never destroyed: its buffers go back to lists of the thread, which end before it would.
Page& page() {
  static Page& only = *new Page;
  return only;
}

std::span<const double> input(std::int32_t count) {
  return std::span<const double>(page().input).first(static_cast<std::size_t>(count));
}

template <class Value>
void output_column(const std::vector<Value>& values) {
  page().output.assign(values.begin(), values.end());
}

double or_nan(const auto& value) { return value ? static_cast<double>(*value) : std::nan(""); }

// Column `index` of the records, with its name as text; false after the last.
template <class Record>
bool output_described(const auto& described, const std::vector<Record>& records, std::size_t index) {
  if (index == std::size(described)) return false;
  page().text = described[index].name;
  page().output.clear();
  for (const Record& record : records) page().output.push_back(or_nan(described[index].number(record)));
  return true;
}

double or_nan(const std::optional<Worst>& worst) { return worst ? worst->value : std::nan(""); }

// As the page gives it: x, y, vx, vy, window, sprite.
World start_in_input() {
  const auto n = input(8);
  const auto size = [&](std::size_t at) {
    return Size{static_cast<std::int32_t>(n[at]), static_cast<std::int32_t>(n[at + 1])};
  };
  return {{n[0], n[1], n[2], n[3]}, size(4), size(6)};
}

// Of five numbers; nothing of none.
std::optional<Constants> constants_in_input(std::int32_t count) {
  const auto n = input(count);
  return n.empty() ? std::nullopt : std::optional(Constants{n[0], n[1], n[2], n[3], n[4]});
}

constexpr ColumnOf<RowErrors> kErrorColumns[] = {
    {"step", "", "row", &RowErrors::step}, kDriftRowColumns[0], kDriftRowColumns[1], kDriftRowColumns[2]};

using CausePoint = ShownDrift::CausePoint;
constexpr ColumnOf<CausePoint> kCauseColumns[] = {
    {"step", "", "row", &CausePoint::step},
    {"gravity", "px", "", [](const CausePoint& point) { return point.causes.gravity; }},
    {"drag", "px", "", [](const CausePoint& point) { return point.causes.drag; }},
    {"lift", "px", "", [](const CausePoint& point) { return point.causes.lift; }},
    {"bounce", "px", "", [](const CausePoint& point) { return point.causes.bounce; }},
    {"sum", "px", "", [](const CausePoint& point) { return point.causes.sum(); }}};

}  // namespace

/// Room for `count` numbers, which the page writes before the call that takes them.
HYRAX_EXPORT(input_room) double* input_room(std::int32_t count) {
  page().input.resize(static_cast<std::size_t>(count));
  return page().input.data();
}
HYRAX_EXPORT(output) const double* output() { return page().output.data(); }
HYRAX_EXPORT(output_count) std::int32_t output_count() {
  return static_cast<std::int32_t>(page().output.size());
}
HYRAX_EXPORT(text) const char* text() { return page().text.data(); }
HYRAX_EXPORT(text_length) std::int32_t text_length() { return static_cast<std::int32_t>(page().text.size()); }

/// fingerprint_of the core as text.
HYRAX_EXPORT(fingerprint) void fingerprint() { page().text = hex(fingerprint_of(page().core)); }
/// From now on the core is that of the step's text, whose bytes are in the input. 0: it cannot be played.
HYRAX_EXPORT(use_step) std::int32_t use_step(std::int32_t count) {
  std::string text;
  for (const double byte : input(count)) text += static_cast<char>(byte);
  const std::optional<TracedStep> step = read_own_step(text);
  std::optional<Core> core = step ? traced_core(*step) : std::nullopt;
  if (core) page().core = page().own = *std::move(core);
  return core ? 1 : 0;
}
/// From now on all is played by the paper's step with the five constants in the input; of none, by the core.
HYRAX_EXPORT(use_constants) void use_constants(std::int32_t count) {
  const std::optional<Constants> constants = constants_in_input(count);
  page().core = constants ? listing_core(*constants) : page().own;
}
/// Runs are measured by the model of the five constants in the input, or, of none, not at all.
HYRAX_EXPORT(measure_by) void measure_by(std::int32_t count) {
  const std::optional<Constants> constants = constants_in_input(count);
  page().model = constants ? std::optional(Model(*constants)) : std::nullopt;
}

/// The file's rows: step, t, dt, x, y, vx, vy, contact of each.
HYRAX_EXPORT(expect_rows) void expect_rows(std::int32_t count) {
  const auto numbers = input(count);
  Columns& rows = page().evidence.rows;
  rows.clear();
  for (std::size_t at = 0; at + kRowColumns.size() + 2 <= numbers.size();) {
    rows.step.push_back(static_cast<std::int64_t>(numbers[at++]));
    for (const RowColumn& column : kRowColumns) (rows.*column.also).push_back(numbers[at++]);
    rows.contact.push_back(static_cast<std::uint8_t>(numbers[at++]));
  }
}
/// The file's block digests: 16 numbers 0 .. 255 of each.
HYRAX_EXPORT(expect_blocks) void expect_blocks(std::int32_t count) {
  const auto numbers = input(count);
  page().evidence.blocks.clear();
  for (std::size_t at = 0; at + sizeof(Digest) <= numbers.size(); at += sizeof(Digest)) {
    Digest& digest = page().evidence.blocks.emplace_back();
    for (std::size_t byte = 0; byte < digest.size(); ++byte)
      digest[byte] = static_cast<std::uint8_t>(numbers[at + byte]);
  }
}
/// Begins a run of the scenario in the input: its number of steps, or -1 for a record that is none.
HYRAX_EXPORT(load) double load(std::int32_t count) {
  const auto scenario = scenario_of(input(count));
  if (!scenario) return -1.0;
  page().run =
      std::make_unique<ShownRun>(page().core, *scenario, page().model, std::exchange(page().evidence, {}));
  return static_cast<double>(page().run->replay.steps());
}
HYRAX_EXPORT(play_to) double play_to(double step) {
  return static_cast<double>(page().run->play_to(static_cast<std::int64_t>(step)));
}
HYRAX_EXPORT(finish) void finish() {
  ShownRun& run = *page().run;
  run.finish();
  page().text = hex(run.summary.state_hash);
  page().output = {static_cast<double>(run.summary.steps), static_cast<double>(run.shown.every()),
                   or_nan(run.check.first_difference()),   static_cast<double>(run.check.rows_compared()),
                   run.check.is_complete() ? 1.0 : 0.0,    or_nan(run.summary.non_finite_step),
                   or_nan(run.summary.at_rest_since_s),    or_nan(run.errors.implementation_px),
                   or_nan(run.errors.truncation_px),       or_nan(run.errors.model_px),
                   or_nan(run.errors.energy_drift_rel_max)};
  for (const WallCounts* const counts : {&run.summary.contacts, &run.summary.bounces})
    for (const Wall wall : kWalls) page().output.push_back(static_cast<double>((*counts)[wall]));
}

/// Column `index` of what is drawn: rows, contacts, errors of rows and of contacts, and causes of energy
/// drift up to a step, in px of height. Its name is the text; 0 after the last. NaN: no value.
HYRAX_EXPORT(row_column) std::int32_t row_column(std::size_t index) {
  const Columns& rows = page().run->shown.columns();
  if (index > kRowColumns.size() + 1) return 0;
  const bool is_step = index == 0, is_number = index <= kRowColumns.size();
  page().text = is_step ? "step" : is_number ? kRowColumns[index - 1].name : "contact";
  if (is_step)
    output_column(rows.step);
  else if (is_number)
    output_column(rows.*kRowColumns[index - 1].also);
  else
    output_column(rows.contact);
  return 1;
}
HYRAX_EXPORT(contact_column) std::int32_t contact_column(std::size_t index) {
  return output_described(kContactColumns, page().run->shown.contacts(), index);
}
HYRAX_EXPORT(error_column) std::int32_t error_column(std::size_t index) {
  return output_described(kErrorColumns, page().run->drift.rows, index);
}
HYRAX_EXPORT(contact_error_column) std::int32_t contact_error_column(std::size_t index) {
  return output_described(kImpactColumns, page().run->drift.contacts, index);
}
HYRAX_EXPORT(cause_column) std::int32_t cause_column(std::size_t index) {
  return output_described(kCauseColumns, page().run->drift.causes, index);
}

/// A playground that begins with the start in the input.
HYRAX_EXPORT(live_start) void live_start() {
  const World given = start_in_input();
  Keyframe start;
  set_state(start.row, given.state);
  start.window = given.window;
  start.sprite = given.sprite;
  page().playground.emplace(page().core, start);
}
/// REQUIRES: not held; ticks of a clock that does not go backwards.
HYRAX_EXPORT(live_grab) void live_grab(std::int32_t x_px, std::int32_t y_px, double ticks) {
  Playground& playground = *page().playground;
  assert(!playground.hold);
  playground.apply(Grab{});
  const Row& row = playground.player.now().row;
  playground.hold.emplace(kTicksPerSecond, ScreenPoint{x_px, y_px}, static_cast<std::int64_t>(ticks),
                          Position{row.x_px, row.y_px}, kOrigin);
}
/// REQUIRES: held.
HYRAX_EXPORT(live_drag) void live_drag(std::int32_t x_px, std::int32_t y_px, double ticks) {
  page().playground->hold->move({x_px, y_px}, static_cast<std::int64_t>(ticks));
}
/// It flies with the hand's velocity. The output is the state that it flies from: x, y, vx, vy. REQUIRES:
/// held.
HYRAX_EXPORT(live_release) void live_release(std::int32_t x_px, std::int32_t y_px, double ticks) {
  Playground& playground = *page().playground;
  live_drag(x_px, y_px, ticks);
  playground.follow_hand();
  const Keyframe& now = playground.player.now();
  const Position at{now.row.x_px, now.row.y_px};
  const Position corner = inside(at, now.window, now.sprite);
  if (corner != at) playground.apply(Place{corner});
  playground.apply(Release{playground.hold->velocity(static_cast<std::int64_t>(ticks))});
  playground.hold.reset();
  const Row& row = playground.player.now().row;
  page().output = {row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s};
}
/// The hand's velocity, vx and vy. REQUIRES: held.
HYRAX_EXPORT(live_velocity) void live_velocity(double ticks) {
  const Velocity hand = page().playground->hold->velocity(static_cast<std::int64_t>(ticks));
  page().output = {hand.vx_px_per_s, hand.vy_px_per_s};
}
/// Plays a frame of 0 .. kFrameMax_s; then the output is t, x, y, vx, vy, contact, frames.
HYRAX_EXPORT(live_frame) void live_frame(double dt_s) {
  Playground& playground = *page().playground;
  playground.follow_hand();
  playground.player.advance(dt_s);
  const Row& row = playground.player.now().row;
  playground.tape.add_frame(row);
  page().output = {row.t_s,
                   row.x_px,
                   row.y_px,
                   row.vx_px_per_s,
                   row.vy_px_per_s,
                   double(row.contact),
                   static_cast<double>(playground.tape.frames())};
}
/// The scenario of what happened as a record, and its state hash as text. REQUIRES: a frame was played.
HYRAX_EXPORT(live_scenario) void live_scenario() {
  const Scenario scenario = page().playground->tape.scenario("fling");
  page().output = record_of(scenario);
  page().text = *scenario.expect->state_hash;
}
/// Another flight from the start in the input: at a display rate, or, of rate 0, the exact fling. The output
/// is t, x, y of each row.
HYRAX_EXPORT(flight) void flight(double rate_hz, double duration_s) {
  constexpr double kExactRowsPerSecond = 240.0;
  const World start = start_in_input();
  std::vector<double>& rows = page().output;
  rows.clear();
  if (rate_hz > 0.0) {
    const auto frames = static_cast<std::int64_t>(rate_hz * duration_s);
    ShownRows shown(frames);
    static_cast<void>(
        replay(page().core, scenario_from(start.state, start.window, start.sprite, rate_hz, frames), shown));
    const Columns& columns = shown.columns();
    for (std::size_t row = 0; row < columns.size(); ++row)
      rows.insert(rows.end(), {columns.t_s[row], columns.x_px[row], columns.y_px[row]});
    return;
  }
  const Bounds bounds = start.bounds();
  if (!page().model || bounds.right_px < 0.0 || bounds.bottom_px < 0.0) return;  // There is none.
  ExactFling fling{FixedLaws(*page().model)};
  fling.start(start.state, bounds);
  for (double row = 0.0; row <= kExactRowsPerSecond * duration_s; ++row) {
    const State state = fling.at(row / kExactRowsPerSecond);
    rows.insert(rows.end(), {row / kExactRowsPerSecond, state.x_px, state.y_px});
  }
}

}  // namespace hyrax
