#include "sim/core/traced_core.h"

#include "sim/core/contact_kernel.h"
#include "sim/core/kernel_of.h"
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

}  // namespace hyrax
