#include "sim/replay/listing_kernel.h"

#include "sim/motion/step.h"
#include "sim/replay/kernel_of.h"
#include "sim/replay/step_core.h"

namespace hyrax {
namespace {

struct ConstantsStep {
  Constants constants;

  void operator()(State& state, double dt_s, const Bounds& bounds) const {
    ListingStep(constants, AllParts{}, bounds)(state, dt_s);
  }
};

struct ListingCores {
  using Core = StepCore<ConstantsStep>;

  ConstantsStep step;

  [[nodiscard]] Core make(const State& state) const { return {step, state}; }
  [[nodiscard]] Constants constants() const { return step.constants; }
  [[nodiscard]] bool is_listing() const { return true; }
};

}  // namespace

std::unique_ptr<const Kernel> listing_kernel(const Constants& constants) {
  return std::make_unique<KernelOf<ListingCores>>(ListingCores{{constants}});
}

}  // namespace hyrax
