// A comparison in words and in JSON.
#pragma once

#include <string>
#include <string_view>

#include "sim/compare/comparison.h"
#include "tools/files/json.h"

namespace hyrax {

/// What differs: class, first divergent step and field, both values in decimal and hex float, ulps,
/// the rows around it, the contacts that moved. Lines indented by two, each with its end.
[[nodiscard]] std::string difference_text(const Comparison& comparison);

/// The value of a field, as text: the flags of "contact" by their names, other values in decimal and hex
/// float.
[[nodiscard]] std::string field_value_text(std::string_view field, double value);

/// {"step", "field", "expected", "actual", "ulps"}, or null.
[[nodiscard]] Json divergence_json(const std::optional<Divergence>& divergence);

}  // namespace hyrax
