#include "sim/search/beyond_library.h"

#include <cmath>
#include <limits>
#include <vector>

#include "sim/replay/replay.h"
#include "sim/search/random_scenario.h"

namespace hyrax {
namespace {

constexpr std::uint64_t kSeed = 1;

double distance_px(const Row& row, const State& state) {
  return std::hypot(row.x_px - state.x_px, row.y_px - state.y_px);
}

double distance_of_ends_px(const RunSummary& a, const RunSummary& b) {
  if (same_bits(state_of(a.final), state_of(b.final))) return 0.0;
  const bool are_finite = !a.non_finite_step && !b.non_finite_step;
  return are_finite ? distance_px(a.final, state_of(b.final)) : std::numeric_limits<double>::infinity();
}

}  // namespace

BeyondLibrary measure_beyond(const Core& accepted, const Core& current, std::int64_t flings,
                             const ExactEnd& exact_end) {
  BeyondLibrary found;
  std::vector<double> apart_px, accepted_px, current_px;
  double farthest_px = 0.0;
  for (std::int64_t number = 0; number < flings; ++number) {
    Scenario scenario = random_fling(accepted, kSeed, static_cast<std::uint64_t>(number));
    const RunSummary before = replay(accepted, scenario);
    const RunSummary after = replay(current, scenario);
    found.other_bits.add(before.state_hash != after.state_hash);
    found.other_bounces.add(before.contacts != after.contacts);
    found.settles_in_one.add(before.at_rest_since_s.has_value() != after.at_rest_since_s.has_value());
    const double ends_px = distance_of_ends_px(before, after);
    const bool ends_elsewhere = ends_px > RestAnchor::kStill_px;
    found.ends_elsewhere.add(ends_elsewhere);
    if (ends_elsewhere) apart_px.push_back(ends_px);
    const std::optional<State> exact = before.non_finite_step || after.non_finite_step
                                           ? std::nullopt
                                           : exact_end(scenario, before.final.t_s);
    if (exact) {
      accepted_px.push_back(distance_px(before.final, *exact));
      current_px.push_back(distance_px(after.final, *exact));
    }
    if (!ends_elsewhere || ends_px <= farthest_px) continue;
    farthest_px = ends_px;
    found.farthest = std::move(scenario);
  }
  found.apart_px = band_of(apart_px);
  if (!accepted_px.empty())
    found.end_error_px = {quantile(std::move(accepted_px), 0.5), quantile(std::move(current_px), 0.5)};
  return found;
}

}  // namespace hyrax
