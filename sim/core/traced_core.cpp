#include "sim/core/traced_core.h"

#include "sim/core/contact_kernel.h"
#include "sim/core/kernel_of.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

struct TracedCores {
  using Core = TracedBody;

  std::shared_ptr<const StepProgram> program;

  [[nodiscard]] TracedBody make(const State& state) const { return {*program, state}; }
};

}  // namespace

std::optional<Core> traced_core(const TracedStep& step) {
  auto program = make_step_program(step);
  if (!program) return std::nullopt;
  const StepFacts facts{.has_further_members = step.members.size() > kMembersOfRows};
  Core core{.name = kPhysicsModel};
  core.kernel = std::make_shared<const KernelOf<TracedCores>>(TracedCores{std::move(program)}, facts);
  return core;
}

void complete_by_step(Core& core) {
  const std::optional<TracedStep> step = read_step(core.record.step);
  core.shape =
      step ? shape_of(*step)
           : StepShape{.difference = "a step that is not known: " + std::string(core.record.why_incomplete)};
  // Then the kernel's own contacts, those of the paper's step with the constants of its class, are right.
  const bool is_listing =
      core.constants && core.shape.constants && same_bits(*core.constants, *core.shape.constants);
  if (!is_paper_model(core.name) || !core.constants) core.constants = core.shape.constants;
  if (is_listing) return;
  core.kernel = std::make_shared<const ContactKernel>(core.kernel, step ? make_step_program(*step) : nullptr,
                                                      core.constants);
}

}  // namespace hyrax
