// A card as hyrax-compare prints it, and as its page shows it.
#pragma once

#include <string>

#include "sim/card/card.h"
#include "tools/report/result_page.h"

namespace hyrax {

/// A screen: what was compared, the lines without their table's head, the consequence.
/// @param card of card_result. @param headers of the cores that were compared.
[[nodiscard]] std::string card_text(const Result& card, const BeforeAfter<std::string>& headers);
[[nodiscard]] std::string card_json(const Result& card, const BeforeAfter<std::string>& headers);
[[nodiscard]] ShownResult shown_card(const Result& card, const BeforeAfter<std::string>& headers);

}  // namespace hyrax
