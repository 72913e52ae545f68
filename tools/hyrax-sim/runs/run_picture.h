// The picture of a run.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// Plays the scenario once more and draws it, whatever its file records: every row of the first
/// 50,000 steps, then as many as a picture can show. ERRORS: those of draw_run_figure.
void draw_run(const std::string& path, const Scenario& scenario);

}  // namespace hyrax
