// What of a scenario changed, by JSON Pointer.
#pragma once

#include <string>

#include "sim/scenario/scenario.h"
#include "tools/files/json.h"

namespace hyrax {

/// "/start/vx_px_per_s 40000 -> 40001", changes joined by "; ", the first few of many; "none" stands for a
/// value that is not there. Only what changes the run: name, description, expect and $schema are left out.
/// Empty if both play the same.
[[nodiscard]] std::string scenario_changes(const Scenario& from, const Scenario& to);
/// The same of any two documents.
[[nodiscard]] std::string json_changes(const Json& from, const Json& to);

}  // namespace hyrax
