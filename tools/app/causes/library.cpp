#include "tools/app/causes/library.h"

#include <algorithm>

#include "tools/files/golden_place.h"
#include "tools/files/path.h"

namespace hyrax {

std::vector<Library> libraries_of(const std::vector<std::string>& arguments,
                                  const std::string& golden_option) {
  std::vector<Library> libraries;
  for (const std::string& argument : arguments) {
    const bool is_library = is_folder(argument) && !golden_option.empty();
    const std::string path = is_folder(argument) ? argument + "/x.json" : argument;
    std::string scenarios = scenarios_folder_of(path);
    if (scenarios.empty() && is_library) scenarios = argument;
    if (scenarios.empty()) continue;
    const auto is_known = [&](const Library& library) { return library.scenarios_folder == scenarios; };
    if (std::ranges::any_of(libraries, is_known)) continue;
    libraries.push_back({scenarios, golden_folder_for(path, golden_option), golden_option});
  }
  return libraries;
}

}  // namespace hyrax
