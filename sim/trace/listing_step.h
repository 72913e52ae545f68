// The paper's step as data, and which steps are the paper's with constants of their own.
#pragma once

#include <optional>
#include <string>

#include "sim/motion/state.h"

namespace hyrax {

struct TracedStep;

/// The paper's step with these constants, its constructor and setters included; canonical.
[[nodiscard]] TracedStep listing_step(const Constants& constants);

/// How a step stands to the paper's.
struct PaperMatch {
  /// The step is the paper's: its x, y, vx and vy are the paper's with these constants, whatever it does
  /// with further members.
  std::optional<Constants> constants = {};
  /// Else the first condition or expression that is not the paper's ("dt * vx"), or that only the paper has
  /// ("the paper's vx * AIR_DRAG is missing").
  std::string difference = {};
};

/// REQUIRES: a step as canonical() or read_step() return it.
[[nodiscard]] PaperMatch match_paper(const TracedStep& step);

}  // namespace hyrax
