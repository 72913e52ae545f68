// Rules that a run of a core that describes itself breaks, and the smallest scenario that breaks one of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/described/described_run.h"

namespace hyrax {

struct BrokenRule {
  std::string rule = {};   ///< "throws", "finite", "always", "complete" or "expect".
  std::string of = {};     ///< The value, property, or rule of `expect` with its side; what is thrown.
  std::string found = {};  ///< A sentence without the rule.
  std::int64_t step = 0;   ///< Where it is known; else the last.

  [[nodiscard]] bool is_same_rule(const BrokenRule& other) const {
    return rule == other.rule && of == other.of;
  }
};

/// @param checks_description whether the state is held to be complete, to the run's end.
[[nodiscard]] std::vector<BrokenRule> broken_rules(const DescribedCore& core,
                                                   const DescribedScenario& scenario,
                                                   bool checks_description);

struct ShrunkScenario {
  DescribedScenario scenario = {};
  std::int64_t trials = 0;
  bool is_complete = true;  ///< Else the search was ended.
};
/// Shorter, and with fewer events and values, as long as it breaks the same rule. @param is_over ends the
/// search.
[[nodiscard]] ShrunkScenario shrunk(const DescribedCore& core, const DescribedScenario& scenario,
                                    const BrokenRule& broken, const std::function<bool()>& is_over);

}  // namespace hyrax
