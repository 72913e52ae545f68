// The card as plain tables and figures.
#pragma once

#include <vector>

#include "sim/card/card.h"
#include "sim/result/figure.h"
#include "sim/result/table.h"

namespace hyrax {

/// What differs, one by one: scenarios, invariants, claims, recordings. Tables without rows are left out.
[[nodiscard]] std::vector<Table> card_tables(const Card& card);

/// Where flings land, over displays and against the exact motion, and their energy by cause; base and
/// candidate in the same plot.
[[nodiscard]] std::vector<Figure> card_figures(const Card& card);

}  // namespace hyrax
