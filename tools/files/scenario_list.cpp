#include "tools/files/scenario_list.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "tools/files/text_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEntriesMax = 1'000'000;

// Whether it is what `hyrax-sim schema` prints, which editors find beside the scenarios.
bool is_schema(const fs::path& path) {
  constexpr std::string_view kSuffix = ".schema.json";
  const std::string name = path.filename().string();
  if (!name.ends_with(kSuffix) || !is_regular_file(path.string())) return false;
  try {
    return read_text_file(path.string()).find("\"$schema\": \"https://json-schema.org/") != std::string::npos;
  } catch (const Failure&) {
    return false;  // Reading it as a scenario reports why.
  }
}

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
    if (error) paths.push_back(folder.generic_string());  // Reading it reports why.
    above_.pop_back();
  }

 private:
  void add(const fs::path& path) {
    if (++entries_ > kEntriesMax)
      refuse_input(path.string() + ": more than " + std::to_string(kEntriesMax) +
                   " files; name the folders one by one");
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    if (fs::is_directory(status)) return enter(path);
    // Without a suffix, a broken link may have been a folder of scenarios. Reading one reports it, as it does
    // a pipe, and a suffix in capitals.
    const std::string suffix = path.extension().string();
    const bool is_listed =
        suffix == ".json" ? !is_schema(path) : suffix == ".JSON" || (suffix.empty() && !fs::exists(status));
    if (is_listed) paths.push_back(path.generic_string());
  }

  std::vector<fs::path> above_;
  std::size_t entries_ = 0;
};

std::vector<std::string> list_each(const std::vector<std::string>& arguments,
                                   std::vector<Failure>& unlisted) {
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) {
    if (!is_folder(argument)) {
      paths.push_back(argument);
      continue;
    }
    try {
      Walk walk;
      walk.enter(argument);
      if (walk.paths.empty()) refuse_input(argument + ": no scenario found (*.json)");
      std::ranges::sort(walk.paths);
      std::ranges::move(walk.paths, std::back_inserter(paths));
    } catch (const Failure& failure) {
      unlisted.push_back(failure);
    }
  }
  return paths;
}

}  // namespace

std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments,
                                        std::vector<Failure>& unlisted) {
  std::vector<std::string> paths = list_each(arguments, unlisted);
  std::set<fs::path> listed;
  std::erase_if(paths, [&](const std::string& path) {
    return !listed.insert(fs::path(path).lexically_normal()).second;
  });
  return paths;
}

std::vector<std::string> list_scenarios(const std::vector<std::string>& arguments) {
  std::vector<Failure> unlisted;
  std::vector<std::string> paths = list_each(arguments, unlisted);
  if (!unlisted.empty()) throw unlisted.front();
  return paths;
}

void set_default_folder(std::vector<std::string>& arguments) {
  if (!arguments.empty()) return;
  if (!is_folder("scenarios"))
    refuse_input("scenarios: no such folder in the current one; name the scenarios or folders to check");
  arguments = {"scenarios"};
}

}  // namespace hyrax
