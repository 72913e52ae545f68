// A comparison as text and as JSON.
#pragma once

#include <string>
#include <string_view>

#include "sim/compare/comparison.h"
#include "tools/files/json.h"
#include "tools/store/provenance.h"

namespace hyrax {

/// What differs: class, first divergent step and field, both values in decimal and hex float, ulps,
/// the rows around it, the contacts that moved (of each list the first 8, unless `lists_all`). Complete
/// lines, indented by two.
[[nodiscard]] std::string difference_text(const Comparison& comparison, bool lists_all = false);

/// Which build settings of the programs that made two files differ, and what that usually means for a
/// difference of that class; nothing: they agree. Complete lines, indented by two.
[[nodiscard]] std::string build_text(const Provenance& a, const Provenance& b,
                                     const std::optional<DifferenceClass>& difference);

/// The value of a field: the flags of "contact" by name, other values in decimal and hex float.
[[nodiscard]] std::string field_value_text(std::string_view field, double value);

/// " px" and so on; empty for a field without unit.
[[nodiscard]] std::string unit_of(std::string_view field);

/// "3 ulps"; empty without any, or beyond a million: they say how far rounding went, and nothing of more.
[[nodiscard]] std::string ulps_text(const std::optional<std::uint64_t>& ulps);

/// The largest distance of two rows in px: 0 if no position differs.
[[nodiscard]] Json max_px_json(const Comparison& comparison);

/// {"step", "field", "expected", "actual", "ulps"}, or null.
[[nodiscard]] Json divergence_json(const std::optional<Divergence>& divergence);

}  // namespace hyrax
