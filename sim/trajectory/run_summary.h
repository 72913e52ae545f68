// What a run came to.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/trajectory/contact.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

struct RunSummary {
  std::int64_t steps = 0;           ///< Frames played.
  std::int64_t steps_computed = 0;  ///< The others repeat exactly and were not computed.
  double simulated_s = 0.0;
  WallCounts contacts{};
  WallCounts clamped_steps{};
  std::int64_t rest_steps = 0;  ///< Steps in which the rest rule zeroed the vertical speed.
  Row final;
  std::optional<double> at_rest_since_s;
  std::optional<std::int64_t> periodic_from_step;  ///< At fixed dt with no event to come, as far as noticed.
  std::int64_t period_steps = 0;
  Digest state_hash{};
  std::optional<std::int64_t> non_finite_step;     ///< The run ended here.
  std::optional<std::int64_t> out_of_bounds_step;  ///< First row outside; looked for on request.
  bool had_gravity = false;                        ///< A step with dt > 0.
  bool had_drag = false;                           ///< A step.
  bool had_friction = false;
};

}  // namespace hyrax
