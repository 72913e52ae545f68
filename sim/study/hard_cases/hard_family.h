// How families of hard cases are built, and which there are.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/core.h"
#include "sim/study/hard_cases/hard_case.h"

namespace hyrax {

// Builds the members of one family.
class Family {
 public:
  explicit Family(const Scenario& base) : base_(base) { base_.expect.reset(); }

  [[nodiscard]] const Scenario& base() const { return base_; }
  HardCase& add(const std::string& what, const std::string& why, const Scenario& scenario) {
    HardCase member{.name = base_.name + "/" + what,
                    .made_from = base_.name,
                    .why = why,
                    .scenario = scenario,
                    .expected_failures = {}};
    member.scenario.name = base_.name;
    cases_.push_back(std::move(member));
    return cases_.back();
  }
  [[nodiscard]] std::vector<HardCase> take() { return std::move(cases_); }

 private:
  Scenario base_;
  std::vector<HardCase> cases_;
};

/// "1e-09"
[[nodiscard]] inline std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// The last moment of hitch_family; the first frame of less than that in which a scenario's sprite lands,
/// without its events.
inline constexpr std::int64_t kHitchAtRest = 500;
[[nodiscard]] std::optional<std::int64_t> first_landing(const Core& core, const Scenario& scenario);
/// Whether a drop ends at zero speed; by when it has, and is known to have settled, up to that rate.
[[nodiscard]] bool ends_at_zero_speed(const Core& core, double rate_hz);
[[nodiscard]] double time_to_rest_s(const Core& core, const Scenario& drop, double rate_max_hz);
inline constexpr double kRestFastest_hz = 1e3, kZenoFastest_hz = 1e4;  ///< Of the families.
/// The highest point of the start's flight in 600 frames, from a start at 0: at most 0.
[[nodiscard]] double apex_px(const Core& core, const Scenario& scenario);

/// The families: what is varied in the clock and length of a scenario ...
[[nodiscard]] std::vector<HardCase> any_frame_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> hitch_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> rest_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> zeno_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> any_jitter_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> fling_a_minute_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> trace_of_extremes_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> billion_steps_family(const Core& core, const Scenario& base);
/// ... and in its places and speeds.
[[nodiscard]] std::vector<HardCase> on_a_bound_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> grazing_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> corners_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> any_speed_family(const Core& core, const Scenario& base);
[[nodiscard]] std::vector<HardCase> far_outside_family(const Core& core, const Scenario& base);

}  // namespace hyrax
