// Reads and writes scenarios of a core that describes itself, in the format `hyrax-scenario/1`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/described/described_scenario.h"
#include "tools/described/value_json.h"
#include "tools/files/json.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {

/// The scenario in a JSON document.
/// @param source names the document in messages; usually its path.
/// @param fallback_name the name if the document has none: the file's stem.
/// ERRORS: Failure(bad_input) with a line for every error, "SOURCE: POINTER: RULE (found VALUE)".
[[nodiscard]] DescribedScenario to_described_scenario(const Description& description, const Json& document,
                                                      const std::string& source,
                                                      const std::string& fallback_name);

/// Reads a scenario file, or standard input for the path "-"; overrides applied.
/// ERRORS: as load_scenario's.
[[nodiscard]] DescribedScenario load_described_scenario(const Description& description,
                                                        const std::string& path,
                                                        const std::vector<Override>& overrides = {});

/// The library of the current folder, `scenarios`; where there is none, ten seconds of the core's defaults.
/// ERRORS: as load_scenario's.
[[nodiscard]] std::vector<DescribedScenario> library_or_defaults(const Description& description);

/// Reads a scenario from text that carries its name.
[[nodiscard]] DescribedScenario parse_described_scenario(const Description& description,
                                                         std::string_view text, const std::string& source);

/// Keys in the format's order; reading it gives the same value again.
[[nodiscard]] Json to_json(const Description& description, const DescribedScenario& scenario);

/// An event without its time, as `{"strike": {"vx_px_per_s": 100}}`.
[[nodiscard]] Json event_json(const Description& description, const DescribedAction& action);

/// The JSON Schema of the core's scenarios, for editors. It refuses what the reader refuses, except for rules
/// that no schema can express.
[[nodiscard]] Json schema_json(const Description& description);

}  // namespace hyrax
