// Places in a step, and edits at them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/explain/cause.h"
#include "sim/motion/statement.h"

namespace hyrax {

/// The statements of a step by their numbers in preorder: a wall before its body.
using StepSites = std::vector<std::size_t>;

/// A statement in the list that it stands in. Valid until the step is changed.
struct StepSite {
  StepStatements* list = nullptr;
  std::size_t index = 0;
  std::string_view wall;  ///< "left wall: " in the body of that wall; else empty.
  [[nodiscard]] Statement& statement() const { return (*list)[index]; }
};

/// All statements of the step in preorder. REQUIRES: a step with the walls of the listing, for their names.
[[nodiscard]] std::vector<StepSite> sites_of(StepStatements& step);

/// The step with an edit at each of the sites, from the last to the first, so that no edit moves another's
/// site.
template <class Edit>
[[nodiscard]] StepStatements edited(StepStatements step, const StepSites& sites, const Edit& edit) {
  for (auto site = sites.rbegin(); site != sites.rend(); ++site) edit(sites_of(step)[*site]);
  return step;
}

/// The operation that all the sites belong to, or kSeveralOperations.
[[nodiscard]] std::string_view operation_at(const std::vector<StepSite>& all, const StepSites& sites);

/// The texts of the statements at the sites, each with its wall, joined by "; ".
[[nodiscard]] std::string text_at(const std::vector<StepSite>& all, const StepSites& sites);

/// The sets of statements that are changed together: each alone, those of one operation and form (both of
/// drag, the two turns at the walls in x, all four), and the conditions of all walls.
[[nodiscard]] std::vector<StepSites> site_sets(const std::vector<StepSite>& all);

}  // namespace hyrax
