// A comparison as text and as JSON, whichever command made it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/compare/comparison.h"
#include "sim/compare/trajectory_comparer.h"
#include "tools/files/json.h"

namespace hyrax {

/// Where they are farthest apart, as "157 px apart at step 99 (1.65 s)"; "no position differs". One line.
/// @param left_out the inputs that make frames be left out at equal times.
[[nodiscard]] std::string distance_text(const Distance& distance,
                                        std::string_view left_out = "place, grab, release or resize");

/// "1 contact moved, 2 appeared", "no contact moved". One line.
[[nodiscard]] std::string contacts_text(const ContactCounts& contacts);

/// What a user of the program would see: distance, contacts, and the place of rest where it is another one.
/// One line.
[[nodiscard]] std::string comparison_sentence(const Comparison& comparison);

/// The same, the end of both runs, class and shape, the first difference with both values in decimal and hex
/// float and the rows around it, the contacts that moved (of each list the first 8, unless `lists_all`).
/// Complete lines, indented by two.
[[nodiscard]] std::string comparison_text(const Comparison& comparison, bool lists_all = false);

/// {"class", "max_px", "contacts_moved", "first_divergence"}
[[nodiscard]] Json::Object comparison_json(const Comparison& comparison);

/// The largest difference of a field, and where. A complete line.
[[nodiscard]] std::string worst_text(std::string_view field, const WorstDifference& worst);

/// "3 ulps"; empty without any, or beyond a million: they say how far rounding went, and nothing of more.
[[nodiscard]] std::string ulps_text(const std::optional<std::uint64_t>& ulps);

/// A line of a comparison, indented by two.
[[nodiscard]] std::string comparison_line(const char* what, const std::string& text);

}  // namespace hyrax
