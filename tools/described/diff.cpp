#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/described/commands.h"
#include "tools/described/golden_run.h"
#include "tools/described/run_text.h"
#include "tools/described/trajectory_file.h"

namespace hyrax {
namespace {

struct DiffRequest {
  std::vector<std::string> files;
  Tolerance tolerance;
  Printing printing;
};

ComparedSide side_of(const DescribedFile& file) {
  return {file.rows(), jump_frames(file.head().scenario, file.head().steps), file.contacts()};
}

std::string difference_in_shape(const DescribedFile& a, const DescribedFile& b) {
  const std::string description = description_difference(a.head().description, b.head().description);
  if (!description.empty()) return "the descriptions differ: " + description;
  const std::string changes = scenario_changes(a.head().description, a.head().scenario, b.head().scenario);
  if (!changes.empty()) return "the scenarios differ: " + changes;
  if (a.head().steps != b.head().steps)
    return fmt::format("the numbers of steps differ: {} and {}", a.head().steps, b.head().steps);
  return "";
}

}  // namespace

DescribedComparison compare_files(const DescribedCore& core, const DescribedFile& a, const DescribedFile& b,
                                  const Tolerance& tolerance) {
  const std::string shape = difference_in_shape(a, b);
  const bool are_all_held = a.holds_every_row() && b.holds_every_row();
  const auto compare = [&](const ComparedSide& of_a, const ComparedSide& of_b) {
    return compare_common(a.head().description, of_a, b.head().description, of_b, tolerance);
  };
  DescribedComparison result = compare(side_of(a), side_of(b));
  bool are_known = are_all_held;
  if (!are_all_held) {  // Rows that a file does not hold are replayed.
    const auto all_of_a = all_rows_of(core, a), all_of_b = all_rows_of(core, b);
    are_known = all_of_a && all_of_b;
    if (are_known) {
      DescribedComparison of_all = compare(*all_of_a, *all_of_b);
      if (result.agrees() || !of_all.agrees()) result = std::move(of_all);
    }
  }
  result.distance.has_unknown_rows = !are_known;
  if (shape.empty() && result.agrees() && tolerance.is_exact() &&
      a.head().state_hash != b.head().state_hash) {
    result.difference = are_known ? DifferenceClass::shape : DifferenceClass::values;
    if (are_known) result.shape = "a file contradicts itself: all rows agree, the state hashes do not";
  }
  if (!shape.empty()) result.shape = shape;
  if (!result.shape.empty()) result.difference = DifferenceClass::shape;
  return result;
}

namespace {

Json diff_json(const DescribedComparison& comparison) {
  Json::Object worst;
  for (const DescribedWorst& each : comparison.worst)
    worst.emplace_back(each.value.name,
                       Json::Object{{"step", each.step}, {"abs", each.abs}, {"ulps", or_null(each.ulps)}});
  const ContactCounts& contacts = comparison.contacts;
  Json::Object document = comparison_json(comparison);
  document.insert(document.begin(), {"agree", comparison.agrees()});
  document.emplace_back("worst", std::move(worst));
  document.emplace_back(
      "contacts",
      Json::Object{{"moved", contacts.moved}, {"only_a", contacts.vanished}, {"only_b", contacts.appeared}});
  return document;
}

void print_diff(const DescribedComparison& comparison, const Printing& printing) {
  print_text("{}\n", VerdictWord{comparison.agrees() ? "agree" : "differ", comparison.agrees()});
  if (printing.is_quiet() || (comparison.agrees() && comparison.worst.empty())) return;
  print_text("{}", comparison_text(comparison));
  for (const DescribedWorst& worst : comparison.worst) {
    const std::string ulps = ulps_text(worst.ulps);
    print_text("  worst      {} {}{} at step {}{}\n", worst.value.name, rounded(worst.abs, 3),
               worst.value.unit.empty() ? "" : " " + worst.value.unit, worst.step,
               ulps.empty() ? "" : ", " + ulps);
  }
}

ExitCode diff(const DescribedCore& core, const DiffRequest& request) {
  const DescribedFile a = DescribedFile::open(request.files[0], core.description.core);
  const DescribedFile b = DescribedFile::open(request.files[1], core.description.core);
  const DescribedComparison comparison = compare_files(core, a, b, request.tolerance);
  if (request.printing.is_json)
    print_json(diff_json(comparison));
  else
    print_diff(comparison, request.printing);
  return comparison.agrees() ? ExitCode::agreed : ExitCode::disagreed;
}

void declare(Options& options, DiffRequest& request) {
  options.files(request.files, {"FILE.h5", "", "two trajectory files of this core"}, 2, 2);
  options.number(request.tolerance.abs, {"--abs", "X", "a value agrees within X of its unit"}, 0.0);
  options.number(request.tolerance.rel, {"--rel", "X", "a value agrees within X times the larger magnitude"},
                 0.0);
  options.integer(request.tolerance.ulps, {"--ulps", "N", "a value agrees within N ulps of its own type"}, 0);
  options.printing(request.printing);
}

}  // namespace

Command described_diff_command(const DescribedCore& core) {
  return {.name = "diff",
          .summary = "compare two trajectory files: first difference, largest distance, contacts moved",
          .example = "hyrax-sim diff golden/first.h5 first.h5",
          .is_common = true,
          .declare = with_request<DiffRequest>(
              declare, [&core](DiffRequest& request) { return diff(core, request); })};
}

}  // namespace hyrax
