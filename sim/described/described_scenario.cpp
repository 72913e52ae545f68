#include "sim/described/described_scenario.h"

namespace hyrax {

bool plays_the_same(DescribedScenario a, DescribedScenario b) {
  for (DescribedScenario* const scenario : {&a, &b}) {
    scenario->name.clear();
    scenario->description.reset();
    scenario->schema.reset();
    scenario->core.reset();
    scenario->expect.reset();
  }
  return a == b;
}

}  // namespace hyrax
