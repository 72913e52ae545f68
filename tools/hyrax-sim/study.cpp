// The command study: asks a study of sim/study, writes what it found, and prints its verdict.
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "sim/core/core.h"
#include "sim/study/study.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/core/accepted_core.h"
#include "tools/files/json_reader.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/table_text.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"
#include "tools/report/figure_json.h"
#include "tools/report/figure_svg.h"
#include "tools/store/output_guard.h"
#include "tools/store/table_file.h"

namespace hyrax {
namespace {

constexpr std::string_view kVerdictsFormat = "hyrax-verdicts/1";

// Reads { "format": "hyrax-verdicts/1", "verdicts": { "2.3-energy": "does not hold", ... } }. Whether its
// names and verdicts exist is the study's to judge.
ExpectedVerdicts read_verdicts(const std::string& path) {
  const Json json = parse_json(read_text_file(path), path);
  JsonProblems problems;
  const JsonPlace document(&json, "", problems);
  ExpectedVerdicts expected{path, {}};
  if (document.is_object_of({"format", "verdicts"})) {
    const JsonPlace format = document.required("format");
    if (const auto name = format.text(); name && *name != kVerdictsFormat)
      format.wrong(unknown_word("format", *name, {kVerdictsFormat}));
    document.required("verdicts").each_member([&](const std::string& name, const JsonPlace& verdict) {
      expected.verdicts.emplace_back(name, verdict.text().value_or(""));
    });
  }
  problems.throw_if_any(path);
  return expected;
}

struct StudyArguments {
  std::vector<std::string> files;  ///< The study's name, then scenarios.
  std::string folder = ".";
  std::string expect_file;
  std::string within;
  bool is_quick = false;
  bool is_gate = false;
  bool has_no_figures = false;
  Printing printing;
};

void declare_arguments(Options& options, StudyArguments& arguments) {
  std::string list;
  std::string names;
  for (const Study& study : studies()) {
    list += fmt::format("\n{:<12} {}", study.name, study.summary);
    names += (names.empty() ? "" : ", ") + study.name;
  }
  options.files(arguments.files, {"NAME [SCENARIO]", "", "the study, and scenarios for it:" + list}, 1, -1,
                "NAME is missing; allowed: " + names);
  options.text(arguments.folder, {"-o,--output", "DIR",
                                  "folder for NAME.h5, NAME.csv and the figures; default: the current one"});
  options.flag(arguments.is_quick, {"--quick", "", "a smaller study, in seconds"});
  options.flag(arguments.is_gate, {"--gate", "", "exit 1 if one of the study's rules does not hold"});
  options.text(arguments.expect_file, {"--expect", "FILE", "paper: expected verdicts, compared with --gate"});
  options.text(arguments.within, {"--within", "LENGTH", "needs: the tolerance, as 1px"});
  options.flag(arguments.has_no_figures, {"--no-figures", "", "draw no figures"});
  options.printing(arguments.printing);
}

const Study& find_study(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Study& study : studies()) {
    if (study.name == name) return study;
    names.push_back(study.name);
  }
  refuse_input("hyrax-sim study: " + unknown_word("study", name, names));
}

std::int64_t steady_clock_ns() {
  using std::chrono::steady_clock;
  return std::chrono::duration_cast<std::chrono::nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

// A length of at least 0, as "1px", "0.5 px" or "2".
double parse_length_px(const std::string& text, const std::string& place) {
  double length_px = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, length_px);
  const std::string unit(rest, end);
  if (error != std::errc() || !(unit.empty() || unit == "px" || unit == " px") || !std::isfinite(length_px) ||
      length_px < 0.0)
    refuse_input(place + ": must be a length of at least 0, as 1px (found '" + text + "')");
  return length_px;
}

void refuse_what_it_does_not_take(const Core& core, const Study& study, const StudyArguments& arguments) {
  const auto refuse = [&](const std::string& what) {
    refuse_input("hyrax-sim study " + study.name + ": " + what + "; see `hyrax-sim study --help`");
  };
  if (arguments.files.size() > 1 && !study.takes_scenarios)
    refuse("takes no scenarios (found '" + arguments.files[1] + "')");
  if (!arguments.expect_file.empty() && !study.takes_expected) refuse("takes no --expect");
  if (study.takes_expected && arguments.is_gate && arguments.expect_file.empty())
    refuse("--gate needs --expect FILE, the expected verdicts");
  if (!arguments.within.empty() && !study.takes_within) refuse("takes no --within");
  if (study.is_of_paper && !is_paper_model(core.name))
    refuse("is about the paper's own constants (found the core " + std::string(core.name) + ")");
}

// The scenario files that the study reads.
std::vector<std::string> scenario_files(const Study& study, const StudyArguments& arguments) {
  std::vector<std::string> given(arguments.files.begin() + 1, arguments.files.end());
  if (given.empty() && !study.default_scenarios.empty()) given = {study.default_scenarios};
  return list_scenarios(given);
}

StudyRequest request_of(const Core& core, const Study& study, const StudyArguments& arguments,
                        const std::vector<std::string>& scenarios) {
  std::set<std::string> names;
  StudyRequest request{.core = core,
                       .is_quick = arguments.is_quick,
                       .core_step = program_step(core),
                       .machine = processor_name(),
                       .now_ns = steady_clock_ns};
  for (const std::string& path : scenarios) {
    request.scenarios.push_back({path, load_scenario(path)});
    const std::string& name = request.scenarios.back().scenario.name;
    if (!names.insert(name).second)
      refuse_input(path + ": /name: duplicate scenario name (found " + name +
                   "); scenarios of one study need different names");
  }
  if (!arguments.within.empty())
    request.within_px = parse_length_px(arguments.within, "hyrax-sim study " + study.name + ": --within");
  if (!arguments.expect_file.empty()) request.expected = read_verdicts(arguments.expect_file);
  return request;
}

Result run_study(const Study& study, StudyRequest request) {
  std::optional<Progress> progress;
  request.report_progress = [&](const std::string& unit, std::int64_t done, std::int64_t total) {
    if (!progress) progress.emplace(unit, total);
    progress->show(done);
  };
  try {
    return study.run(request);
  } catch (const RequestRefused& refused) {
    refuse_input(refused.what());
  }
}

// Where the study's files go: FOLDER/NAME + an ending.
std::string stem_of(const Study& study, const StudyArguments& arguments) {
  return arguments.folder == "." ? study.name
                                 : (std::filesystem::path(arguments.folder) / study.name).string();
}

// What the report page needs besides the tables, as text in the file: verdict and figures.
Table report_table(const Result& result) {
  const auto column = [](const char* name, const char* long_name, const Json& json) {
    return Column{.name = name, .long_name = long_name, .values = std::vector<std::string>{to_text(json)}};
  };
  return {.name = kReportTable,
          .long_name = "what hyrax-sim report shows besides the tables, as JSON",
          .columns = {column("verdict", "sentences and rules", verdict_json(result.verdict)),
                      column("figures", "the figures as data", list_of(result.figures, figure_json))}};
}

// The paths of its files.
std::vector<std::string> write_result(const Study& study, const Result& result, const std::string& stem,
                                      bool has_figures) {
  std::vector<std::string> paths = {stem + ".h5", stem + ".csv"};
  std::vector<Table> tables = result.tables;
  tables.push_back(report_table(result));
  write_study_file(paths[0], {study.name, study.summary}, tables);
  write_text_file(paths[1], csv_text(result.tables.front()));
  for (const Figure& figure : has_figures ? result.figures : std::vector<Figure>()) {
    paths.push_back(stem + figure.suffix + ".svg");
    draw_figure(paths.back(), figure);
  }
  return paths;
}

void print_json(const Study& study, const Result& result, const std::vector<std::string>& paths) {
  const std::vector<std::string>& broken = result.verdict.broken;
  Json::Object document{{"study", study.name},
                        {"files", Json::Array(paths.begin(), paths.end())},
                        {"broken", Json::Array(broken.begin(), broken.end())}};
  add_members(document, result.summary);
  print_json(std::move(document), 3);
}

ExitCode run_study_command(const Core& core, const StudyArguments& arguments) {
  const Study& study = find_study(arguments.files.front());
  refuse_what_it_does_not_take(core, study, arguments);
  std::vector<std::string> inputs = scenario_files(study, arguments);
  const StudyRequest request = request_of(core, study, arguments, inputs);
  if (!arguments.expect_file.empty()) inputs.push_back(arguments.expect_file);
  const std::string stem = stem_of(study, arguments);
  OutputGuard guard(inputs);
  for (const char* const ending : {".h5", ".csv"}) guard.admit("hyrax-sim study: -o", stem + ending);
  const Result result = run_study(study, request);
  if (!arguments.has_no_figures)
    for (const Figure& figure : result.figures)
      guard.admit("hyrax-sim study: -o", stem + figure.suffix + ".svg");
  make_folder(arguments.folder);
  const std::vector<std::string> paths = write_result(study, result, stem, !arguments.has_no_figures);
  if (arguments.printing.is_json) {
    print_json(study, result, paths);
  } else {
    print_verdict(study.name, result.verdict, arguments.printing);
    if (!arguments.printing.is_quiet()) print_text("written: {}\n", fmt::join(paths, ", "));
  }
  if (arguments.is_gate)
    for (const std::string& sentence : result.verdict.broken)
      print_error(fmt::format("hyrax-sim study {}: {}", study.name, sentence));
  return arguments.is_gate && !result.verdict.broken.empty() ? ExitCode::disagreed : ExitCode::agreed;
}

}  // namespace

Command study_command() {
  return {.name = "study",
          .summary = "measure error against cost, needs, hard cases, frame rates, rest, the paper's claims",
          .example =
              "hyrax-sim study speed-error -o studies\n"
              "  hyrax-sim study needs scenarios/flings/first-fling.json --within 1px",
          .is_common = true,
          .needs_paper_step = true,
          .declare = with_request<StudyArguments>(declare_arguments, run_study_command)};
}

}  // namespace hyrax
