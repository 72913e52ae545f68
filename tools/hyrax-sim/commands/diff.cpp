#include <fmt/format.h>

#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/hyrax-sim/runs/file_difference.h"

namespace hyrax {
namespace {

struct DiffRequest {
  std::vector<std::string> files;
  Tolerance tolerance;
  Printing printing;
};

std::string worst_text(std::string_view field, const WorstDifference& worst) {
  const auto ulps = ulps_of(field, worst.a, worst.b);
  const bool is_contact = field == kRowFields.back().name;
  const std::string distance =
      is_contact ? field_value_text(field, worst.a) + " and " + field_value_text(field, worst.b)
                 : fmt::format("{:.6g}", worst.abs());
  return fmt::format("  worst {:<8}{} at step {}{}\n", field, distance, worst.step,
                     ulps ? fmt::format(", {} ulp{}", *ulps, *ulps == 1 ? "" : "s") : "");
}

void print_difference(const FileDifference& difference, const TrajectoryFile& a, const TrajectoryFile& b,
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

Json json_of(const FileDifference& difference) {
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
  const FileDifference difference = compare_files(a, b, request.tolerance);
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
