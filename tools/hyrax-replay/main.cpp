// hyrax-replay: the state hash of scenarios, without HDF5 and GSL, so that it builds for every target.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "help_text.h"
#include "sim/core/shipped_core.h"
#include "sim/physics/strict_arithmetic.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/physics_model.h"
#include "tools/files/build_info.h"
#include "tools/files/failure.h"
#include "tools/files/main_program.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/unknown_word.h"
#include "tools/hyrax-replay/check.h"
#include "tools/run_core/run_core.h"

namespace hyrax {
namespace {

ExitCode judge_hash(const std::string& path, const Scenario& scenario, const RunSummary& summary) {
  if (summary.non_finite_step) {
    print_error(path + ": " + non_finite_text(scenario, summary.final));
    return ExitCode::disagreed;
  }
  const std::string hash = hex(summary.state_hash);
  if (scenario.expect && scenario.expect->state_hash && *scenario.expect->state_hash != hash) {
    print_error(path + ": /expect/state_hash: differs from the run (found " + *scenario.expect->state_hash +
                "); the run has " + hash);
    return ExitCode::disagreed;
  }
  return ExitCode::agreed;
}

ExitCode replay_file(const Core& core, const std::string& path) try {
  const Scenario scenario = load_scenario(path);
  const RunSummary summary = replay(run_core(core, path, scenario), scenario);
  print_text(hex(summary.state_hash) + "  " + path + "\n");
  return judge_hash(path, scenario, summary);
} catch (const Failure& failure) {
  print_error(failure.what());
  return failure.exit_code();
}

void print_version() {
  const BuildInfo info = build_info();
  for (const auto& [name, value] : {std::pair("version", info.version), std::pair("compiler", info.compiler),
                                    std::pair("flags", info.flags), std::pair("target", info.target),
                                    std::pair("instruction_set", info.instruction_set)}) {
    std::string line(name);
    line.resize(15, ' ');
    print_text(line.append(" ").append(value).append("\n"));
  }
}

void require_strict_arithmetic() {
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, "hyrax-replay: " + std::string(*fault));
}

// Whether it was all that was asked for.
bool print_information(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--") return false;
    if (argument != "--help" && argument != "--version") continue;
    argument == "--help" ? print_text(kHelpText) : print_version();
    return true;
  }
  return false;
}

struct Arguments {
  std::vector<std::string> files;
  std::string golden_folder;  // Of a check; empty if none was given.
};

Arguments parsed(const std::vector<std::string>& words, bool is_check) {
  const auto refuse = [&](const std::string& what) {
    refuse_input(is_check ? "hyrax-replay check: " + what + "; see `hyrax-replay --help`"
                          : "hyrax-replay: " + what);
  };
  Arguments arguments;
  bool only_files = false;  // Behind "--".
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word == "--" && !std::exchange(only_files, true)) continue;
    if (word->empty())
      refuse(is_check ? "SCENARIO or DIR: must not be empty" : "SCENARIO: must not be empty");
    if (only_files || !word->starts_with('-')) {
      arguments.files.push_back(*word);
      continue;
    }
    if (!is_check) refuse(unknown_word("option", *word, {"--help", "--version"}));
    if (*word != "--golden") refuse(unknown_word("option", *word, {"--golden", "--help"}));
    if (!arguments.golden_folder.empty()) refuse("--golden: given twice");
    if (word + 1 == words.end()) refuse("--golden: value is missing: DIR");
    arguments.golden_folder = *++word;
    if (arguments.golden_folder.empty()) refuse("--golden: must not be empty");
  }
  return arguments;
}

ExitCode print_hashes(const Core& core, const std::vector<std::string>& files) {
  if (files.empty())
    refuse_input(
        "hyrax-replay: SCENARIO is missing; for example `hyrax-replay scenarios/flings/first-fling.json`");
  require_strict_arithmetic();
  ExitCode exit_code = ExitCode::agreed;
  for (const std::string& path : list_scenarios(files))
    exit_code = more_serious(exit_code, replay_file(core, path));
  return exit_code;
}

ExitCode run(const Core& core, std::vector<std::string> words) {
  if (print_information(words)) return ExitCode::agreed;
  if (words.empty() || words.front() != "check") return print_hashes(core, parsed(words, false).files);
  require_strict_arithmetic();
  words.erase(words.begin());
  Arguments arguments = parsed(words, true);
  return check(core, arguments.files, arguments.golden_folder);
}

}  // namespace
}  // namespace hyrax

int main(int argument_count, char** arguments) {
  const std::string_view core = hyrax::shipped_core().name;
  if (!hyrax::is_paper_model(core)) hyrax::name_program("hyrax-replay", std::string(core) + "-replay");
  return hyrax::run_program(
      "hyrax-replay", argument_count, arguments,
      [](const std::vector<std::string>& words) { return hyrax::run(hyrax::shipped_core(), words); });
}
