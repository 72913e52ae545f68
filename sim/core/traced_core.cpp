#include "sim/core/traced_core.h"

#include "sim/core/contact_stepper.h"
#include "sim/core/stepper_of.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

struct TracedCores {
  using Core = TracedBody;

  std::shared_ptr<const StepProgram> program;

  [[nodiscard]] TracedBody make(const State& state) const { return {*program, state}; }
};

// The walls with which no path compares a position.
std::uint8_t others_of(const StepProgram& program) {
  return static_cast<std::uint8_t>(kAllWalls & ~program.walls());
}

}  // namespace

std::optional<Core> traced_core(const TracedStep& step) {
  const auto program = make_step_program(step);
  if (!program) return std::nullopt;
  const StepFacts facts{.has_further_members = step.members.size() > kMembersOfRows};
  Core core{.name = kPhysicsModel, .walls_of_rows = others_of(*program)};
  core.stepper = std::make_shared<const StepperOf<TracedCores>>(TracedCores{program}, facts);
  if (core.walls_of_rows != 0)
    core.stepper = std::make_shared<const ContactStepper>(core.stepper, program, std::nullopt);
  return core;
}

void complete_by_step(Core& core) {
  const std::optional<TracedStep> step = read_step(core.record.step);
  core.paper_match =
      step ? match_paper(*step)
           : PaperMatch{.difference = "a step that is not known: " + std::string(core.record.why_incomplete)};
  // Then the stepper's own contacts, those of the paper's step with the constants of its class, are right.
  const bool is_listing =
      core.constants && core.paper_match.constants && same_bits(*core.constants, *core.paper_match.constants);
  if (!is_listing) core.constant_names = {};  // The step has other numbers than its class.
  if (!is_paper_model(core.name) || !core.constants) core.constants = core.paper_match.constants;
  if (is_listing) return;
  const auto program = step ? make_step_program(*step) : nullptr;
  core.walls_of_rows = program ? others_of(*program) : kAllWalls;
  core.stepper =
      std::make_shared<const ContactStepper>(core.stepper, program, program ? std::nullopt : core.constants);
}

}  // namespace hyrax
