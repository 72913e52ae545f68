// Reads scenarios in the format `hyrax-scenario/1`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"
#include "tools/files/json.h"

namespace hyrax {

/// The scenario in a JSON document.
/// @param source names the document in messages; usually its path.
/// @param fallback_name the name if the document has none: the file's stem.
/// ERRORS: Failure(bad_input) with a line for every error, "SOURCE: POINTER: RULE (found VALUE)".
[[nodiscard]] Scenario to_scenario(const Json& document, const std::string& source,
                                   const std::string& fallback_name);

/// Replaces a value of a file: a JSON Pointer, and a JSON text or a string without quotes.
struct Override {
  std::string pointer;
  std::string value;
};

/// ERRORS: as set_at's.
void replace_value(Json& document, const Override& given, const std::string& source);

/// The text of a scenario file, or of standard input for the path "-".
/// ERRORS: as read_text_file's; Failure(cannot_access) for a pipe or device named *.json (of another name, as
/// a shell's <(...) has, it is read), Failure(bad_input) for *.JSON, whose golden file would not be found.
[[nodiscard]] std::string read_scenario_text(const std::string& path);

/// The document of a scenario file, or of standard input for the path "-"; overrides applied.
/// ERRORS: as load_scenario's.
[[nodiscard]] Json load_scenario_document(const std::string& path, const std::vector<Override>& overrides);
/// The name of a scenario there that does not say its own: the file's stem.
[[nodiscard]] std::string fallback_name(const std::string& path);

/// Reads a scenario file, or standard input (named "stdin" if it gives no name) for the path "-"; overrides
/// applied.
/// ERRORS: Failure(cannot_access) if the file cannot be read; Failure(bad_input) as to_scenario's and
/// set_at's.
[[nodiscard]] Scenario load_scenario(const std::string& path, const std::vector<Override>& overrides = {});

/// Reads a scenario from the text of the file at `path`, which need not say its name.
[[nodiscard]] Scenario parse_scenario_file(std::string_view text, const std::string& path);

/// Reads a scenario from text that carries its name.
[[nodiscard]] Scenario parse_scenario(std::string_view text, const std::string& source);

}  // namespace hyrax
