// What `check` reports of cores of the paper's interface besides its words.
#pragma once

#include <vector>

#include "tools/app/causes/difference_group.h"
#include "tools/app/check/check_verdict.h"
#include "tools/app/library/check_flow.h"

namespace hyrax {

[[nodiscard]] Json check_json(const CheckReport& report, const CoreChecks& cores);
/// The paths of the worst scenario of each of the first causes.
[[nodiscard]] std::vector<Figure> check_figures(const CheckReport& report);

}  // namespace hyrax
