// Rules that a run of a core that describes itself breaks, and the smallest scenario that breaks one of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/described/described_run.h"

namespace hyrax {

/// What every run must hold: it throws nothing, stays finite, keeps its properties; the description is
/// complete and a second run the same; stopped and resumed it goes on as without a stop.
inline constexpr std::array<std::string_view, 5> kGeneralRules = {"throws", "finite", "always", "complete",
                                                                  "resumed"};

struct BrokenRule {
  std::string rule = {};   ///< One of kGeneralRules, or "expect".
  std::string of = {};     ///< The value, property, or rule of `expect` with its side; what is thrown.
  std::string found = {};  ///< A sentence without the rule.
  std::int64_t step = 0;   ///< Where it is known; else the last.

  /// Two texts that are thrown may differ in their numbers.
  [[nodiscard]] bool is_same_rule(const BrokenRule& other) const;
};

/// To the run's end. @param asks for a rule; those that it does not ask for cost nothing and may be left out.
[[nodiscard]] std::vector<BrokenRule> broken_rules(const DescribedCore& core,
                                                   const DescribedScenario& scenario,
                                                   const std::function<bool(std::string_view rule)>& asks);

struct ShrunkScenario {
  DescribedScenario scenario = {};
  BrokenRule broken = {};  ///< By it.
  std::int64_t trials = 0;
  bool is_complete = true;  ///< Else the search was ended.
};
/// What a scenario breaks, if it is the rule that is asked for.
using FindBroken = std::function<std::vector<BrokenRule>(const DescribedScenario& scenario,
                                                         const std::function<bool(std::string_view)>& asks)>;
/// Shorter, and with fewer events and values, as long as it breaks the same rule. @param is_over ends the
/// search.
[[nodiscard]] ShrunkScenario shrunk(const FindBroken& find, const DescribedScenario& scenario,
                                    const BrokenRule& broken, const std::function<bool()>& is_over);

}  // namespace hyrax
