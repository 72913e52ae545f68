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
          .stepper = std::make_shared<const StepperOf<ListingCores>>(ListingCores{{{constants}}},
                                                                     StepFacts{.is_listing = true})};
}

}  // namespace hyrax
