#include "sim/scenario/scenario.h"

namespace hyrax {

Action make_action(std::size_t kind) {
  static const std::array<Action, kActionNames.size()> kActions = {Fling(), Place(), Stop(),   Resize(),
                                                                   Hitch(), Grab(),  Release()};
  return kActions.at(kind);
}

const Parameter* set_parameters(const std::vector<Parameter>& parameters, const ConstantNames& names,
                                Constants& constants) {
  const Parameter* unknown = nullptr;
  for (const Parameter& parameter : parameters) {
    bool is_known = false;
    for (std::size_t place = 0; place < names.size(); ++place) {
      if (names[place].empty() || names[place] != parameter.name) continue;
      constants.*kConstantFields[place] = parameter.value;
      is_known = true;
    }
    if (!is_known && unknown == nullptr) unknown = &parameter;
  }
  return unknown;
}

Scenario without_texts(Scenario scenario) {
  scenario.name.clear();
  scenario.description.reset();
  scenario.schema.reset();
  scenario.expect.reset();
  return scenario;
}

bool plays_the_same(const Scenario& a, const Scenario& b) {
  const auto played = [](const Scenario& scenario) {
    Scenario run = without_texts(scenario);
    // A trace says its own length, so `steps` beside it adds nothing.
    if (std::holds_alternative<RecordedSteps>(run.clock.base)) run.length = std::monostate();
    return run;
  };
  return played(a) == played(b);
}

}  // namespace hyrax
