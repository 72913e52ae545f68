// The texts and arrows of a run's picture.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "tools/report/run_plot.h"
#include "tools/report/run_scene.h"

namespace hyrax {

/// "600 steps · 10 s · 60 Hz · window 1920 × 1080 px · sprite 128 × 128 px".
[[nodiscard]] std::string run_subtitle(const Scenario& scenario, const Columns& rows);

/// A note on what the picture does not show; empty if it shows all.
[[nodiscard]] std::string run_note(const Scenario& scenario, const Columns& rows, const RunScene& scene);

/// The commands that draw the labels of start, end and inputs, and the arrows of the throws.
[[nodiscard]] std::string run_labels(const RunPlot& plot, const RunScene& scene);

}  // namespace hyrax
