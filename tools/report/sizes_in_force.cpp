#include "tools/report/sizes_in_force.h"

#include <algorithm>
#include <iterator>

#include "sim/scenario/apply.h"

namespace hyrax {

SizesInForce::SizesInForce(const Scenario& scenario, const std::vector<std::int64_t>& frames)
    : changes_{{0, scenario.window, scenario.sprite}} {
  World world{.state = {}, .window = scenario.window, .sprite = scenario.sprite};
  for (std::size_t i = 0; i < scenario.events.size(); ++i) {
    apply(scenario.events[i].action, world);
    if (world.window != changes_.back().window || world.sprite != changes_.back().sprite)
      changes_.push_back({frames[i] + 1, world.window, world.sprite});
  }
}

const SizesInForce::Change& SizesInForce::at(std::int64_t step) const {
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), step,
                       [](std::int64_t value, const Change& change) { return value < change.first_step; });
  return *std::prev(after);
}

}  // namespace hyrax
