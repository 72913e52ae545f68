#include "sim/described/described_scenario.h"

namespace hyrax {

std::string event_name(const Description& description, const DescribedAction& action) {
  const auto* const act = std::get_if<Act>(&action);
  return act != nullptr ? description.actions[act->action].name : std::string(kOwnEventNames[action.index()]);
}

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
