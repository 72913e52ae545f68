#include "tools/app/diff/trajectory_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/run_summary.h"
#include "tools/app/play/play.h"
#include "tools/files/scenario_changes.h"

namespace hyrax {
namespace {

// Those that the file holds.
RowBatches batches_of(const TrajectoryFile& file) {
  constexpr std::int64_t kRowsAtOnce = 65536;
  return [&file, first = std::int64_t{0}](Columns& batch) mutable {
    const std::int64_t from = std::exchange(first, std::min(first + kRowsAtOnce, file.row_count()));
    file.read_rows(from, first - from, batch);
  };
}

// A file's rows for a distance: all of them, or where neither it holds them nor the core gives them, those
// that it holds.
struct FileRows {
  const TrajectoryFile& file;
  std::optional<Core> core = {};  // That plays them.
  bool are_all = true;

  [[nodiscard]] TimedRun run() const {
    return {core ? played_rows(*core, file.head().scenario) : batches_of(file), file.inputs()};
  }
};
FileRows rows_of(const Core& own_core, const TrajectoryFile& file) {
  FileRows rows{file};
  if (file.holds_every_row()) return rows;
  const Scenario& scenario = file.head().scenario;
  std::optional<Core> core = with_parameters(own_core, scenario.parameters);
  rows.are_all = core && step_count(scenario) <= kRowsPlayedMax &&
                 hex(replay(*core, scenario).state_hash) == file.head().state_hash;
  if (rows.are_all) rows.core = std::move(core);
  return rows;
}

// @param by_rows the walls whose contacts are not those of the file.
std::vector<Contact> contacts_of(const FileRows& rows, std::uint8_t by_rows) {
  std::vector<Contact> contacts = rows.file.contacts();
  if (by_rows == 0) return contacts;
  std::erase_if(contacts, [&](const Contact& contact) { return touches(by_rows, contact.wall); });
  std::ranges::move(contacts_by_rows(rows.run(), rows.file.head().scenario, by_rows),
                    std::back_inserter(contacts));
  std::ranges::sort(contacts, {}, order_of);
  return contacts;
}

RunEnd end_of(const FileRows& rows) {
  RunEnd end{.is_rest_known = rows.are_all};
  std::optional<RestAnchor> anchor;
  for (RowCursor cursor(rows.run().rows); !cursor.is_done(); cursor.next()) {
    end.row = cursor.row();
    if (!anchor)
      anchor = {end.row.x_px, end.row.y_px, end.row.t_s};
    else if (anchor->moves_to(end.row.x_px, end.row.y_px))
      anchor->t_s = end.row.t_s;
  }
  if (end.is_rest_known) end.settled_since_s = anchor->at_rest_since_s(end.row.t_s);
  return end;
}

// Golden files of long runs hold the first row of each block, other files the rows that the scenario records.
bool hold_recorded_rows(const TrajectoryFile& a, const TrajectoryFile& b) {
  return !a.has("blocks") && !b.has("blocks");
}

// Why a file must be damaged, as a sentence: all rows and contacts are recorded and agree, but the state
// hashes or the numbers of contacts do not. Else empty.
std::string contradiction(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance,
                          const TrajectoryDiff& diff) {
  const Comparison& comparison = diff.comparison;
  if (comparison.first || !comparison.contacts.is_none()) return "";
  if (diff.contacts_total_a != diff.contacts_total_b && !comparison.contacts.is_cut)
    return "a file contradicts itself: the contacts agree, their numbers do not";
  if (tolerance.is_exact() && a.head().state_hash != b.head().state_hash &&
      diff.rows_compared == a.head().steps + 1)
    return "a file contradicts itself: all rows agree, the state hashes do not";
  return "";
}

std::string difference_in_shape(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance,
                                const TrajectoryDiff& diff, const std::optional<std::int64_t>& lone_step) {
  const std::string changes = scenario_changes(a.head().scenario, b.head().scenario);
  if (!changes.empty()) return "the scenarios differ: " + changes;
  if (a.head().steps != b.head().steps)
    return fmt::format("the numbers of steps differ: {} and {}", a.head().steps, b.head().steps);
  if (lone_step && hold_recorded_rows(a, b))
    return fmt::format("only one of the files holds row {}", *lone_step);
  if (const auto difference = input_difference(a.inputs(), b.inputs())) return "the " + *difference;
  return contradiction(a, b, tolerance, diff);
}

std::optional<DifferenceClass> class_of_files(const TrajectoryFile& a, const TrajectoryFile& b,
                                              const Tolerance& tolerance, const TrajectoryDiff& diff) {
  const Comparison& comparison = diff.comparison;
  if (!comparison.shape.empty()) return DifferenceClass::shape;
  if (diff.contacts_total_a != diff.contacts_total_b) return DifferenceClass::contacts;
  if (comparison.first || !comparison.contacts.is_none() ||
      (tolerance.is_exact() && a.head().state_hash != b.head().state_hash))
    return class_of(comparison.contacts, diff.values.distance());
  return std::nullopt;
}

}  // namespace

bool TrajectoryDiff::has_differences() const {
  return !comparison.agrees || !comparison.physics.empty() ||
         std::ranges::any_of(values.worst(), [](const auto& worst) { return worst.has_value(); });
}

TrajectoryDiff diff_trajectories(const Core& core, const TrajectoryFile& a, const TrajectoryFile& b,
                                 const Tolerance& tolerance, Overlay* overlay) {
  const FileRows rows_a = rows_of(core, a), rows_b = rows_of(core, b);
  const auto other_walls =
      static_cast<std::uint8_t>(rows_a.are_all && rows_b.are_all ? a.walls_of_rows() ^ b.walls_of_rows() : 0);
  TrajectoryDiff diff(tolerance, other_walls);
  if (a.head().constants && b.head().constants) diff.energy.emplace(a.head().constants->gravity_px_per_s2);
  Comparison& comparison = diff.comparison;
  const auto draw = [overlay](const Row& row_a, const Row& row_b) {
    if (overlay != nullptr) overlay->add(row_a, row_b);
  };
  RunDistance by_step;
  const auto measure = [&](const Row& row_a, const Row& row_b) {
    by_step.add(row_a, row_b);
    if (diff.energy) diff.energy->add(row_a, row_b);
    draw(row_a, row_b);
  };
  const bool are_played = rows_a.core || rows_b.core;
  const auto lone_step = walk_by_step(RowCursor(batches_of(a)), RowCursor(batches_of(b)),
                                      [&](const Row& row_a, const Row& row_b) {
                                        diff.values.compare(row_a, row_b);
                                        ++diff.rows_compared;
                                        if (!are_played) measure(row_a, row_b);
                                      });
  if (are_played) walk_by_step(RowCursor(rows_a.run().rows), RowCursor(rows_b.run().rows), measure);
  comparison.distance.largest = by_step.largest();
  if (by_step.has_other_dt()) {
    diff.energy.reset();
    if (overlay != nullptr) *overlay = Overlay();
    comparison.distance = walk_equal_times(rows_a.run(), rows_b.run(), draw);
  }
  comparison.distance.has_unknown_rows = !rows_a.are_all || !rows_b.are_all;
  const std::vector<Contact> contacts_a = contacts_of(rows_a, other_walls);
  const std::vector<Contact> contacts_b = contacts_of(rows_b, other_walls);
  diff.values.compare(contacts_a, contacts_b);
  comparison.first = diff.values.first();
  comparison.contacts = diff.values.contacts();
  comparison.expected_end = end_of(rows_a);
  comparison.actual_end = end_of(rows_b);
  diff.contacts_total_a = other_walls == 0 ? a.contacts_total() : std::ssize(contacts_a);
  diff.contacts_total_b = other_walls == 0 ? b.contacts_total() : std::ssize(contacts_b);
  comparison.shape = difference_in_shape(a, b, tolerance, diff, lone_step);
  if (a.head().physics != b.head().physics)
    comparison.physics = "the physics models differ: " + a.head().physics + " and " + b.head().physics;
  comparison.difference = class_of_files(a, b, tolerance, diff);
  comparison.agrees = !comparison.difference;
  return diff;
}

}  // namespace hyrax
