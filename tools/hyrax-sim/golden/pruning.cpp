#include "tools/hyrax-sim/golden/pruning.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <unistd.h>

#include "tools/files/failure.h"
#include "tools/files/golden_place.h"
#include "tools/files/path.h"
#include "tools/files/unreferenced_golden.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

void require_scenario_folder(const std::string& folder) {
  if (!is_folder(folder) || !golden_place((fs::path(folder) / "x.json").string(), ""))
    throw Failure(
        ExitCode::bad_input,
        "hyrax-sim bless: --prune: must be a folder named scenarios or below one (found " + folder + ")");
}

[[noreturn]] void fail_to_remove(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be removed: " + std::strerror(error_number));
}

}  // namespace

std::vector<std::string> find_prunable(const std::vector<std::string>& folders,
                                       const std::string& golden_folder) {
  for (const std::string& folder : folders) require_scenario_folder(folder);
  std::vector<std::string> files;
  for (const UnreferencedGolden& golden : find_unreferenced(folders, golden_folder)) {
    if (!golden.error.empty()) throw Failure(ExitCode::cannot_access, golden.error);
    for (const char* const suffix : {".h5", ".txt"}) {
      const std::string path = golden.path + suffix;
      if (!is_there(path) || is_folder(path)) continue;
      const fs::path folder = fs::absolute(path).parent_path();
      if (access(folder.c_str(), W_OK | X_OK) != 0) fail_to_remove(path, errno);
      files.push_back(path);
    }
  }
  return files;
}

void prune(const std::vector<std::string>& files) {
  for (const std::string& path : files)
    if (unlink(path.c_str()) != 0 && errno != ENOENT) fail_to_remove(path, errno);
}

}  // namespace hyrax
