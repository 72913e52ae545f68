#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/compare/trajectory_comparer.h"
#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

struct DiffRequest {
  std::vector<std::string> files;
  Tolerance tolerance;
  Printing printing;
};

// The rows of a file, one after another, in batches.
class RowCursor {
 public:
  explicit RowCursor(const TrajectoryFile& file) : file_(file) { load(0); }
  [[nodiscard]] bool is_done() const { return at_ >= batch_.size(); }
  [[nodiscard]] Row row() const { return batch_.row(at_); }
  void next() {
    if (++at_ == batch_.size()) load(first_ + static_cast<std::int64_t>(batch_.size()));
  }

 private:
  static constexpr std::int64_t kBatch = 65536;
  void load(std::int64_t first) {
    first_ = first;
    at_ = 0;
    batch_ = file_.rows(first, std::min(kBatch, file_.row_count() - first));
  }

  const TrajectoryFile& file_;
  Columns batch_;
  std::int64_t first_ = 0;
  std::size_t at_ = 0;
};

struct Difference {
  Comparison comparison;
  TrajectoryComparer values;
  std::int64_t rows_compared = 0;
  std::optional<std::int64_t> lone_step;  // Of the first row that only one of the files holds.
};

// Compares rows of the same step; a step that one file does not record is skipped.
void compare_rows(const TrajectoryFile& a, const TrajectoryFile& b, Difference& difference) {
  RowCursor left(a);
  RowCursor right(b);
  while (!left.is_done() && !right.is_done()) {
    const Row row_a = left.row();
    const Row row_b = right.row();
    if (row_a.step == row_b.step) {
      difference.values.compare(row_a, row_b);
      ++difference.rows_compared;
    }
    if (row_a.step != row_b.step && !difference.lone_step)
      difference.lone_step = std::min(row_a.step, row_b.step);
    if (row_a.step <= row_b.step) left.next();
    if (row_b.step <= row_a.step) right.next();
  }
  if (difference.lone_step) return;
  if (!left.is_done()) difference.lone_step = left.row().step;
  if (!right.is_done()) difference.lone_step = right.row().step;
}

// Golden files of long runs hold the first row of each block, other files the rows that the scenario records.
bool hold_recorded_rows(const TrajectoryFile& a, const TrajectoryFile& b) {
  return !a.has("blocks") && !b.has("blocks");
}

std::string shape_of(const FileHead& a, const FileHead& b) {
  if (a.steps != b.steps) return fmt::format("the numbers of steps differ: {} and {}", a.steps, b.steps);
  if (!plays_the_same(a.scenario, b.scenario)) return "the scenarios differ";
  return "";
}

Difference compare(const TrajectoryFile& a, const TrajectoryFile& b, const Tolerance& tolerance) {
  Difference difference{{}, TrajectoryComparer(tolerance), 0, {}};
  Comparison& comparison = difference.comparison;
  compare_rows(a, b, difference);
  difference.values.compare(a.contacts(), b.contacts());
  comparison.first = difference.values.first();
  comparison.contacts = difference.values.contacts();
  comparison.largest = difference.values.distance().largest();
  comparison.shape = shape_of(a.head(), b.head());
  if (a.head().physics != b.head().physics)
    comparison.physics = "the physics models differ: " + a.head().physics + " and " + b.head().physics;
  if (comparison.shape.empty() && difference.lone_step && hold_recorded_rows(a, b))
    comparison.shape = fmt::format("only one of the files holds row {}", *difference.lone_step);
  if (!comparison.shape.empty())
    comparison.difference = DifferenceClass::shape;
  else if (a.contacts_total() != b.contacts_total())
    comparison.difference = DifferenceClass::contacts;
  else if (comparison.first || !comparison.contacts.is_none() ||
           (tolerance.is_exact() && a.head().state_hash != b.head().state_hash))
    comparison.difference = class_of(comparison.contacts, difference.values.distance());
  comparison.agrees = !comparison.difference;
  return difference;
}

std::string worst_text(std::string_view field, const WorstDifference& worst) {
  const auto ulps = ulps_of(field, worst.a, worst.b);
  const bool is_contact = field == kRowFields.back().name;
  const std::string distance =
      is_contact ? field_value_text(field, worst.a) + " and " + field_value_text(field, worst.b)
                 : fmt::format("{:.6g}", worst.abs());
  return fmt::format("  worst {:<8}{} at step {}{}\n", field, distance, worst.step,
                     ulps ? fmt::format(", {} ulp{}", *ulps, *ulps == 1 ? "" : "s") : "");
}

void print_difference(const Difference& difference, const TrajectoryFile& a, const TrajectoryFile& b,
                      const DiffRequest& request) {
  const Comparison& comparison = difference.comparison;
  const VerdictWord verdict{comparison.agrees ? "agree" : "DIFFER", comparison.agrees};
  print_text("{} and {}: {}, {} rows compared\n", request.files[0], request.files[1], verdict,
             difference.rows_compared);
  if (request.printing.is_quiet()) return;
  print_text("{}", difference_text(comparison, request.printing.is_verbose()));
  if (comparison.difference && comparison.shape.empty() && comparison.contacts.is_none() && !comparison.first)
    print_text("  hash       the state hashes differ: in rows that are not recorded in both\n");
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& worst = difference.values.worst()[field])
      print_text("{}", worst_text(kRowFields[field].name, *worst));
  if (!comparison.agrees || request.printing.is_verbose())
    print_text("{}", build_text(a.provenance(), b.provenance(), comparison.difference));
}

Json json_of(const Difference& difference) {
  const Comparison& comparison = difference.comparison;
  Json::Object worst;
  for (std::size_t field = 0; field < kRowFields.size(); ++field)
    if (const auto& value = difference.values.worst()[field]) {
      const auto ulps = ulps_of(kRowFields[field].name, value->a, value->b);
      worst.emplace_back(
          kRowFields[field].name,
          Json::Object{{"step", value->step}, {"abs", value->abs()}, {"ulps", ulps ? Json(*ulps) : Json()}});
    }
  const auto count = [](const auto& list) { return Json(static_cast<std::int64_t>(list.size())); };
  return Json::Object{{"agree", comparison.agrees},
                      {"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
                      {"first_divergence", divergence_json(comparison.first)},
                      {"worst", std::move(worst)},
                      {"contacts", Json::Object{{"moved", count(comparison.contacts.moved)},
                                                {"only_a", count(comparison.contacts.only_a)},
                                                {"only_b", count(comparison.contacts.only_b)}}}};
}

ExitCode diff(const DiffRequest& request) {
  const TrajectoryFile a = TrajectoryFile::open(request.files[0]);
  const TrajectoryFile b = TrajectoryFile::open(request.files[1]);
  const Difference difference = compare(a, b, request.tolerance);
  if (request.printing.is_json)
    print_text("{}\n", to_text(json_of(difference), {.depth_indented = 2}));
  else
    print_difference(difference, a, b, request);
  return difference.comparison.agrees ? ExitCode::agreed : ExitCode::disagreed;
}

}  // namespace

Command diff_command() {
  return {
      .name = "diff",
      .summary = "compare two trajectories: where they first differ, and by how much",
      .example =
          "hyrax-sim diff golden/flings/first-fling.h5 first-fling.h5\n"
          "  hyrax-sim diff a.h5 b.h5 --abs 1e-9",
      .is_common = true,
      .declare = [](Options& options) {
        const auto request = std::make_shared<DiffRequest>();
        options.files(request->files, {"A.h5 B.h5", "", "two trajectory files"}, 2, 2);
        options.number(request->tolerance.abs, {"--abs", "X", "absolute tolerance (px, px/s or s)"}, 0.0);
        options.number(request->tolerance.rel, {"--rel", "X", "tolerance relative to the larger value"}, 0.0);
        options.integer(request->tolerance.ulps, {"--ulps", "N", "tolerance in units in the last place"}, 0);
        options.printing(request->printing, "print all contacts that moved, and the build settings");
        return [request] { return diff(*request); };
      }};
}

}  // namespace hyrax
