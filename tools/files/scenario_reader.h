// Scenario files, `hyrax-scenario/1`: JSON to value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"
#include "tools/files/json.h"

namespace hyrax {

inline constexpr std::string_view kScenarioFormat = "hyrax-scenario/1";

/// The scenario that a JSON document holds.
/// @param source names the document in sentences, as its path does.
/// @param fallback_name the name where the document gives none: the file's stem.
/// ERRORS: Failure(bad_input) with a sentence for every wrong place, "SOURCE: POINTER: RULE, is VALUE".
[[nodiscard]] Scenario to_scenario(const Json& document, const std::string& source,
                                   const std::string& fallback_name);

/// A value put over the file's: a JSON Pointer and a JSON text, or a plain word for a text.
struct Override {
  std::string pointer;
  std::string value;
};

/// Puts it over what stands in the document, where missing objects on the way are made.
/// ERRORS: Failure(bad_input) "SOURCE: POINTER: ..." for what is no pointer or leads nowhere.
void put_over(Json& document, const Override& given, const std::string& source);

/// Reads a scenario file, or standard input (named "stdin" if it gives no name) for the path "-"; overrides
/// applied.
/// ERRORS: Failure(cannot_access) where the file cannot be read; Failure(bad_input) as above.
[[nodiscard]] Scenario load_scenario(const std::string& path, const std::vector<Override>& overrides = {});

/// Reads a scenario from text that carries its name.
[[nodiscard]] Scenario parse_scenario(std::string_view text, const std::string& source);

}  // namespace hyrax
