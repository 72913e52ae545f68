#include "sim/search/contact_chance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/replay/replay.h"
#include "sim/search/draws.h"
#include "sim/trajectory/row_sink.h"

namespace hyrax {
namespace {

std::vector<Contact> contacts_of(const Core& core, const Scenario& scenario, std::int64_t steps) {
  ContactRecorder recorder;
  Replay run(core, scenario, recorder);
  run.play_to(steps);
  static_cast<void>(run.finish());
  return recorder.contacts();
}

// A point of the square of half-width `outer` without that of half-width `inner`, each as likely: the
// distance by the larger coordinate first, since its square grows as the area does, then a point of that
// square's rim.
Position between_squares(double inner, double outer, Draws& draws) {
  const double width = std::sqrt(draws.between(inner * inner, outer * outer));
  const double along = draws.between(-width, width);
  switch (draws.below(4)) {
    case 0:
      return {width, along};
    case 1:
      return {-width, along};
    case 2:
      return {along, width};
    default:
      return {along, -width};
  }
}

}  // namespace

ContactChance contact_chance(const Core& core, const Scenario& scenario, std::optional<double> margin_px,
                             std::uint64_t seed, std::int64_t starts) {
  constexpr std::int64_t kStepsCompared = 20'000;
  ContactChance chance;
  chance.seed = seed;
  chance.steps = std::min(step_count(scenario), kStepsCompared);
  const double kept = std::min(1.0, margin_px.value_or(chance.within_px) / chance.within_px);
  chance.drawn_part = 1.0 - kept * kept;
  if (kept >= 1.0) return chance;
  Scenario moved = scenario;
  const std::vector<Contact> contacts = contacts_of(core, moved, chance.steps);
  Draws draws(seed);
  for (std::int64_t start = 0; start < starts; ++start) {
    const Position by = between_squares(*margin_px, chance.within_px, draws);
    moved.start = {scenario.start.x_px + by.x_px, scenario.start.y_px + by.y_px};
    chance.changed.add(!std::ranges::equal(contacts_of(core, moved, chance.steps), contacts, has_same_steps));
  }
  return chance;
}

}  // namespace hyrax
