// The report of `check` in Markdown, with its pictures.
#include <fmt/format.h>

#include <algorithm>

#include "sim/compare/overlay.h"
#include "tools/app/check/check_report.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/temporary_folder.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"

namespace hyrax {
namespace {

// A code span, in which no character of the text has a meaning: its fence is longer than any in the text.
std::string code_span(std::string_view text) {
  const std::string line = printable(text);
  std::size_t longest = 0, run = 0;
  for (const char c : line) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  const char* const pad = line.empty() || line.front() == '`' || line.back() == '`' ? " " : "";
  return fence + pad + line + pad + fence;
}

// Indented, so that no character of the lines has a meaning.
std::string code_block(std::string_view lines) {
  std::string text = "    ";
  for (const char c : lines) text += c == '\n' ? "\n    " : std::string(1, c);
  return text + "\n";
}

// To a file beside the summary: in angle brackets its name may hold blanks and parentheses.
std::string link_to(std::string_view path) {
  std::string target;
  for (const char c : path.substr(file_name(path).folder.size())) {
    if (c == '<' || c == '>' || c == '\\') target += '\\';
    target += c;
  }
  return "(<" + target + ">)";
}

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

// What is drawn of a group.
std::string pictures_text(const Core& core, const CheckReport& report, std::size_t index,
                          const std::string& path) {
  const DifferenceGroup& group = report.groups[index];
  const PairVerdict* const scenario = drawable(group);
  if (scenario == nullptr) {
    const bool keeps_no_rows =
        group.max_px > 0.0 || std::ranges::any_of(group.scenarios, [](const auto* each) {
          return each->comparison.has_unknown_rows;
        });
    return code_span(keeps_no_rows ? "no picture: long runs keep no rows"
                                   : "no picture: no position differs") +
           "\n\n";
  }
  const std::vector<std::string> paths = picture_paths(path);
  std::string text;
  try {
    draw(*scenario, paths[index]);
    text += "![both paths of the worst scenario, and their distance]" + link_to(paths[index]) + "\n\n";
    if (index > 0 || page_template(PageKind::runs).empty()) return text;
    write_page(core, report, group, *scenario, paths.back());
    return text + "[The same run, played step by step]" + link_to(paths.back()) + "\n\n";
  } catch (const Failure& failure) {
    return text + code_span(failure.what()) + "\n\n";
  }
}

std::string group_section(const DifferenceGroup& group, std::size_t checked, const std::string& pictures) {
  std::string text = fmt::format("### {}\n\n{}\n\n{}\n\n{}", name_of(group.cause.kind),
                                 code_span(cause_sentence(group, checked).text()),
                                 code_span(consequence_sentence(group)), pictures);
  for (const PairVerdict* const scenario : group.scenarios)
    text += fmt::format("- {}: {}\n", code_span(scenario->path), code_span(scenario_consequence(*scenario)));
  return text + "\n";
}

}  // namespace

std::vector<std::string> picture_paths(const std::string& path) {
  const FileName name = file_name(path);
  const std::string beside = std::string(name.folder).append(name.stem);
  std::vector<std::string> paths;
  for (std::size_t group = 0; group < kPicturesMax; ++group)
    paths.push_back(fmt::format("{}-{}.svg", beside, group + 1));
  paths.push_back(beside + ".html");
  return paths;
}

std::string check_markdown(const Core& core, const CheckReport& report, const std::string& path) {
  const std::vector<OtherFailure> others = other_failures(report);
  const bool is_green = report.count(CheckStatus::agreed) == std::ssize(report.verdicts) && others.empty();
  std::string text = fmt::format("## hyrax-sim check: {}\n\n{}\n\n", is_green ? "agreed" : "not agreed",
                                 counts_sentence(report));
  const auto checked = static_cast<std::size_t>(report.scenario_count());
  for (std::size_t group = 0; group < report.groups.size(); ++group)
    text += group_section(report.groups[group], checked,
                          group < kPicturesMax ? pictures_text(core, report, group, path) : "");
  for (const OtherFailure& other : others)
    text += fmt::format("### {}\n\n{}\n", other.kind, code_block(printable_lines(other.text)));
  for (const CheckVerdict& verdict : report.verdicts)
    if (verdict.status != CheckStatus::agreed && verdict.group == nullptr)
      text += fmt::format("- {}: {}: {}\n", code_span(verdict.path), name_of(verdict.status),
                          code_span(verdict_sentence(verdict)));
  return text;
}

}  // namespace hyrax
