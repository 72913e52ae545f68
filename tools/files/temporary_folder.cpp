#include "tools/files/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <unistd.h>

#include "tools/files/failure.h"
#include "tools/files/signal_cleanup.h"
#include "tools/files/text_file.h"

namespace hyrax {

TemporaryFolder::TemporaryFolder() {
  const char* const parent = std::getenv("TMPDIR");
  path_ = std::string(parent != nullptr && *parent != '\0' ? parent : "/tmp") + "/hyrax-sim-XXXXXX";
  if (mkdtemp(path_.data()) == nullptr)
    throw Failure(ExitCode::cannot_access, path_ + ": cannot be created: " + std::strerror(errno));
  remove_on_signal(path_);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::string path = path_ + "/" + name;
  write_text_file(path, text);
  return path;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  keep_on_signal(path_);
}

}  // namespace hyrax
