// What `bless` plans and did, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "tools/files/json.h"
#include "tools/hyrax-sim/command_line/print.h"
#include "tools/hyrax-sim/golden/blessing.h"
#include "tools/hyrax-sim/golden/difference_group.h"

namespace hyrax {

struct BlessReport {
  std::vector<Blessing> blessings;
  std::vector<std::string> pruned;  ///< Files of golden files without a scenario.
  bool is_written = false;
};

/// Why nothing is written, with the option that would allow it where there is one; empty: it is written.
[[nodiscard]] std::string refusal_sentence(const BlessReport& report);

/// What changes, old against new, by cause. REQUIRES: the groups do not outlive the report.
[[nodiscard]] std::vector<DifferenceGroup> groups_of(const BlessReport& report);

void print_plans(const BlessReport& report, const std::vector<DifferenceGroup>& groups,
                 const Printing& printing);
/// What was written, or would be.
void print_done(const BlessReport& report, bool is_dry_run);
[[nodiscard]] Json bless_json(const BlessReport& report, const std::vector<DifferenceGroup>& groups);

}  // namespace hyrax
