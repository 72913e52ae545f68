// Libraries of scenarios, each with its golden folder.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// A library: a folder of scenarios, and its golden folder.
struct Library {
  std::string scenarios_folder;
  std::string golden_folder;
  std::string golden_option;  ///< --golden as given; empty if it was not.
};

/// The libraries that scenarios or folders of them belong to, each once: the nearest folder named
/// `scenarios`; with --golden also a folder that is in none. Scenarios outside of any have no accepted core.
[[nodiscard]] std::vector<Library> libraries_of(const std::vector<std::string>& arguments,
                                                const std::string& golden_option);

}  // namespace hyrax
