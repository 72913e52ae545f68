// hyrax-replay: the state hash of scenarios, without HDF5 and GSL, so that it builds for every target.
#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "sim/physics/strict_arithmetic.h"
#include "sim/replay/replay.h"
#include "tools/files/build_info.h"
#include "tools/files/failure.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

constexpr char kHelp[] =
    "hyrax-replay replays scenarios and prints the hash of every row of each.\n\n"
    "  hyrax-replay scenarios/flings/first-fling.json\n\n"
    "Usage: hyrax-replay SCENARIO...\n\n"
    "Of a folder every *.json in it is replayed. Each line of output is HASH, two blanks, SCENARIO. If the\n"
    "`expect` of a scenario has a `state_hash`, it must be equal. `--version` prints version, compiler,\n"
    "flags, target and instruction set.\n"
    "Exit codes: 0 done, 1 a hash differs or a state is not finite, 2 bad usage or input, 3 cannot read,\n"
    "5 arithmetic is not strict IEEE-754, 70 internal error.\n";

ExitCode judge(const std::string& path, const Scenario& scenario, const RunSummary& summary) {
  if (summary.non_finite_step) {
    print_error(path + ": the state is not finite from step " + std::to_string(*summary.non_finite_step));
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

ExitCode replay_file(const std::string& path) try {
  const Scenario scenario = load_scenario(path);
  RowSink sink;  // Discards all rows; the hash covers them.
  const RunSummary summary = replay(scenario, sink);
  print_text(hex(summary.state_hash) + "  " + path + "\n");
  return judge(path, scenario, summary);
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

ExitCode run(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "--version") {
      argument == "--help" ? print_text(kHelp) : print_version();
      return ExitCode::agreed;
    }
    if (argument.starts_with('-'))
      throw Failure(ExitCode::bad_input,
                    "hyrax-replay: " + unknown_word("option", argument, {"--help", "--version"}));
  }
  if (arguments.empty())
    throw Failure(
        ExitCode::bad_input,
        "hyrax-replay: SCENARIO is missing; for example `hyrax-replay scenarios/flings/first-fling.json`");
  if (const auto fault = arithmetic_fault())
    throw Failure(ExitCode::not_strict_ieee, "hyrax-replay: " + std::string(*fault));
  ExitCode exit_code = ExitCode::agreed;
  for (const std::string& path : list_scenarios(arguments))
    exit_code = more_serious(exit_code, replay_file(path));
  return exit_code;
}

}  // namespace
}  // namespace hyrax

int main(int argument_count, char** arguments) {
  using namespace hyrax;
  ExitCode exit_code = ExitCode::program_fault;
  try {
    exit_code =
        run(std::vector<std::string>(arguments + (argument_count > 0 ? 1 : 0), arguments + argument_count));
  } catch (const Failure& failure) {
    print_error(failure.what());
    exit_code = failure.exit_code();
  } catch (const std::exception& error) {
    print_error(std::string("hyrax-replay: internal error: ") + error.what());
  }
  if (!is_all_printed()) {
    print_error("hyrax-replay: standard output cannot be written");
    exit_code = more_serious(exit_code, ExitCode::cannot_access);
  }
  return static_cast<int>(exit_code);
}
