#include "tools/app/study/study_command.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "tools/app/command_line/print.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/files/scenario_list.h"
#include "tools/files/table_text.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"
#include "tools/report/figure_svg.h"
#include "tools/report/result_page.h"
#include "tools/store/output_guard.h"
#include "tools/store/table_file.h"

namespace hyrax {
namespace {

constexpr std::int64_t kProcessesMax = 1'000;  // More than any number of comparisons takes.

struct StudyArguments {
  std::vector<std::string> files;  ///< The study's name, then scenarios.
  std::string folder = ".";
  std::string within;
  bool is_quick = false;
  bool is_gate = false;
  bool has_no_figures = false;
  std::string page;
  std::optional<std::int64_t> costs_of_process;
  Printing printing;
};

void declare_arguments(Options& options, const std::vector<OfferedStudy>& studies,
                       StudyArguments& arguments) {
  std::string list;
  std::string names;
  for (const OfferedStudy& study : studies) {
    list += fmt::format("\n{:<12} {}", study.name, study.summary);
    names += (names.empty() ? "" : ", ") + study.name;
  }
  options.files(arguments.files, {"NAME [SCENARIO]", "", "the study, and scenarios for it:" + list}, 1, -1,
                "NAME is missing; allowed: " + names);
  options.text(arguments.folder, {"-o,--output", "DIR",
                                  "folder for NAME.h5, NAME.csv and the figures; default: the current one"});
  options.flag(arguments.is_quick, {"--quick", "", "a smaller study, in seconds"});
  options.flag(arguments.is_gate, {"--gate", "", "exit 1 if one of the study's rules does not hold"});
  options.removed("--expect", "the paper's claims and their verdicts are in sim/physics/claims.md");
  options.text(arguments.within, {"--within", "LENGTH", "needs: the tolerance, as 1px"});
  options.flag(arguments.has_no_figures, {"--no-figures", "", "draw no figures"});
  options.text(arguments.page,
               {"--report", "FILE.html", "write the answer, its pictures and its tables as a page"});
  options.integer(arguments.costs_of_process, {kCostsOption, "N", ""}, 0, kProcessesMax);
  options.printing(arguments.printing, "print whole tables where the terminal is too narrow for them");
}

const OfferedStudy& find_study(const std::vector<OfferedStudy>& studies,
                               const std::vector<std::pair<std::string, std::string>>& instead,
                               const std::string& name) {
  for (const auto& [missing, sentence] : instead)
    if (name == missing) refuse_input(fmt::format("hyrax-sim study {}: {}", missing, sentence));
  std::vector<std::string_view> names;
  for (const OfferedStudy& study : studies) {
    if (study.name == name) return study;
    names.push_back(study.name);
  }
  refuse_input("hyrax-sim study: " + unknown_word("study", name, names));
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

void refuse_what_it_does_not_take(const OfferedStudy& study, const StudyArguments& arguments) {
  const auto refuse = [&](const std::string& what) {
    refuse_input("hyrax-sim study " + study.name + ": " + what + "; see `hyrax-sim study --help`");
  };
  if (!arguments.within.empty() && !study.takes_within) refuse("takes no --within");
  if (arguments.costs_of_process && !study.print_costs) refuse(std::string("takes no ") + kCostsOption);
}

// The scenario files that the study reads.
std::vector<std::string> scenario_files(const OfferedStudy& study, const StudyArguments& arguments) {
  std::vector<std::string> given(arguments.files.begin() + 1, arguments.files.end());
  if (given.empty() && !study.default_scenarios.empty()) given = {study.default_scenarios};
  return list_scenarios(given);
}

// What asks for the same values.
std::vector<std::string> words_of(const StudyArguments& arguments) {
  std::vector<std::string> words = {"study"};
  for (const std::string& file : arguments.files) words.push_back(as_argument(file));
  if (arguments.is_quick) words.emplace_back("--quick");
  if (!arguments.within.empty()) words.insert(words.end(), {"--within", arguments.within});
  return words;
}

StudyInput input_of(const OfferedStudy& study, const Core& core, const StudyArguments& arguments,
                    const std::vector<std::string>& scenarios) {
  StudyInput input{
      .core = core, .scenarios = scenarios, .is_quick = arguments.is_quick, .words = words_of(arguments)};
  if (!arguments.within.empty())
    input.within_px = parse_length_px(arguments.within, "hyrax-sim study " + study.name + ": --within");
  return input;
}

Result run_study(const OfferedStudy& study, StudyInput input) {
  std::optional<Progress> progress;
  input.report_progress = [&, shown = std::string()](const std::string& unit, std::int64_t done,
                                                     std::int64_t total) mutable {
    if (unit != shown) progress.emplace(unit, total);
    shown = unit;
    progress->show(done);
  };
  return study.run(input);
}

// The command that writes the same page.
std::string command_of(const StudyArguments& arguments) {
  std::vector<std::string> words = words_of(arguments);
  words.insert(words.end(), {"--report", as_argument(arguments.page)});
  return program_command(words);
}

// Where the study's files go: FOLDER/NAME + an ending.
std::string stem_of(const OfferedStudy& study, const StudyArguments& arguments) {
  return arguments.folder == "." ? study.name
                                 : (std::filesystem::path(arguments.folder) / study.name).generic_string();
}

// The paths of its files.
std::vector<std::string> write_result(const OfferedStudy& study, const Result& result,
                                      const StudyArguments& arguments) {
  const std::string stem = stem_of(study, arguments);
  std::vector<std::string> paths = {stem + ".h5", stem + ".csv"};
  write_study_file(paths[0], {study.name, study.summary}, result.tables);
  write_text_file(paths[1], csv_text(result.tables.front()));
  for (const Figure& figure : arguments.has_no_figures ? std::vector<Figure>() : result.figures) {
    paths.push_back(stem + figure.suffix + ".svg");
    draw_figure(paths.back(), figure);
  }
  if (arguments.page.empty()) return paths;
  paths.push_back(arguments.page);
  write_result_page(paths.back(), command_of(arguments),
                    {{.title = headline(result.verdict),
                      .subtitle = study.name + ": " + study.summary,
                      .verdict = result.verdict,
                      .judgement = "No rule of the study is broken.",
                      .tables = result.tables,
                      .figures = result.figures}});
  return paths;
}

void print_json(const OfferedStudy& study, const Result& result, const std::vector<std::string>& paths) {
  const std::vector<std::string>& broken = result.verdict.broken;
  Json::Object document{{"study", study.name},
                        {"answer", result.verdict.answer},
                        {"files", Json::Array(paths.begin(), paths.end())},
                        {"broken", Json::Array(broken.begin(), broken.end())}};
  add_members(document, result.summary);
  print_json(std::move(document), 3);
}

ExitCode run_study_command(const OfferedStudy& study, const Core& core, const StudyArguments& arguments) {
  if (study.require) study.require(core);
  refuse_what_it_does_not_take(study, arguments);
  const std::vector<std::string> inputs = scenario_files(study, arguments);
  const StudyInput input = input_of(study, core, arguments, inputs);
  if (arguments.costs_of_process) {
    study.print_costs(input, static_cast<int>(*arguments.costs_of_process));
    return ExitCode::agreed;
  }
  const std::string stem = stem_of(study, arguments);
  OutputGuard guard(inputs);
  if (!arguments.page.empty()) guard.admit_file("hyrax-sim study: --report", arguments.page, {".html"});
  for (const char* const ending : {".h5", ".csv"}) guard.admit("hyrax-sim study: -o", stem + ending);
  const Result result = run_study(study, input);
  if (!arguments.has_no_figures)
    for (const Figure& figure : result.figures)
      guard.admit("hyrax-sim study: -o", stem + figure.suffix + ".svg");
  make_folder(arguments.folder);
  const std::vector<std::string> paths = write_result(study, result, arguments);
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

Command study_command_of(std::vector<OfferedStudy> studies,
                         std::vector<std::pair<std::string, std::string>> instead) {
  const auto declare = [studies](Options& options, StudyArguments& arguments) {
    declare_arguments(options, studies, arguments);
  };
  const auto run = [studies, instead = std::move(instead)](const Core& core,
                                                           const StudyArguments& arguments) {
    return run_study_command(find_study(studies, instead, arguments.files.front()), core, arguments);
  };
  Command command;
  command.name = "study";
  command.declare = with_request<StudyArguments>(declare, run);
  return command;
}

}  // namespace hyrax
