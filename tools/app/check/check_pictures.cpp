#include "tools/app/check/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/compare/overlay.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/temporary_folder.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"

namespace hyrax {
namespace {

std::string stem_of(const std::string& path) {
  return std::filesystem::path(path).replace_extension().string();
}

std::string file_name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string svg_path(const std::string& path, std::size_t group) {
  return fmt::format("{}-{}.svg", stem_of(path), group + 1);
}

std::string html_path(const std::string& path) { return stem_of(path) + ".html"; }

// The worst scenario of which both runs keep every row; nullptr: long runs keep none, nor does a golden file
// of which the summary alone was changed.
const PairVerdict* drawable(const DifferenceGroup& group) {
  const auto found = std::ranges::find_if(group.scenarios, [](const PairVerdict* scenario) {
    return scenario->runs && scenario->runs->golden.rows.size() > 0 && scenario->runs->fresh.rows.size() > 0;
  });
  return found == group.scenarios.end() ? nullptr : *found;
}

void draw(const PairVerdict& scenario, const std::string& path) {
  const Columns& golden = scenario.runs->golden.rows;
  const Columns& fresh = scenario.runs->fresh.rows;
  Overlay overlay;
  for (std::size_t row = 0; row < std::min(golden.size(), fresh.size()); ++row)
    overlay.add(golden.row(row), fresh.row(row));
  const Scenario& played = scenario.runs->fresh.scenario;
  const Figure figure = overlay.figure({.title = scenario.path,
                                        .subtitle = scenario_consequence(scenario),
                                        .a = "golden file",
                                        .b = "this program",
                                        .bounds = bounds_of(played.window, played.sprite)});
  draw_figure(path, figure);
}

// The run is written for the page only, which holds all that it needs of it.
void write_page(const Core& core, const CheckReport& report, const DifferenceGroup& group,
                const PairVerdict& scenario, const std::string& path) {
  const TemporaryFolder folder;
  const std::string run = folder.path() + "/" + scenario.runs->fresh.scenario.name + ".h5";
  const auto checked = static_cast<std::size_t>(report.scenario_count());
  static_cast<void>(write_run(core, run, scenario.runs->fresh.scenario, {}));
  write_report(core, {.files = {run},
                      .against = scenario.golden->h5_path,
                      .output = path,
                      .command = program_command({"check", as_argument(scenario.path)}),
                      .cause = cause_sentence(group, checked).text() + " " + consequence_sentence(group)});
}

}  // namespace

std::vector<std::string> picture_paths(const std::string& path) {
  std::vector<std::string> paths;
  for (std::size_t group = 0; group < kPicturesMax; ++group) paths.push_back(svg_path(path, group));
  paths.push_back(html_path(path));
  return paths;
}

std::vector<GroupPicture> write_pictures(const Core& core, const CheckReport& report,
                                         const std::string& path) {
  std::vector<GroupPicture> pictures;
  for (std::size_t group = 0; group < std::min(report.groups().size(), kPicturesMax); ++group) {
    GroupPicture& picture = pictures.emplace_back();
    const PairVerdict* const scenario = drawable(report.groups()[group]);
    if (scenario == nullptr) {
      const bool keeps_no_rows = report.groups()[group].max_px > 0.0 ||
                                 std::ranges::any_of(report.groups()[group].scenarios, [](const auto* each) {
                                   return each->comparison.has_unknown_rows;
                                 });
      picture.missing =
          keeps_no_rows ? "no picture: long runs keep no rows" : "no picture: no position differs";
      continue;
    }
    try {
      draw(*scenario, svg_path(path, group));
      picture.svg = file_name_of(svg_path(path, group));
      if (group > 0 || page_template(PageKind::runs).empty()) continue;
      write_page(core, report, report.groups()[group], *scenario, html_path(path));
      picture.html = file_name_of(html_path(path));
    } catch (const Failure& failure) {
      picture.missing = failure.what();
    }
  }
  return pictures;
}

}  // namespace hyrax
