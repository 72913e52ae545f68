// The smallest scenario that still fails.
//
// Source: A. Zeller, R. Hildebrandt, "Simplifying and isolating failure-inducing input", IEEE Transactions on
// Software Engineering 28:183-200, 2002: parts are removed in chunks that become smaller by half.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"

namespace hyrax {

/// What is made smaller: fewer frames first, then fewer events, less besides, a simpler clock, fewer digits.
struct Complexity {
  std::int64_t steps = 0;
  std::int64_t events = 0;
  std::int64_t extras = 0;  ///< `expect`, `record` where it is not 1, each parameter.
  std::int64_t clock = 0;   ///< 0: a rate, 1: one dt, 2: recorded, 3: jittered.
  std::int64_t digits = 0;  ///< Of all numbers, in decimal.
  /// The simpler is less.
  auto operator<=>(const Complexity&) const = default;  // NOLINT(modernize-use-nullptr): there is no 0.
};
/// REQUIRES: a plain scenario (scenario_edit.h).
[[nodiscard]] Complexity complexity_of(const Scenario& scenario);

struct ShrinkOptions {
  std::int64_t trials_max = 20'000;
  /// Whether to stop before that; nothing: never.
  std::function<bool()> is_over = {};
  /// after_frames, where the core cannot simply be played; gives nothing where it cannot be played so far.
  std::function<std::optional<Scenario>(const Scenario&, std::int64_t frames)> start_later = {};
  /// Called before each trial with their number so far and the smallest scenario yet.
  std::function<void(std::int64_t trials, const Scenario& smallest)> report = {};
};

struct Shrunk {
  Scenario scenario;
  std::int64_t trials = 0;   ///< Scenarios that were tried.
  bool fails_again = false;  ///< Whether `failing` itself fails when it is tried.
  bool is_complete = false;  ///< Nothing simpler is left to try; else a limit ended the search.
};

/// Tries simpler scenarios in a fixed order as long as one of them fails: frames cut off at the end, a start
/// from a later row's state, frames and events left out, a fixed dt for jitter, rounder numbers.
/// Deterministic if `fails` is. If `failing` does not fail when it is tried, it is returned as it is.
/// @param fails whether a valid scenario still fails as `failing` does.
/// REQUIRES: the events of `failing` have frames.
[[nodiscard]] Shrunk shrink(const Core& core, const Scenario& failing,
                            const std::function<bool(const Scenario&)>& fails,
                            const ShrinkOptions& options = {});

}  // namespace hyrax
