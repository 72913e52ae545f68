#include "sim/replay/traced_kernel.h"

#include <utility>

#include "sim/replay/kernel_of.h"
#include "sim/trace/step_player.h"

namespace hyrax {
namespace {

// Its contacts are not known to a kernel.
class RowToldBody : private TracedBody {
 public:
  using TracedBody::resetVelocity, TracedBody::setPos, TracedBody::setVelocity, TracedBody::update;
  using TracedBody::TracedBody, TracedBody::vx, TracedBody::vy, TracedBody::x, TracedBody::y;
};

template <class Body>
struct TracedCores {
  using Core = Body;

  std::shared_ptr<const StepProgram> program;

  [[nodiscard]] Body make(const State& state) const { return {*program, state}; }
};

}  // namespace

std::unique_ptr<const Kernel> make_traced_kernel(const TracedStep& step, ContactSource contacts) {
  constexpr std::size_t kMembersOfRows = 4;
  auto program = step.members.size() == kMembersOfRows ? make_step_program(step) : nullptr;
  if (!program) return nullptr;
  if (contacts == ContactSource::rows)
    return std::make_unique<KernelOf<TracedCores<RowToldBody>>>(TracedCores<RowToldBody>{std::move(program)});
  return std::make_unique<KernelOf<TracedCores<TracedBody>>>(TracedCores<TracedBody>{std::move(program)});
}

}  // namespace hyrax
