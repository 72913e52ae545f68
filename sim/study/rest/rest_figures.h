// The figures of the study rest.
#pragma once

#include <vector>

#include "sim/result/figure.h"
#include "sim/study/rest/rest_map.h"

namespace hyrax {

/// Final states against the display rate, time to settle against the display rate, effective restitution
/// against the phase of the contact.
[[nodiscard]] std::vector<Figure> rest_figures(const RestResults& results);

}  // namespace hyrax
