#include "sim/scenario/scenario.h"

#include "sim/scenario/frame_clock.h"

namespace hyrax {

Action make_action(std::size_t kind) {
  static const std::array<Action, kActionNames.size()> kActions = {Fling(), Place(), Stop(),   Resize(),
                                                                   Hitch(), Grab(),  Release()};
  return kActions.at(kind);
}

Scenario without_texts(Scenario scenario) {
  scenario.name.clear();
  scenario.description.reset();
  scenario.schema.reset();
  scenario.expect.reset();
  return scenario;
}

bool plays_the_same(const Scenario& a, const Scenario& b) {
  // A trace says its own length, so `steps` beside it adds nothing.
  const bool same_length = a.length == b.length || (std::holds_alternative<RecordedSteps>(a.clock.base) &&
                                                    step_count(a) == step_count(b));
  return a.window == b.window && a.sprite == b.sprite && a.start == b.start &&
         a.start_velocity == b.start_velocity && a.clock == b.clock && same_length && a.events == b.events &&
         a.record_every == b.record_every;
}

}  // namespace hyrax
