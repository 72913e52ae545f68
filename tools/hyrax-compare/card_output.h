// The card as text of one screen, as JSON, and as a page.
#pragma once

#include <string>
#include <vector>

#include "sim/card/card.h"
#include "tools/files/json.h"

namespace hyrax {

/// What was compared, as the user named it.
struct CardTitle {
  std::string candidate;
  std::string base;
};

/// A line of the card; without a name it continues the one before.
struct CardLine {
  std::string name;
  std::string text;
};
using CardText = std::vector<CardLine>;

/// What was compared: how many scenarios and flings, and what the numbers of a line are.
[[nodiscard]] std::string compared_text(const Card& card);
/// All but the consequence.
[[nodiscard]] CardText card_lines(const Card& card);
[[nodiscard]] std::string card_text(const Card& card, const CardTitle& title);
[[nodiscard]] Json card_json(const Card& card, const CardTitle& title);
/// @param command what made it. ERRORS: as write_result_page's.
void write_card_page(const std::string& path, const std::string& command, const Card& card,
                     const CardTitle& title);

}  // namespace hyrax
