// How commands print: as fmt::print, but with what a terminal obeys escaped, and without an exception where
// standard output cannot be written (see printable.h).
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "tools/files/printable.h"

namespace hyrax {

template <class... Values>
void print_text(fmt::format_string<Values...> format, Values&&... values) {
  print_text(std::string_view(fmt::format(format, std::forward<Values>(values)...)));
}

}  // namespace hyrax
