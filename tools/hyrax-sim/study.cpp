#include "tools/hyrax-sim/study.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "tools/files/scenario_list.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/command_line/print.h"
#include "tools/hyrax-sim/command_line/options.h"
#include "tools/hyrax-sim/study_frame_rate.h"
#include "tools/hyrax-sim/study_hard_cases.h"
#include "tools/hyrax-sim/study_needs.h"
#include "tools/hyrax-sim/study_paper.h"
#include "tools/hyrax-sim/study_request.h"
#include "tools/hyrax-sim/study_rest.h"
#include "tools/hyrax-sim/study_speed_error.h"
#include "tools/report/gnuplot.h"
#include "tools/store/output_guard.h"
#include "tools/store/study_csv.h"
#include "tools/store/study_file.h"

namespace hyrax {
namespace {

// All studies, in the order of the help.
const std::vector<StudyKind>& studies() {
  static const std::vector<StudyKind> kinds = {
      {.name = "speed-error",
       .summary = "what every method and rate costs, and how far it is from the exact motion",
       .takes_scenarios = true,
       .make = make_speed_error},
      {.name = "needs",
       .summary = "what of the model and the scene a scenario needs, and the cheapest way to play it",
       .takes_scenarios = true,
       .takes_within = true,
       .make = make_needs},
      {.name = "hard-cases",
       .summary = "what must hold in every step, however hard the scene",
       .takes_scenarios = true,
       .make = make_hard_cases},
      {.name = "frame-rate", .summary = "one fling on every display, steady or not", .make = make_frame_rate},
      {.name = "rest", .summary = "how a sprite ends on the floor, at every display rate", .make = make_rest},
      {.name = "paper",
       .summary = "every claim of the paper, measured",
       .takes_expect = true,
       .make = make_paper},
  };
  return kinds;
}

std::string study_list() {
  std::string list;
  for (const StudyKind& kind : studies())
    list += fmt::format("{}{:<12} {}", list.empty() ? "" : "\n", kind.name, kind.summary);
  return list;
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(ExitCode::cannot_access, folder + ": cannot be made a folder: " + error.message());
}

// What was written, and why a figure was not, if one was not: nobody is to lose the verdict with it.
struct WrittenStudy {
  std::vector<std::string> paths;
  std::optional<Failure> undrawn;
};

std::string stem_of(const StudyKind& kind, const StudyArguments& arguments) {
  return arguments.folder == "." ? kind.name : (std::filesystem::path(arguments.folder) / kind.name).string();
}

WrittenStudy write_outcome(const StudyKind& kind, const StudyOutcome& outcome,
                           const StudyArguments& arguments) {
  const std::string stem = stem_of(kind, arguments);
  WrittenStudy written{.paths = {stem + ".h5", stem + ".csv"}, .undrawn = {}};
  write_study_file(written.paths[0], {kind.name, kind.summary}, outcome.tables);
  write_text_file(written.paths[1], csv_text(outcome.tables.front()));
  if (arguments.draws_nothing) return written;
  try {
    for (const StudyFigure& figure : outcome.figures) {
      draw_figure(stem + figure.suffix + ".svg", figure.script);
      written.paths.push_back(stem + figure.suffix + ".svg");
    }
  } catch (const Failure& failure) {
    written.undrawn = failure;
  }
  return written;
}

void tell_json(const StudyKind& kind, StudyOutcome& outcome, const std::vector<std::string>& paths) {
  Json::Object document{{"study", kind.name},
                        {"files", Json::Array(paths.begin(), paths.end())},
                        {"broken", Json::Array(outcome.broken.begin(), outcome.broken.end())}};
  for (auto& member : outcome.json) document.push_back(std::move(member));
  print_text("{}\n", to_text(Json(std::move(document)), {.depth_indented = 3}));
}

void tell(const StudyOutcome& outcome, const std::vector<std::string>& paths) {
  print_text("{}", outcome.verdict);
  for (const std::string& sentence : outcome.broken) print_text("does not hold: {}\n", sentence);
  print_text("written: {}\n", fmt::join(paths, ", "));
}

ExitCode study(const StudyArguments& arguments) {
  const StudyKind& kind = find_study(studies(), arguments.words.front());
  const StudyRequest request = study_request(kind, arguments);
  std::vector<std::string> inputs = list_scenarios(request.scenarios);
  if (!request.expect_file.empty()) inputs.push_back(request.expect_file);
  OutputGuard guard(inputs);
  for (const char* const end : {".h5", ".csv"})
    guard.admit("hyrax-sim study: -o", stem_of(kind, arguments) + end);
  StudyOutcome outcome = kind.make(request);
  if (!arguments.draws_nothing)
    for (const StudyFigure& figure : outcome.figures)
      guard.admit("hyrax-sim study: -o", stem_of(kind, arguments) + figure.suffix + ".svg");
  make_folder(arguments.folder);
  const WrittenStudy written = write_outcome(kind, outcome, arguments);
  if (arguments.is_json)
    tell_json(kind, outcome, written.paths);
  else
    tell(outcome, written.paths);
  if (arguments.is_gate)
    for (const std::string& sentence : outcome.broken)
      print_error(fmt::format("hyrax-sim study {}: {}", kind.name, sentence));
  if (written.undrawn) throw *written.undrawn;
  return arguments.is_gate && !outcome.broken.empty() ? ExitCode::disagreed : ExitCode::agreed;
}

}  // namespace

Command study_command() {
  return {.name = "study",
          .summary = "speed against error, what a scene needs, hard cases, rest, and the paper's claims",
          .example =
              "hyrax-sim study speed-error -o studies\n"
              "  hyrax-sim study needs scenarios/flings/first-fling.json --within 1px",
          .is_common = true,
          .declare = [](Options& options) {
            const auto arguments = std::make_shared<StudyArguments>();
            declare_study(options, *arguments, study_list());
            return [arguments] { return study(*arguments); };
          }};
}

}  // namespace hyrax
