#include "tools/platform/path.h"

namespace hyrax {

FileName file_name(std::string_view path) {
  const std::size_t separator = path.find_last_of(path_separators());
  const std::size_t name_begin = separator == std::string_view::npos ? 0 : separator + 1;
  const std::string_view name = path.substr(name_begin);
  const std::size_t dot = name.rfind('.');
  const std::size_t stem_size = dot == std::string_view::npos || dot == 0 ? name.size() : dot;
  return {path.substr(0, name_begin), name.substr(0, stem_size), name.substr(stem_size)};
}

}  // namespace hyrax
