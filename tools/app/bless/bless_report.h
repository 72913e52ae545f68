// What `bless` plans and did, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "tools/app/bless/blessing.h"
#include "tools/app/bless/core_acceptance.h"
#include "tools/app/bless/pruning.h"
#include "tools/app/causes/difference_group.h"
#include "tools/app/command_line/print.h"
#include "tools/files/json.h"

namespace hyrax {

struct BlessReport {
  std::vector<Blessing> blessings;
  Pruning pruning;
  std::vector<CoreAcceptance> cores;
  bool is_written = false;
};

/// Why nothing is written, with the option that would allow it where there is one; empty: it is written.
[[nodiscard]] std::string refusal_sentence(const BlessReport& report);

/// Of a report that was written: that some, but not all of it was; else empty.
[[nodiscard]] std::string unfinished_sentence(const BlessReport& report);

/// What changes, old against new, by cause, and against the accepted cores. REQUIRES: the groups do not
/// outlive the report.
[[nodiscard]] std::vector<DifferenceGroup> groups_of(const BlessReport& report, CoreChecks& cores);

void print_plans(const BlessReport& report, const std::vector<DifferenceGroup>& groups,
                 const CoreChecks& cores, const Printing& printing);
/// What was written, or would be.
void print_done(const BlessReport& report, bool is_dry_run);
[[nodiscard]] Json bless_json(const BlessReport& report, const std::vector<DifferenceGroup>& groups);

}  // namespace hyrax
