#include "tools/files/standard_streams.h"

#include <cstdio>
#include <string>

#include "tools/files/printable.h"

namespace hyrax {

void print_text(std::string_view text) { std::fputs(printable_lines(text).c_str(), stdout); }

bool is_all_printed() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

void print_error(std::string_view sentences) {
  std::fputs((printable_lines(sentences) + "\n").c_str(), stderr);
}

}  // namespace hyrax
