#include "sim/replay/traced_kernel.h"

#include <utility>

#include "sim/replay/contact_kernel.h"
#include "sim/replay/kernel_of.h"

namespace hyrax {
namespace {

struct TracedCores {
  using Core = TracedBody;

  std::shared_ptr<const StepProgram> program;

  [[nodiscard]] TracedBody make(const State& state) const { return {*program, state}; }
};

}  // namespace

std::unique_ptr<const Kernel> make_traced_kernel(const TracedStep& step) {
  constexpr std::size_t kShownByRows = 4;
  auto program = step.members.size() == kShownByRows ? make_step_program(step) : nullptr;
  if (!program) return nullptr;
  auto rows = std::make_shared<const KernelOf<TracedCores>>(TracedCores{program});
  return std::make_unique<ContactKernel>(std::move(rows), std::move(program));
}

}  // namespace hyrax
