// Picture of the hard cases: scenarios down, invariants across.
#pragma once

#include <string>
#include <vector>

#include "sim/study/hard_cases/hard_case_table.h"

namespace hyrax {

/// A cell is a scenario with all that was made from it against one invariant: a part for each verdict (held,
/// known finding, broken) with its number of cases; empty where it was not asked.
[[nodiscard]] std::string hard_cases_figure_script(const std::vector<PlayedCase>& cases);

}  // namespace hyrax
