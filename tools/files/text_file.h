// Reads text files, and writes them atomically.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace hyrax {

/// Reads any file from beginning to end. ERRORS: Failure(cannot_access) "PATH: cannot be read: REASON".
void read_pieces(const std::string& path, const std::function<void(std::string_view piece)>& take);

/// ERRORS: as read_pieces'; Failure(bad_input) beyond 256 MiB, and of a Git LFS pointer.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// @param may_replace whether a file may be there already.
/// ERRORS: Failure(cannot_access) "PATH: cannot be written: REASON"; the file at `path` is then unchanged.
void write_text_file(const std::string& path, std::string_view text, bool may_replace = true);

}  // namespace hyrax
