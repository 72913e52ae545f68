// A picture of one run: window, path, contacts and start, to scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/trajectory/columns.h"
#include "sim/trajectory/contact.h"

namespace hyrax {

/// The text of an SVG file that shows a run: the path of the sprite's centre coloured by speed, the
/// sprite's outline at the start, at the first bounces and at the end, the walls where it touched
/// them, an arrow for every velocity that it was given, and its inputs with their times. x and y have the
/// same scale. The same run gives the same text; its length has a bound, however long the run is.
/// @param rows in order of steps, with row 0 first; rows that are not finite are left out. Missing rows are
/// drawn as a dotted line.
/// @param contacts_counted all contacts by wall, if `contacts` has only the first of them: 30 are drawn.
/// Counted from `contacts` if left out.
/// REQUIRES: rows and contacts are of this scenario, whose events have frames.
[[nodiscard]] std::string run_svg(const Scenario& scenario, const Columns& rows,
                                  const std::vector<Contact>& contacts,
                                  const std::optional<WallCounts>& contacts_counted = std::nullopt);

}  // namespace hyrax
