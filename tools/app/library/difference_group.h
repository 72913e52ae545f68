// Scenarios whose runs are not their golden files', grouped by cause: what `check` and `bless` show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cause/cause_groups.h"
#include "tools/app/library/report_documents.h"
#include "tools/app/library/scenario_verdict.h"

namespace hyrax {

struct DifferenceGroup {
  Cause cause;
  std::vector<const ScenarioVerdict*>
      scenarios;  ///< The worst first: by the largest distance, then by contacts.
  DifferenceClass difference = DifferenceClass::rounding;  ///< The widest.
  std::optional<double> max_px;                            ///< Of the worst.
  ContactCounts contacts;                                  ///< Summed.
  std::size_t settled = 0;                                 ///< Scenarios of which both runs have settled,
  std::optional<double> rest_shift_px;                     ///< and the largest distance of their final rows.
  bool is_proved = false;                                  ///< The accepted core gives the golden files.
};

/// The worst first.
[[nodiscard]] DifferenceGroup make_group(Cause cause, std::vector<const ScenarioVerdict*> scenarios);

/// {"operation", "detail", ...}, an entry of "groups"; scenarios in order of their paths.
[[nodiscard]] Json group_json(const DifferenceGroup& group);

/// "Contacts differ (class contacts): at most 812 px apart, 57 contacts moved, comes to rest up to 31 px
/// away." One line.
[[nodiscard]] std::string consequence_sentence(const DifferenceGroup& group);

/// Runs that become non-finite, what changed in the cores, the other groups: of each cause and consequence,
/// and the three worst scenarios. @param cores of each that changed its text: complete lines.
/// @param checked scenarios.
[[nodiscard]] std::vector<Paragraph> difference_paragraphs(const std::vector<DifferenceGroup>& groups,
                                                           const std::vector<std::string>& cores,
                                                           std::size_t checked);

}  // namespace hyrax
