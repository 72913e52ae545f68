// How a run depends on its start: the margin, how far its end moves, how likely its contacts change.
#pragma once

#include <optional>
#include <string>

#include "sim/reference/margin.h"
#include "sim/result/table.h"
#include "sim/search/contact_chance.h"

namespace hyrax {

struct StartDependence {
  Margin margin;
  std::optional<ContactChance> contact_chance;  ///< If it was measured.
};

/// Whether rounding alone can change a contact.
[[nodiscard]] bool is_knife_edge(const Margin& margin);

/// "any start within ±0.27 px and px/s keeps all contacts; nearest decision: right wall, step 135".
[[nodiscard]] std::string margin_text(const Margin& margin);

/// The lines of the text: margin; chance, as "within ±1 px of the start, contacts change for 38 % of starts
/// (31 .. 45 %; 200 starts, seed 1)". @param all the table of d(end) / d(start), too.
[[nodiscard]] std::string start_text(const StartDependence& start, bool all);

/// d(end) / d(start) as rows of numbers.
[[nodiscard]] Table sensitivity_table(const Sensitivity& sensitivity);
/// The member "margin" of a document.
[[nodiscard]] Table margin_table(const StartDependence& start);

}  // namespace hyrax
