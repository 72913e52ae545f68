#include "sim/core/listing_core.h"

#include "sim/core/kernel_of.h"
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
          .shape = {constants},
          .constants = constants,
          .kernel = std::make_shared<const KernelOf<ListingCores>>(ListingCores{{{constants}}},
                                                                   StepFacts{.is_listing = true})};
}

}  // namespace hyrax
