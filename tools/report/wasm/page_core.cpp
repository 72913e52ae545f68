// What the page calls: plain functions over one run and one playground. Numbers pass as doubles (steps and
// ticks are exact), lists in the module's memory. tools/report/page/core.js is the only caller.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sim/replay/fingerprint.h"
#include "tools/report/wasm/playground.h"
#include "tools/report/wasm/scenario_record.h"
#include "tools/report/wasm/shown_run.h"

#define HYRAX_EXPORT(name) extern "C" [[clang::export_name(#name)]]

namespace hyrax {
namespace {

struct Page {
  std::vector<double> input;   // Written by the page.
  std::vector<double> output;  // Read by it.
  std::string text;
  FileEvidence evidence;
  std::unique_ptr<ShownRun> run;
  std::optional<Playground> playground;
};

Page& page() {
  static Page only;
  return only;
}

std::span<const double> input(std::int32_t count) {
  return std::span<const double>(page().input).first(static_cast<std::size_t>(count));
}

template <class Value>
void output_column(const std::vector<Value>& values) {
  page().output.assign(values.begin(), values.end());
}

template <class Record, class Get>
void output_each(const std::vector<Record>& records, const Get& get) {
  page().output.clear();
  for (const Record& record : records) page().output.push_back(static_cast<double>(get(record)));
}

double or_nan(const auto& value) { return value ? static_cast<double>(*value) : std::nan(""); }

constexpr std::size_t kEvidenceNumbers = 8;

Row row_in(std::span<const double> n) {
  return {.step = static_cast<std::int64_t>(n[0]),
          .t_s = n[1],
          .dt_s = n[2],
          .x_px = n[3],
          .y_px = n[4],
          .vx_px_per_s = n[5],
          .vy_px_per_s = n[6],
          .contact = static_cast<std::uint8_t>(n[7])};
}

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

/// core_fingerprint as text.
HYRAX_EXPORT(fingerprint) void fingerprint() { page().text = hex(core_fingerprint()); }

/// The file's rows: step, t, dt, x, y, vx, vy, contact of each.
HYRAX_EXPORT(expect_rows) void expect_rows(std::int32_t count) {
  const auto numbers = input(count);
  page().evidence.rows.clear();
  for (std::size_t at = 0; at + kEvidenceNumbers <= numbers.size(); at += kEvidenceNumbers)
    page().evidence.rows.append(row_in(numbers.subspan(at, kEvidenceNumbers)));
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
  page().run = std::make_unique<ShownRun>(*scenario, std::exchange(page().evidence, {}));
  return static_cast<double>(page().run->steps());
}
HYRAX_EXPORT(play_to) double play_to(double step) {
  return static_cast<double>(page().run->play_to(static_cast<std::int64_t>(step)));
}
HYRAX_EXPORT(finish) void finish() {
  ShownRun& run = *page().run;
  run.finish();
  const RunSummary& summary = run.summary();
  const EvidenceCheck& check = run.check();
  page().text = hex(summary.state_hash);
  page().output = {static_cast<double>(summary.steps), static_cast<double>(run.shown().every()),
                   or_nan(check.first_difference()),   static_cast<double>(check.rows_compared()),
                   check.is_complete() ? 1.0 : 0.0,    static_cast<double>(summary.contacts.total()),
                   or_nan(summary.non_finite_step)};
}

/// A column of the rows that are drawn, by the order of the format's table: step, t, dt, x, y, vx, vy,
/// contact.
HYRAX_EXPORT(row_column) void row_column(std::int32_t column) {
  const Columns& rows = page().run->shown().columns();
  const std::array doubles = {&rows.t_s,  &rows.dt_s,        &rows.x_px,
                              &rows.y_px, &rows.vx_px_per_s, &rows.vy_px_per_s};
  if (column == 0) return output_column(rows.step);
  if (column == 7) return output_column(rows.contact);
  output_column(*doubles.at(static_cast<std::size_t>(column - 1)));
}
/// step, last_step, wall, t, x, y, vx before, vy before, vx after, vy after, overshoot.
HYRAX_EXPORT(contact_column) void contact_column(std::int32_t column) {
  const std::vector<Contact>& contacts = page().run->shown().contacts();
  constexpr std::array kNumbers = {&Contact::t_s,
                                   &Contact::x_px,
                                   &Contact::y_px,
                                   &Contact::vx_before_px_per_s,
                                   &Contact::vy_before_px_per_s,
                                   &Contact::vx_after_px_per_s,
                                   &Contact::vy_after_px_per_s,
                                   &Contact::overshoot_px};
  if (column == 0) return output_each(contacts, [](const Contact& c) { return c.step; });
  if (column == 1) return output_each(contacts, [](const Contact& c) { return c.last_step; });
  if (column == 2) return output_each(contacts, [](const Contact& c) { return static_cast<int>(c.wall); });
  output_each(contacts, [member = kNumbers.at(static_cast<std::size_t>(column - 3))](const Contact& c) {
    return c.*member;
  });
}
/// step, implementation, truncation, model error, energy of the matched ODE, energy drift.
HYRAX_EXPORT(error_column) void error_column(std::int32_t column) {
  const std::vector<RowErrors>& rows = page().run->drift().rows();
  constexpr std::array kNumbers = {&RowErrors::implementation_px, &RowErrors::truncation_px,
                                   &RowErrors::model_px, &RowErrors::energy_px2_per_s2,
                                   &RowErrors::energy_drift_px2_per_s2};
  if (column == 0) return output_each(rows, [](const RowErrors& row) { return row.step; });
  output_each(rows, [member = kNumbers.at(static_cast<std::size_t>(column - 1))](const RowErrors& row) {
    return row.*member;
  });
}

/// step, wall, time error in s, overshoot in px, effective restitution, relative jump of energy; NaN: none.
HYRAX_EXPORT(contact_error_column) void contact_error_column(std::int32_t column) {
  const std::vector<ImpactErrors>& contacts = page().run->drift().contacts();
  output_each(contacts, [column](const ImpactErrors& c) {
    const std::array numbers = {static_cast<double>(c.step),     static_cast<double>(c.wall),
                                or_nan(c.time_error_s),          c.overshoot_px,
                                or_nan(c.effective_restitution), c.energy_jump_rel};
    return numbers.at(static_cast<std::size_t>(column));
  });
}
/// step, and the causes of energy drift up to it: gravity, drag, lift, bounce, their sum, in px of height.
HYRAX_EXPORT(cause_column) void cause_column(std::int32_t column) {
  output_each(page().run->drift().causes(), [column](const ShownDrift::CausePoint& point) {
    const EnergyCauses& c = point.causes;
    const std::array numbers = {
        static_cast<double>(point.step), c.gravity, c.drag, c.lift, c.bounce, c.sum()};
    return numbers.at(static_cast<std::size_t>(column));
  });
}

/// A playground that begins with the state in the input: x, y, vx, vy, window, sprite.
HYRAX_EXPORT(live_start) void live_start() {
  const auto n = input(8);
  Keyframe start;
  set_state(start.row, {n[0], n[1], n[2], n[3]});
  start.window = {static_cast<std::int32_t>(n[4]), static_cast<std::int32_t>(n[5])};
  start.sprite = {static_cast<std::int32_t>(n[6]), static_cast<std::int32_t>(n[7])};
  page().playground.emplace(start);
}
HYRAX_EXPORT(live_grab) void live_grab(std::int32_t x_px, std::int32_t y_px, double ticks) {
  page().playground->grab({x_px, y_px}, static_cast<std::int64_t>(ticks));
}
HYRAX_EXPORT(live_drag) void live_drag(std::int32_t x_px, std::int32_t y_px, double ticks) {
  page().playground->drag({x_px, y_px}, static_cast<std::int64_t>(ticks));
}
HYRAX_EXPORT(live_release) void live_release(std::int32_t x_px, std::int32_t y_px, double ticks) {
  page().playground->release({x_px, y_px}, static_cast<std::int64_t>(ticks));
}
/// Plays a frame; then the output is t, x, y, vx, vy, contact, frames.
HYRAX_EXPORT(live_frame) void live_frame(double dt_s) {
  Playground& playground = *page().playground;
  playground.frame(dt_s);
  const Row& row = playground.now().row;
  page().output = {row.t_s,
                   row.x_px,
                   row.y_px,
                   row.vx_px_per_s,
                   row.vy_px_per_s,
                   double(row.contact),
                   static_cast<double>(playground.tape().frames())};
}
/// The scenario of what happened as a record, and its state hash as text. REQUIRES: a frame was played.
HYRAX_EXPORT(live_scenario) void live_scenario() {
  const Scenario scenario = page().playground->tape().scenario("fling");
  page().output = record_of(scenario);
  page().text = *scenario.expect->state_hash;
}

}  // namespace hyrax
