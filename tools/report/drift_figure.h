// The picture of a run compared with the reference.
#pragma once

#include <string>

#include "sim/reference/drift_run.h"
#include "sim/result/figure.h"

namespace hyrax {

/// Over one time axis, up to where the sprite is in resting contact: the distance from the exact fling; the
/// energy drift of flights and bounces as height, with the causes that moved it. Its title is what they say.
/// REQUIRES: rows were kept.
[[nodiscard]] Figure drift_figure(const DriftRun& run);

/// Its file in a folder, for a scenario of that name.
[[nodiscard]] std::string drift_figure_path(const std::string& folder, const std::string& name);

}  // namespace hyrax
