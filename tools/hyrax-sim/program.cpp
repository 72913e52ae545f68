#include "tools/hyrax-sim/program.h"

#include <string>
#include <vector>

#include "sim/trajectory/physics_model.h"
#include "tools/app/command_line/command_program.h"
#include "tools/app/core/controlled_core.h"
#include "tools/app/core/core_requirements.h"

// All commands, in the order of the help. NAME.cpp defines NAME_command().
#define HYRAX_COMMANDS(COMMAND) \
  COMMAND(run)                  \
  COMMAND(check)                \
  COMMAND(bless)                \
  COMMAND(diff)                 \
  COMMAND(drift)                \
  COMMAND(study)                \
  COMMAND(sweep)                \
  COMMAND(report)               \
  COMMAND(new)                  \
  COMMAND(fuzz)                 \
  COMMAND(shrink)               \
  COMMAND(validate)             \
  COMMAND(schema)               \
  COMMAND(info)

namespace hyrax {

#define HYRAX_DECLARE(name) Command name##_command();
HYRAX_COMMANDS(HYRAX_DECLARE)

namespace {

std::vector<Command> all_commands() {
#define HYRAX_CALL(name) name##_command(),
  return {HYRAX_COMMANDS(HYRAX_CALL)};
}

// To this program's core.
bool applies(const Core& core, const Command& command) { return !command.needs_paper_step || core.constants; }

// Says what this program is, if it is not the one that the help is about.
std::string about_core(const Core& core) {
  if (is_paper_model(core.name)) return "";
  return fmt::format("This program's core is {}{}.\n\n", core.name,
                     core.constants ? ", the paper's step with constants of its own"
                                    : ", not the paper's step: commands that need it are left out");
}

std::string first_screen(const Core& core, const std::vector<Command>& commands) {
  return "hyrax-sim replays flings of the hyrax bit for bit, and reports what changed and how large the "
         "errors are.\n\n" +
         about_core(core) +
         "  hyrax-sim run scenarios/flings/first-fling.json --figure fling.svg\n"
         "  hyrax-sim check\n\n" +
         command_lists(commands, [&](const Command& command) { return applies(core, command); });
}

}  // namespace

int run_hyrax_sim(const Core& own_core, int argc, char** argv, bool is_own_program) {
  const Core core = with_header_names(own_core);
  const std::vector<Command> commands = all_commands();
  CommandProgram program;
  program.commands = commands;
  program.first_screen = first_screen(core, commands);
  program.require = [&](const Command& command, const std::string& name) {
    if (command.needs_paper_step) require_paper_core(core, name);
  };
  // The paper's step is proved to change none.
  program.act = [&](const CommandAct& act) { return act(core.record.is_listing ? core : controlled(core)); };
  program.is_own = is_own_program;
  return run_commands(program, argc, argv);
}

}  // namespace hyrax
