// The names of physics models.
#pragma once

#include <string_view>

namespace hyrax {

/// The paper's model, by which class physics moves the sprite. It gets a new number when results change by
/// more than rounding.
inline constexpr std::string_view kPhysicsModel = "hyrax-physics/1";

/// Whether the name is of the paper's model, of any number. A core of one's own has another name.
[[nodiscard]] constexpr bool is_paper_model(std::string_view model) {
  return model.starts_with("hyrax-physics/");
}

/// Whether results of one can be compared with those of the other.
[[nodiscard]] constexpr bool is_same_model(std::string_view a, std::string_view b) {
  return a == b || (is_paper_model(a) && is_paper_model(b));
}

}  // namespace hyrax
