// Values of a core that describes itself, and its description, as JSON and as text.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sim/described/description.h"
#include "tools/files/json.h"
#include "tools/files/json_reader.h"

namespace hyrax {

/// The name of a value that has names, true or false of a bool, else the number, a float32 shortest for its
/// type.
[[nodiscard]] Json value_json(const ValueInfo& value, Word word);
/// The same as a text without quotes, as in messages and summaries.
[[nodiscard]] std::string value_text(const ValueInfo& value, Word word);

/// What a number of that type can be; a float64 any that is finite. REQUIRES: not a bool.
[[nodiscard]] std::array<Word, 2> range_of(ValueType type);
/// What it may be in files: within its limits, or with a name, or all that its type can hold.
[[nodiscard]] std::array<Word, 2> file_limits(const ValueInfo& value);

/// Reads a value of that type, within its limits, by name or number where it has names.
/// @param is_limited false: a value that a run may come to, whatever limits and names bind files.
/// Nothing, and an error, if it breaks a rule; nothing if the place is missing.
[[nodiscard]] std::optional<Word> read_value(const JsonPlace& here, const ValueInfo& value,
                                             bool is_limited = true);

/// What a core is made of, as trajectory files, `info` and golden/core have it.
[[nodiscard]] Json description_json(const Description& description);

/// The description in a text of it, without ranges and undeclared parts, which it does not have.
/// @param source names the text in messages.
/// ERRORS: Failure(bad_input).
[[nodiscard]] Description parse_description(const std::string& text, const std::string& core,
                                            const std::string& source);

}  // namespace hyrax
