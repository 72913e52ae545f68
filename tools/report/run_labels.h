// The words of a run's picture, and the arrows that go with them.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "tools/report/run_plot.h"
#include "tools/report/run_scene.h"

namespace hyrax {

/// "600 steps · 10 s · 60 Hz · window 1920 × 1080 px · sprite 128 × 128 px".
[[nodiscard]] std::string run_subtitle(const Scenario& scenario, const Columns& rows);

/// What the picture does not show, if there is such a thing.
[[nodiscard]] std::string run_note(const Scenario& scenario, const Columns& rows, const RunScene& scene);

/// The commands that draw the words at start and end and the arrows of the throws.
[[nodiscard]] std::string run_labels(const RunPlot& plot, const RunScene& scene);

}  // namespace hyrax
