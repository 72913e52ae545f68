// The parts of a path: text alone, without asking the disk.
//
// std::filesystem says the same, but brings a tenth of a megabyte, and with it all of iostreams, into a
// program that must stay small.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// "a/b.c.json" is folder "a/", stem "b.c" and extension ".json". A name that is all extension, as
/// ".json", is a stem.
struct FileName {
  std::string_view folder;  ///< With its last separator; empty where there is none.
  std::string_view stem;
  std::string_view extension;  ///< With its dot.
};

/// Refers to the path's text.
[[nodiscard]] FileName file_name(std::string_view path);

}  // namespace hyrax
