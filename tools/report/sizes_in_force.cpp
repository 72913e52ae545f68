#include "tools/report/sizes_in_force.h"

#include <algorithm>
#include <iterator>

namespace hyrax {

SizesInForce::SizesInForce(const Scenario& scenario, const std::vector<std::int64_t>& frames)
    : changes_{{0, scenario.window, scenario.sprite}} {
  for (std::size_t i = 0; i < scenario.events.size(); ++i) {
    const auto* const resize = std::get_if<Resize>(&scenario.events[i].action);
    if (resize == nullptr) continue;
    const Change& before = changes_.back();
    changes_.push_back(
        {frames[i] + 1, resize->window.value_or(before.window), resize->sprite.value_or(before.sprite)});
  }
}

const SizesInForce::Change& SizesInForce::at(std::int64_t step) const {
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), step,
                       [](std::int64_t value, const Change& change) { return value < change.first_step; });
  return *std::prev(after);
}

}  // namespace hyrax
