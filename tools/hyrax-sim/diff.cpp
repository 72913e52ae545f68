#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "tools/app/command_line/options.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/app/diff/trajectory_diff.h"
#include "tools/report/figure_svg.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

struct DiffRequest {
  std::vector<std::string> files;
  Tolerance tolerance;
  std::string figure;
  Printing printing;
};

void print_difference(const TrajectoryDiff& diff, const TrajectoryFile& a, const TrajectoryFile& b,
                      const DiffRequest& request) {
  const Comparison& comparison = diff.comparison;
  const VerdictWord verdict{comparison.agrees ? "agree" : "DIFFER", comparison.agrees};
  const bool has_others = comparison.agrees && diff.rows_compared <= a.head().steps;
  print_text("{} and {}: {}, {} rows compared{}\n", request.files[0], request.files[1], verdict,
             diff.rows_compared,
             !has_others                    ? ""
             : request.tolerance.is_exact() ? ", the others by the state hashes in the files"
                                            : ", the others not: a file does not hold them");
  if (!request.printing.is_quiet())
    print_text("{}", diff_text(diff, a.provenance(), b.provenance(), request.printing.is_verbose()));
}

// The ends of two paths, as long as it takes to distinguish them: a figure is shown on other machines, too.
std::array<std::string, 2> short_names(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::filesystem::path rest_a = a.lexically_normal(), rest_b = b.lexically_normal();
  std::filesystem::path name_a, name_b;
  do {
    name_a = name_a.empty() ? rest_a.filename() : rest_a.filename() / name_a;
    name_b = name_b.empty() ? rest_b.filename() : rest_b.filename() / name_b;
    rest_a = rest_a.parent_path(), rest_b = rest_b.parent_path();
  } while (name_a == name_b && (rest_a.has_filename() || rest_b.has_filename()));
  return {name_a.generic_string(), name_b.generic_string()};
}

void draw(const DiffRequest& request, const TrajectoryDiff& diff, const Overlay& overlay,
          const Scenario& scenario) {
  const Comparison& comparison = diff.comparison;
  const std::string difference =
      comparison.difference ? fmt::format("class {}, ", name_of(*comparison.difference)) : "";
  const auto [name_a, name_b] = short_names(request.files[0], request.files[1]);
  const Figure figure = overlay.figure({.title = distance_text(comparison.distance),
                                        .subtitle = difference + contacts_text(comparison.contacts.counts()),
                                        .a = name_a,
                                        .b = name_b,
                                        .window = scenario.window,
                                        .sprite = scenario.sprite});
  draw_figure(request.figure, figure);
}

ExitCode diff(const Core& core, const DiffRequest& request) {
  if (!request.figure.empty())
    OutputGuard(request.files).admit("hyrax-sim diff: --figure", request.figure, {".svg"});
  const TrajectoryFile a = TrajectoryFile::open(request.files[0]);
  const TrajectoryFile b = TrajectoryFile::open(request.files[1]);
  Overlay overlay;
  const TrajectoryDiff difference =
      diff_trajectories(core, a, b, request.tolerance, request.figure.empty() ? nullptr : &overlay);
  if (request.printing.is_json)
    print_json(diff_json(difference));
  else
    print_difference(difference, a, b, request);
  if (!request.figure.empty()) {
    draw(request, difference, overlay, a.head().scenario);
    if (!request.printing.is_json) print_text("  figure     {}\n", request.figure);
  }
  return difference.comparison.agrees ? ExitCode::agreed : ExitCode::disagreed;
}

void declare(Options& options, DiffRequest& request) {
  options.files(request.files, {"A.h5 B.h5", "", "two trajectory files"}, 2, 2);
  options.number(request.tolerance.abs, {"--abs", "X", "absolute tolerance (px, px/s or s)"}, 0.0);
  options.number(request.tolerance.rel, {"--rel", "X", "tolerance relative to the larger value"}, 0.0);
  options.integer(request.tolerance.ulps, {"--ulps", "N", "tolerance in units in the last place"}, 0);
  options.text(request.figure, {"--figure", "FILE.svg", "draw both paths, and their distance over time"});
  options.printing(request.printing, "print all contacts that moved, and the build settings");
}

}  // namespace

Command diff_command() {
  return {.name = "diff",
          .summary = "compare two trajectories: how far apart, which contacts moved, where they first differ",
          .example =
              "hyrax-sim diff golden/flings/first-fling.h5 first-fling.h5\n"
              "  hyrax-sim diff a.h5 b.h5 --abs 1e-9\n"
              "  hyrax-sim diff a.h5 b.h5 --figure diff.svg",
          .is_common = true,
          .declare = with_request<DiffRequest>(declare, diff)};
}

}  // namespace hyrax
