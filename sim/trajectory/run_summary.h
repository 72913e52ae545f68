// What a run ended with.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

/// Since when the sprite has settled. Judged by position, never by vy: on most displays the speed of a sprite
/// on the floor never becomes 0. Row 0 is the anchor at first; a row whose x or y is more than 0.5 px from
/// the anchor's becomes the anchor.
struct RestAnchor {
  static constexpr double kStill_px = 0.5;
  static constexpr double kLeastRest_s = 1.0;

  double x_px = 0.0;
  double y_px = 0.0;
  double t_s = 0.0;

  /// Whether a row at this position becomes the anchor. If so, the anchor moves there; its time is the
  /// caller's.
  bool moves_to(double row_x_px, double row_y_px) {
    if (!(std::fabs(row_x_px - x_px) > kStill_px) && !(std::fabs(row_y_px - y_px) > kStill_px)) return false;
    x_px = row_x_px;
    y_px = row_y_px;
    return true;
  }

  /// t in s of the anchor, if the last row is at least a second later.
  [[nodiscard]] std::optional<double> at_rest_since_s(double t_end_s) const {
    if (t_end_s - t_s >= kLeastRest_s) return t_s;
    return std::nullopt;
  }
};

struct RunSummary {
  std::int64_t steps = 0;           ///< Frames played.
  std::int64_t steps_computed = 0;  ///< The others repeat exactly and were not computed.
  double simulated_s = 0.0;
  WallCounts contacts{};
  WallCounts bounces{};  ///< The contacts without the resting contacts (RestingContact).
  std::optional<std::int64_t> resting_contact_from_step;  ///< RestingContact::from_step.
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

  /// REQUIRES: it has not settled.
  [[nodiscard]] std::string_view why_not_settled() const {
    return final.t_s < RestAnchor::kLeastRest_s ? "the run is shorter than 1 s" : "moved within the last 1 s";
  }
};

}  // namespace hyrax
