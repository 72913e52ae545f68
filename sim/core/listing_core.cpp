#include "sim/core/listing_core.h"

#include "sim/core/stepper_of.h"
#include "sim/motion/step.h"
#include "sim/trajectory/physics_model.h"

namespace hyrax {
namespace {

struct ConstantsStep {
  Constants constants;

  void operator()(State& state, double dt_s, const Bounds& bounds) const {
    ListingStep(constants, AllParts{}, bounds)(state, dt_s);
  }
};

struct ListingCores : StepCores<ConstantsStep> {
  [[nodiscard]] Constants constants() const { return step.constants; }
};

}  // namespace

Core listing_core(const Constants& constants) {
  return {.name = kPhysicsModel,
          .paper_match = {constants},
          .constants = constants,
          .constant_names = kPaperNames,
          .stepper = std::make_shared<const StepperOf<ListingCores>>(ListingCores{{{constants}}},
                                                                     StepFacts{.is_listing = true})};
}

std::optional<Core> with_parameters(const Core& core, const std::vector<Parameter>& parameters) {
  if (parameters == core.parameters) return core;
  const Core& own = core.own ? *core.own : core;
  if (parameters.empty()) return own;
  if (!own.paper_match.constants) return std::nullopt;
  Constants constants = *own.paper_match.constants;
  if (set_parameters(parameters, own.constant_names, constants) != nullptr) return std::nullopt;
  Core changed = listing_core(constants);
  changed.name = own.name;
  changed.record = own.record;
  changed.constant_names = own.constant_names;
  changed.parameters = parameters;
  changed.own = std::make_shared<const Core>(own);
  return changed;
}

}  // namespace hyrax
