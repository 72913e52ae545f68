#include "tools/files/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "tools/files/failure.h"

namespace hyrax {

TemporaryFolder::TemporaryFolder() {
  const char* const parent = std::getenv("TMPDIR");
  path_ = std::string(parent != nullptr && *parent != '\0' ? parent : "/tmp") + "/hyrax-sim-XXXXXX";
  if (mkdtemp(path_.data()) == nullptr)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be created: " + std::strerror(errno));
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::string path = path_ + "/" + name;
  std::ofstream file(path, std::ios::binary);
  if (!(file << text).flush()) throw Failure(ExitCode::cannot_access, path + ": cannot be written");
  return path;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace hyrax
