#include <fmt/format.h>

#include <filesystem>

#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/search/broken_rule.h"
#include "tools/files/child_process.h"
#include "tools/files/failure.h"
#include "tools/files/golden_place.h"
#include "tools/files/json.h"
#include "tools/files/path.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/temporary_folder.h"
#include "tools/files/text_file.h"
#include "tools/store/output_guard.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr double kLimit_s = 10.0;
constexpr double kProgramLimit_s = 60.0;
constexpr std::int64_t kTrialsMax = 2'000;

struct ShrinkRequest {
  std::vector<std::string> files;
  std::string fails;
  std::string against;
  std::string output;
  std::optional<double> limit_s;
  bool is_forced = false;
  Printing printing;
};

// COMMAND with the path of a scenario's file for each {}, run by the shell. The file has the golden place of
// the original: copies of its golden file and of the accepted core are where it would look for them.
class UserCommand {
 public:
  UserCommand(std::string command, std::optional<double> limit_s, const std::string& original)
      : file_(fs::path(original).filename()),
        command_(std::move(command)),
        limit_s_(limit_s.value_or(kLimit_s)) {
    if (command_.find("{}") == std::string::npos)
      refuse_input("hyrax-sim shrink: --fails: no {} for the scenario's file (found " + command_ +
                   "); as in 'hyrax-sim run {} -o out.h5'");
    copy_golden_files(original);
  }

  [[nodiscard]] ChildEnd run(const Scenario& scenario) const {
    const std::string path = shell_command({folder_.write(file_.string(), scenario_file_text(scenario))});
    std::string line = command_;
    for (std::size_t at = 0; (at = line.find("{}", at)) != std::string::npos; at += path.size())
      line.replace(at, 2, path);
    constexpr std::size_t kOutBytesMax = 1 << 10;
    return run_child({"/bin/sh", "-c", line}, {}, limit_s_, kOutBytesMax);
  }
  [[nodiscard]] std::string text_of(const ChildEnd& end) const { return end_text(end, limit_s_); }

 private:
  void copy_golden_files(const std::string& original) {
    const fs::path golden = golden_folder_of(original);
    const fs::path copy = fs::path(folder_.path()) / "golden";
    if (const auto place = golden_place(original, ""); !golden.empty() && place) {
      const fs::path name = fs::path(place->h5_path).lexically_relative(golden);
      file_ = "scenarios" / fs::path(name).replace_extension(".json");
      fs::create_directories((copy / name).parent_path());
      if (has_golden_file(*place)) {
        fs::copy_file(place->h5_path, copy / name);
        fs::copy_file(place->txt_path, (copy / name).replace_extension(".txt"));
      }
      if (is_folder((golden / "core").string())) fs::copy(golden / "core", copy / "core");
    }
    fs::create_directories((folder_.path() / file_).parent_path());
  }

  TemporaryFolder folder_;
  fs::path file_;  // In that folder.
  std::string command_;
  double limit_s_;
};

// What is kept while the scenario shrinks, in words, and the smallest scenario.
struct ShrinkOutcome {
  std::string kept;
  Shrunk shrunk;
};

ShrinkOutcome shrink_by_command(const Core& core, const ShrinkRequest& request, const Scenario& scenario) {
  const UserCommand command(request.fails, request.limit_s, request.files.front());
  const ChildEnd wanted = command.run(scenario);
  if (!wanted.is_timed_out && wanted.exit_code == 0)
    refuse_input(request.files.front() +
                 ": the command does not fail here: exit code 0 (it was run on a copy "
                 "of the scenario, and of its golden file if it has one)");
  constexpr int kCannotExecute = 126;
  constexpr int kNotFound = 127;
  if (!wanted.is_timed_out && (wanted.exit_code == kCannotExecute || wanted.exit_code == kNotFound))
    refuse_input(fmt::format("hyrax-sim shrink: --fails: the shell cannot run `{}`: {}", request.fails,
                             wanted.err.substr(0, wanted.err.find('\n'))));
  const auto fails = [&](const Scenario& simpler) {
    const ChildEnd end = command.run(simpler);
    return end.is_timed_out == wanted.is_timed_out && (end.is_timed_out || end.exit_code == wanted.exit_code);
  };
  return {"the command's " + command.text_of(wanted),
          shrink_with_progress(core, scenario, fails, kTrialsMax)};
}

ShrinkOutcome shrink_against(const Core& core, const ShrinkRequest& request, const Scenario& scenario) {
  const OtherProgram other(request.against, "hyrax-sim shrink: --against", std::nullopt,
                           request.limit_s.value_or(kProgramLimit_s));
  const auto broken = different_hash(core, scenario, other);
  if (!broken)
    refuse_input(request.files.front() + ": has the same state hash in both programs (" + request.against +
                 "); nothing to shrink");
  return {broken->other_end.empty() ? "different state hashes" : "the other program's " + broken->other_end,
          shrink_broken(core, scenario, *broken, &other)};
}

Json size_json(const Scenario& scenario) {
  return Json::Object{{"steps", step_count(scenario)},
                      {"events", static_cast<std::int64_t>(scenario.events.size())}};
}

void print_shrunk(const ShrinkRequest& request, const Scenario& before, const ShrinkOutcome& outcome) {
  const Scenario& after = outcome.shrunk.scenario;
  if (request.printing.is_json)
    return print_json(Json::Object{{"scenario", request.files.front()},
                                   {"output", request.output},
                                   {"kept", outcome.kept},
                                   {"before", size_json(before)},
                                   {"after", size_json(after)},
                                   {"trials", outcome.shrunk.trials},
                                   {"complete", outcome.shrunk.is_complete}});
  print_text("written: {} ({} and {}, from {} and {})\n", request.output, counted(step_count(after), "frame"),
             counted(after.events.size(), "event"), step_count(before), before.events.size());
  if (request.printing.is_quiet()) return;
  print_text("kept: {}\n", outcome.kept);
  print_text("{} tried{}\n", counted(outcome.shrunk.trials, "scenario"),
             outcome.shrunk.is_complete ? "" : ", the limit; a smaller one may exist");
}

ExitCode run_shrink(const Core& core, const ShrinkRequest& request) {
  if (request.fails.empty() == request.against.empty())
    refuse_input("hyrax-sim shrink: --fails, --against: exactly one is needed");
  if (request.output.empty())
    refuse_input("hyrax-sim shrink: -o: is missing; name the file of the smaller scenario");
  OutputGuard(request.files)
      .admit_scenario("hyrax-sim shrink: -o", request.output, request.is_forced, {".json"});
  const Scenario scenario = load_scenario(request.files.front());
  ShrinkOutcome outcome = request.fails.empty() ? shrink_against(core, request, scenario)
                                                : shrink_by_command(core, request, scenario);
  if (!outcome.shrunk.fails_again)
    refuse_input(request.files.front() +
                 ": ended differently when it was tried again; only what fails every time can be shrunk");
  outcome.shrunk.scenario.description =
      fmt::format("Shrunk from {}, {}; kept: {}.", scenario.name,
                  plain_counted(step_count(scenario), "frame"), outcome.kept);
  write_text_file(request.output, scenario_file_text(outcome.shrunk.scenario), request.is_forced);
  print_shrunk(request, scenario, outcome);
  return ExitCode::agreed;
}

void declare(Options& options, ShrinkRequest& request) {
  options.files(request.files, {"SCENARIO", "", "the scenario that fails"}, 1, 1);
  options.text(
      request.fails,
      {"--fails", "COMMAND",
       "run by /bin/sh with the file of a scenario for {}, which has the golden file of SCENARIO: the "
       "smaller scenario ends it with the same exit code, not 0; a signal counts as 128 + its number"});
  options.text(request.against,
               {"--against", "PROGRAM", "another hyrax-sim: both still give different state hashes"});
  options.text(request.output, {"-o,--output", "SMALL.json", "the smaller scenario"});
  options.number(request.limit_s,
                 {"--time-limit", "SECONDS",
                  "a COMMAND or PROGRAM that runs longer is killed, which counts as an end of its own "
                  "(default: 10, of PROGRAM 60)"},
                 0.001);
  options.flag(request.is_forced, {"--force", "", "replace an existing SMALL.json"});
  options.printing(request.printing);
}

}  // namespace

Command shrink_command() {
  return {.name = "shrink",
          .summary = "find the smallest scenario that still fails",
          .example =
              "hyrax-sim shrink scenarios/flings/first-fling.json --fails './check-it {}' -o small.json\n"
              "  hyrax-sim shrink scenarios/flings/first-fling.json --against ./other-build/hyrax-sim -o "
              "small.json",
          .declare = with_request<ShrinkRequest>(declare, run_shrink)};
}

}  // namespace hyrax
