#include "sim/trajectory/run_summary.h"

#include <cassert>

namespace hyrax {

std::optional<double> at_rest_since_s(const Columns& rows) {
  assert(rows.size() > 0);
  RestAnchor anchor{rows.x_px.front(), rows.y_px.front(), rows.t_s.front()};
  for (std::size_t index = 1; index < rows.size(); ++index)
    if (anchor.moves_to(rows.x_px[index], rows.y_px[index])) anchor.t_s = rows.t_s[index];
  return anchor.at_rest_since_s(rows.t_s.back());
}

}  // namespace hyrax
