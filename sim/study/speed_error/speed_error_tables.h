// Speed against error as tables.
#pragma once

#include <vector>

#include "sim/study/speed_error/speed_error.h"
#include "sim/result/table.h"

namespace hyrax {

/// points, orders, cheapest, paper, clock; `machine` names where the times are from.
[[nodiscard]] std::vector<Table> tables_of(const SpeedError& study, const std::string& machine);

}  // namespace hyrax
