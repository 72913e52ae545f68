// What the hard cases came to, as tables and in sums.
#pragma once

#include <string>
#include <vector>

#include "sim/study/hard_cases/hard_case.h"
#include "sim/result/table.h"

namespace hyrax {

struct PlayedCase {
  HardCase hard_case;
  HardCaseResult result;
};

/// Every case against every invariant that was asked of it: verdict, margin and worst step.
[[nodiscard]] Table hard_case_verdicts(const std::vector<PlayedCase>& cases);
/// The cases, and why they are hard.
[[nodiscard]] Table hard_case_list(const std::vector<PlayedCase>& cases);

/// One invariant over all cases, or over those made from one scenario.
struct InvariantSummary {
  std::int64_t asked = 0;
  std::int64_t held = 0;
  std::int64_t findings = 0;  ///< Known, and shown.
  std::int64_t broken = 0;    ///< Known findings that are gone, too.
  double margin = 0.0;        ///< The smallest of those that held.
  std::string nearest;        ///< The case it comes from.
};
[[nodiscard]] InvariantSummary summarise(const std::vector<PlayedCase>& cases, Invariant invariant,
                                         const std::string& made_from = "");

/// What was not as expected, one sentence each.
[[nodiscard]] std::vector<std::string> broken_sentences(const std::vector<PlayedCase>& cases);

[[nodiscard]] std::string_view name_of(CaseVerdict verdict);

}  // namespace hyrax
