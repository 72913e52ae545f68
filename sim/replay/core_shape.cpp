#include "sim/replay/core_shape.h"

#include "sim/replay/core_constants.h"
#include "sim/trace/core_record.h"
#include "sim/trace/step_text.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {

const StepShape& core_shape() {
  static const StepShape shape = [] {
    const std::optional<TracedStep> step = read_step(core_record().step);
    if (step) return shape_of(*step);
    return StepShape{.difference = "a step that is not known: " + std::string(core_record().why_incomplete)};
  }();
  return shape;
}

std::optional<Constants> measured_constants() {
  return is_paper_model(core_model()) ? core_constants() : core_shape().constants;
}

}  // namespace hyrax
