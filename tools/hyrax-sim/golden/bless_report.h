// What `bless` plans and did, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "tools/files/json.h"
#include "tools/hyrax-sim/command_line/print.h"
#include "tools/hyrax-sim/golden/blessing.h"

namespace hyrax {

struct BlessReport {
  std::vector<Blessing> blessings;
  std::vector<std::string> pruned;  ///< Files of golden files without a scenario.
  bool is_written = false;
};

/// Why nothing is written, with the option that would allow it where there is one; empty: it is written.
[[nodiscard]] std::string refusal_sentence(const BlessReport& report);

/// What changes, old against new.
void print_plans(const BlessReport& report, const Printing& printing);
/// What was written, or would be.
void print_done(const BlessReport& report, bool is_dry_run);
[[nodiscard]] Json bless_json(const BlessReport& report);

}  // namespace hyrax
