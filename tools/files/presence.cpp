#include "tools/files/presence.h"

#include <filesystem>
#include <system_error>

namespace hyrax {

bool is_there(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::status(path, unknown).type() != std::filesystem::file_type::not_found;
}

bool is_folder(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::is_directory(path, unknown);
}

}  // namespace hyrax
