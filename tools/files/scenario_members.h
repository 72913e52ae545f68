// The members of a scenario document that have structure of their own: sizes, events, expect.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "sim/scenario/scenario.h"
#include "tools/files/json_reader.h"

namespace hyrax {

inline constexpr NumberRule kNotNegativeRule{0.0};

/// How a jitter's kind is written, in the order of Jitter::Kind.
struct JitterRule {
  std::string_view kind;
  std::string_view amount_key;
  NumberRule amount;
};
inline constexpr std::array<JitterRule, 3> kJitterRules = {{{"uniform", "fraction", {0.0, 1.0}},
                                                            {"normal", "sigma_s", {0.0, kFrameMax_s}},
                                                            {"missed_frames", "probability", {0.0, 1.0}}}};

// Errors are added to the problems of the place; the values in question are then 0 or missing.
[[nodiscard]] Size read_window(const JsonPlace& here);
[[nodiscard]] Size read_sprite(const JsonPlace& here);
[[nodiscard]] Expect read_expect(const JsonPlace& here);

/// Reads `scenario.events`, and checks each event, their order and the frames that they are due at.
/// @param is_clock_good whether the clock was read; without it no `at_s` has a frame.
/// @param steps of the run, if known.
void read_events(const JsonPlace& here, bool is_clock_good, std::optional<std::int64_t> steps,
                 Scenario& scenario);

}  // namespace hyrax
