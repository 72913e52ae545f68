// hyrax-replay: the state hash of scenarios, without HDF5 and GSL, so that it builds for every target.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "help_text.h"
#include "sim/core/shipped_core.h"
#include "sim/physics/strict_arithmetic.h"
#include "sim/replay/replay.h"
#include "tools/files/build_info.h"
#include "tools/files/failure.h"
#include "tools/files/main_program.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/unknown_word.h"
#include "tools/hyrax-replay/check.h"

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
  const RunSummary summary = replay(core, scenario);
  print_text(hex(summary.state_hash) + "  " + path + "\n");
  return judge_hash(path, scenario, summary);
} catch (const Failure& failure) {
  print_error(failure.what());
  return failure.exit_code();
}

void print_version() {
  const BuildInfo info = build_info();
  const auto print = [](const char* name, std::string_view value) {
    std::string line(name);
    line.resize(std::max<std::size_t>(line.size(), 15), ' ');
    print_text(line.append(" ").append(value).append("\n"));
  };
  print("version", info.version);
  print("compiler", info.compiler);
  print("flags", info.flags);
  print("target", info.target);
  print("instruction_set", info.instruction_set);
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

ExitCode print_hashes(const Core& core, const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  bool only_files = false;  // Behind "--".
  for (const std::string& argument : arguments) {
    if (argument == "--" && !std::exchange(only_files, true)) continue;
    if (argument.empty()) refuse_input("hyrax-replay: SCENARIO: must not be empty");
    if (!only_files && argument.starts_with('-'))
      refuse_input("hyrax-replay: " + unknown_word("option", argument, {"--help", "--version"}));
    files.push_back(argument);
  }
  if (files.empty())
    refuse_input(
        "hyrax-replay: SCENARIO is missing; for example `hyrax-replay scenarios/flings/first-fling.json`");
  require_strict_arithmetic();
  ExitCode exit_code = ExitCode::agreed;
  for (const std::string& path : list_scenarios(files))
    exit_code = more_serious(exit_code, replay_file(core, path));
  return exit_code;
}

ExitCode run(const Core& core, const std::vector<std::string>& arguments) {
  if (print_information(arguments)) return ExitCode::agreed;
  if (arguments.empty() || arguments.front() != "check") return print_hashes(core, arguments);
  require_strict_arithmetic();
  return check(core, {arguments.begin() + 1, arguments.end()});
}

}  // namespace
}  // namespace hyrax

int main(int argument_count, char** arguments) {
  return hyrax::run_program(
      "hyrax-replay", argument_count, arguments,
      [](const std::vector<std::string>& words) { return hyrax::run(hyrax::shipped_core(), words); });
}
