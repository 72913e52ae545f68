// The step of a core that describes itself as data, held to the compiled core.
#pragma once

#include <optional>
#include <string>

#include "sim/described/described_core.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

struct DescribedStep {
  std::optional<TracedStep> step = {};  ///< As read_step() returns it.
  std::string why_incomplete = {};      ///< As "more than 32 values"; empty: complete.
};

/// What the build recorded of the core, if both give the same bits from up to 100,000 random states and their
/// successors, the same on every machine. NaNs are alike.
[[nodiscard]] DescribedStep described_step(const DescribedCore& core);

}  // namespace hyrax
