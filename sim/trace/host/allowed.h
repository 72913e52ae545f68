// What a core's header may use: what the numbers that record see.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hyrax::trace {

/// What the compiler makes of a program that includes the header.
struct HeaderOutput {
  std::string_view header;    ///< Its path.
  std::string_view compiled;  ///< Preprocessed, with line markers.
  std::string_view traced;    ///< The same with the numbers that record.
  std::string_view symbols;   ///< Of the compiled object, by `nm -C --format=sysv`.
};

/// Why the step cannot be told from what is recorded of it: memory outside the body, a call of what is not
/// recorded, the bits of a number, or a text that is another one where it is traced. Nothing: all that the
/// header uses is allowed. The lists are in allowed.cpp.
[[nodiscard]] std::optional<std::string> why_not_allowed(const HeaderOutput& output);

}  // namespace hyrax::trace
