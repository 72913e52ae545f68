#include "tools/files/scenario_list.h"

#include <algorithm>
#include <filesystem>

#include "tools/files/failure.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEntriesMax = 1'000'000;

// Collects the scenarios below a folder, links to folders followed.
class Walk {
 public:
  std::vector<std::string> paths;

  void enter(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    // A link to a folder above it has been visited already.
    if (std::find(above_.begin(), above_.end(), real) != above_.end()) return;
    above_.push_back(real);
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
      add(entry->path());
    if (error)
      throw Failure(ExitCode::cannot_access, folder.string() + ": cannot be read: " + error.message());
    above_.pop_back();
  }

 private:
  void add(const fs::path& path) {
    if (++entries_ > kEntriesMax)
      throw Failure(ExitCode::bad_input, path.string() + ": more than " + std::to_string(kEntriesMax) +
                                             " files; name the folders one by one");
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    const bool is_named_scenario = path.extension() == ".json";
    if (fs::is_directory(status)) return enter(path);
    // Reading a broken link reports it; without a suffix it may have been a folder of scenarios.
    const bool is_broken_link = !fs::exists(status) && (is_named_scenario || !path.has_extension());
    if (is_broken_link || (is_named_scenario && fs::is_regular_file(status)))
      paths.push_back(path.generic_string());
    else if (is_named_scenario)
      throw Failure(ExitCode::cannot_access, path.string() + ": cannot be read: is a pipe or a device");
  }

  std::vector<fs::path> above_;
  std::size_t entries_ = 0;
};

std::vector<std::string> scenarios_in(const std::string& folder) {
  Walk walk;
  walk.enter(folder);
  if (walk.paths.empty()) throw Failure(ExitCode::bad_input, folder + ": no scenario found (*.json)");
  std::sort(walk.paths.begin(), walk.paths.end());
  return std::move(walk.paths);
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

void set_default_folders(std::vector<std::string>& arguments, std::string& golden_folder) {
  if (!arguments.empty()) return;
  if (!is_folder("scenarios"))
    throw Failure(ExitCode::bad_input,
                  "scenarios: no such folder in the current one; name the scenarios or folders to check");
  arguments = {"scenarios"};
  if (golden_folder.empty()) golden_folder = "golden";
}

}  // namespace hyrax
