#include "tools/files/path.h"

#include <cerrno>

#include <sys/stat.h>

namespace hyrax {
namespace {

#ifdef _WIN32
constexpr std::string_view kSeparators = "/\\:";
#else
constexpr std::string_view kSeparators = "/";
#endif

#ifndef _WIN32
// Its kind and mode; 0 if it cannot be looked at.
unsigned mode_of(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode : 0;
}
#endif

}  // namespace

FileName file_name(std::string_view path) {
  const std::size_t separator = path.find_last_of(kSeparators);
  const std::size_t name_begin = separator == std::string_view::npos ? 0 : separator + 1;
  const std::string_view name = path.substr(name_begin);
  const std::size_t dot = name.rfind('.');
  const std::size_t stem_size = dot == std::string_view::npos || dot == 0 ? name.size() : dot;
  return {path.substr(0, name_begin), name.substr(0, stem_size), name.substr(stem_size)};
}

#ifndef _WIN32
std::FILE* open_file(const std::string& path, const char* mode) { return std::fopen(path.c_str(), mode); }

void remove_file(const std::string& path) { std::remove(path.c_str()); }

bool is_there(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 || (errno != ENOENT && errno != ENOTDIR);
}

bool is_folder(const std::string& path) { return S_ISDIR(mode_of(path)); }

bool is_regular_file(const std::string& path) { return S_ISREG(mode_of(path)); }

bool is_device_or_pipe(const std::string& path) {
  const unsigned mode = mode_of(path);
  return mode != 0 && !S_ISREG(mode) && !S_ISDIR(mode);
}
#endif

}  // namespace hyrax
