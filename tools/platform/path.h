// Paths: their parts, and what exists at them.
//
// std::filesystem does the same, but adds 100 kB and iostreams to programs that must stay small.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace hyrax {

/// "a/b.c.json" is folder "a/", stem "b.c" and extension ".json". A name that is all extension, as
/// ".json", is a stem.
struct FileName {
  std::string_view folder;  ///< With its last separator; empty if there is none.
  std::string_view stem;
  std::string_view extension;  ///< With its dot.
};

/// What may end the name of a folder.
[[nodiscard]] std::string_view path_separators();

/// The parts of a path, without looking at the disk. They refer to the path's text.
[[nodiscard]] FileName file_name(std::string_view path);

/// Whether something exists there, or may exist: if the system does not say, reading it will report why.
[[nodiscard]] bool is_there(const std::string& path);

/// std::fopen and std::remove for UTF-8 paths of any length, on Windows too, where /dev/stdin can be read as
/// well.
[[nodiscard]] std::FILE* open_file(const std::string& path, const char* mode);
void remove_file(const std::string& path);

// Links are followed.
[[nodiscard]] bool is_folder(const std::string& path);
[[nodiscard]] bool is_regular_file(const std::string& path);
[[nodiscard]] bool is_device_or_pipe(const std::string& path);

}  // namespace hyrax
