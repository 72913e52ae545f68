// The data of a run's picture, as gnuplot's data blocks.
#pragma once

#include <string>

#include "tools/report/run_scene.h"

namespace hyrax {

/// The blocks $window, $later_windows, $ghosts, $start, $end, $moved, $unrecorded (x and y in px), $flown and
/// $beads (x, y in px, speed in px/s), and for each wall $WALL_sides, where the sprite touched it,
/// and $WALL_dots, where its centre was. A blank line ends an outline or a line.
[[nodiscard]] std::string run_data(const RunScene& scene);

}  // namespace hyrax
