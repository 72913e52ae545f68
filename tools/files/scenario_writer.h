// Writes scenarios in the format `hyrax-scenario/1`.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "tools/files/json.h"

namespace hyrax {

/// Keys in the format's order, numbers shortest-round-trip; reading it gives the same value again.
[[nodiscard]] Json to_json(const Scenario& scenario);

/// A file's text: one top-level member per line, with a final newline.
[[nodiscard]] std::string scenario_file_text(const Scenario& scenario);

}  // namespace hyrax
