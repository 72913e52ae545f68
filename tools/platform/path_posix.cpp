#include "tools/platform/path.h"

#include <cerrno>

#include <sys/stat.h>

namespace hyrax {
namespace {

// Its kind and mode; 0 if it cannot be looked at.
unsigned mode_of(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode : 0;
}

}  // namespace

std::string_view path_separators() { return "/"; }

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

}  // namespace hyrax
