// Reads text files, and writes them atomically.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// ERRORS: Failure(cannot_access) "PATH: cannot be read: REASON"; Failure(bad_input) beyond 256 MiB.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// ERRORS: Failure(cannot_access) "PATH: cannot be written: REASON"; the file at `path` is then unchanged.
void write_text_file(const std::string& path, std::string_view text);

}  // namespace hyrax
