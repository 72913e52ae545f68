#include "tools/described/program.h"

#include "sim/core/core.h"
#include "tools/app/command_line/command_program.h"
#include "tools/described/commands.h"

namespace hyrax {
namespace {

std::string first_screen(const Description& description, const std::vector<Command>& commands) {
  return fmt::format(
             "hyrax-sim plays scenarios of the core {} bit for bit, and reports what changed.\n\n"
             "  hyrax-sim new first\n"
             "  hyrax-sim run first.json -o first.csv\n"
             "  hyrax-sim check\n\n",
             description.core) +
         command_lists(commands, [](const Command& command) { return command.declare != nullptr; });
}

std::vector<Command> described_commands(const DescribedCore& core) {
  std::vector<Command> commands = {
      described_run_command(core),    described_check_command(core), described_bless_command(core),
      described_diff_command(core),   described_new_command(core),   described_validate_command(core),
      described_schema_command(core), described_fuzz_command(core),  described_sweep_command(core),
      described_info_command(core),   described_study_command(core), described_shrink_command(core),
      described_report_command(core)};
  commands.emplace_back().name = "drift";  // Which it has not.
  return commands;
}

void require_good_core(const Description& description, const std::string& thrown) {
  if (!thrown.empty()) refuse_input("hyrax-sim: the core throws while it is made: " + thrown);
  std::string sentences;
  for (const std::string& fault : faults_of(description))
    sentences +=
        fmt::format("{}hyrax-sim: the core {}: {}", sentences.empty() ? "" : "\n", description.core, fault);
  if (!sentences.empty()) refuse_input(sentences);
}

}  // namespace

int run_described_program(DescribedCore (*make_core)(), int argc, char** argv) {
  std::atomic<bool> has_changed = false;
  DescribedCore core;
  std::string thrown;
  try {
    core = controlled(make_core(), has_changed);
  } catch (const std::exception& error) {
    thrown = error.what();
  } catch (...) {
    thrown = "an exception that is no std::exception";
  }
  CommandProgram program;
  program.commands = described_commands(core);
  program.first_screen = first_screen(core.description, program.commands);
  program.require = [&](const Command& command, const std::string& name) {
    require_good_core(core.description, thrown);
    if (command.declare == nullptr)
      refuse_input(name + ": needs the paper's step; " + core.description.core +
                   " describes itself: use study frame-rate, diff");
  };
  // No command asks for the paper's.
  program.act = [&](const CommandAct& act) {
    const ExitCode exit_code = act(Core{});
    return has_changed ? ExitCode::not_strict_ieee : exit_code;
  };
  program.is_own = true;
  return run_commands(program, argc, argv);
}

}  // namespace hyrax
