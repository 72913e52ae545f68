// A scenario as a list of doubles: how the page's core gets it without reading JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// All that a replay needs: no name, description, `$schema` or `expect`. Integers are exact, a seed is two
/// halves. The layout is private to this file and to tools/report/page/record.js, which reads what was flung.
[[nodiscard]] std::vector<double> record_of(const Scenario& scenario);

/// The scenario of a record; nothing if it is cut short, too long, or has an unknown code.
[[nodiscard]] std::optional<Scenario> scenario_of(std::span<const double> record);

/// Where in its record a scenario's number at a JSON Pointer is; a seed is there and in the next number.
/// REQUIRES: the scenario has the number.
[[nodiscard]] std::size_t place_in_record(const Scenario& scenario, std::string_view pointer);

}  // namespace hyrax
