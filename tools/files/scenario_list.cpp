#include "tools/files/scenario_list.h"

#include <algorithm>
#include <filesystem>

#include "tools/files/failure.h"
#include "tools/files/presence.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenarios_in(const std::string& folder) {
  std::vector<std::string> paths;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".json" && entry.is_regular_file())
        paths.push_back(entry.path().generic_string());
  } catch (const fs::filesystem_error& error) {
    throw Failure(ExitCode::cannot_access, folder + ": cannot be read: " + error.code().message());
  }
  if (paths.empty()) throw Failure(ExitCode::bad_input, folder + ": holds no scenario (*.json)");
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments) {
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) {
    if (!is_folder(argument)) {
      paths.push_back(argument);
      continue;
    }
    const std::vector<std::string> inside = scenarios_in(argument);
    paths.insert(paths.end(), inside.begin(), inside.end());
  }
  return paths;
}

}  // namespace hyrax
