#include <string>

#include "sim/core/contact_kernel.h"
#include "sim/core/core_of.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {

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
