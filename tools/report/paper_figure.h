// Picture of the paper's claims and what became of them.
#pragma once

#include <string>
#include <vector>

#include "sim/study/paper/paper_claim.h"

namespace hyrax {

/// For each claim: section, the paper's words, verdict, number, and below what was measured, or when it
/// holds.
[[nodiscard]] std::string paper_figure_script(const std::vector<Claim>& claims);

}  // namespace hyrax
