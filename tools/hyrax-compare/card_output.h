// The card as text of one screen, and as JSON.
#pragma once

#include <string>

#include "sim/card/card.h"
#include "tools/files/json.h"

namespace hyrax {

/// What was compared, as the user named it.
struct CardTitle {
  std::string candidate;
  std::string base;
};

[[nodiscard]] std::string card_text(const Card& card, const CardTitle& title);
[[nodiscard]] Json card_json(const Card& card, const CardTitle& title);

}  // namespace hyrax
