// Scenarios whose runs are not their golden files', grouped by cause: what `check` and `bless` show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/cause/cause.h"
#include "sim/compare/comparison.h"
#include "tools/app/causes/core_check.h"
#include "tools/app/golden/golden_pair.h"
#include "tools/app/library/report_documents.h"
#include "tools/files/json.h"

namespace hyrax {

struct DifferenceGroup {
  Cause cause;
  std::vector<const PairVerdict*> scenarios;  ///< The worst first: by the largest distance, then by contacts.
  DifferenceClass difference = DifferenceClass::rounding;  ///< The widest.
  double max_px = 0.0;                                     ///< Of the worst.
  ContactCounts contacts;                                  ///< Summed.
  std::size_t settled = 0;                                 ///< Scenarios of which both runs have settled,
  std::optional<double> rest_shift_px;                     ///< and the largest distance of their final rows.
};

/// The non_finite_text of a run that differs; empty where it stays finite.
[[nodiscard]] std::string non_finite_text(const PairVerdict& scenario);

/// Runs that become non-finite first; then known causes by their size, then unknown ones. The cores take the
/// runs that differ because of them.
/// @param scenarios whose runs are not their golden files'; they outlive the groups.
[[nodiscard]] std::vector<DifferenceGroup> group_by_cause(const std::vector<const PairVerdict*>& scenarios,
                                                          CoreChecks& cores);

/// {"operation", "detail", ...}, an entry of "groups"; scenarios in order of their paths.
[[nodiscard]] Json group_json(const DifferenceGroup& group);

/// "Contacts differ (class contacts): at most 812 px apart, 57 contacts moved, comes to rest up to 31 px
/// away." One line.
[[nodiscard]] std::string consequence_sentence(const DifferenceGroup& group);

/// Of one scenario of the group: its comparison_sentence, or where it becomes non-finite.
[[nodiscard]] std::string scenario_consequence(const PairVerdict& scenario);

/// Runs that become non-finite, what changed in the cores, the other groups: of each cause and consequence,
/// and the three worst scenarios. @param checked scenarios.
[[nodiscard]] std::vector<Paragraph> difference_paragraphs(const std::vector<DifferenceGroup>& groups,
                                                           const std::vector<const CoreVerdict*>& cores,
                                                           std::size_t checked);

}  // namespace hyrax
