#include "sim/scenario/scenario.h"

#include <cassert>
#include <utility>

#include "sim/scenario/frame_clock.h"

namespace hyrax {
namespace {

template <std::size_t... kKinds>
Action make_action_of(std::size_t kind, std::index_sequence<kKinds...>) {
  constexpr std::array<Action (*)(), sizeof...(kKinds)> kMakers = {
      [] { return Action(std::in_place_index<kKinds>); }...};
  return kMakers[kind]();
}

}  // namespace

Action make_action(std::size_t kind) {
  assert(kind < kActionNames.size());
  return make_action_of(kind, std::make_index_sequence<kActionNames.size()>());
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
