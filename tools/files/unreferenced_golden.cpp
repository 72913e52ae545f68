#include "tools/files/unreferenced_golden.h"

#include <filesystem>
#include <map>
#include <optional>

#include "tools/files/golden_place.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

struct FolderPair {
  fs::path scenarios;
  fs::path golden;
  fs::path core;  // The folder of the accepted core, if it is in that of golden files; else empty.
};

// Nothing if the folder is neither named `scenarios` nor below one.
std::optional<FolderPair> folders_of(const std::string& argument, const std::string& golden_folder) {
  if (!is_folder(argument)) return std::nullopt;
  const std::string any_scenario = (fs::path(argument) / "x.json").string();
  if (!golden_place(any_scenario, "")) return std::nullopt;
  const GoldenPlace place = *golden_place(any_scenario, golden_folder);
  if (place.is_reserved) return std::nullopt;
  const fs::path golden = fs::path(place.h5_path).parent_path();
  const std::string in_core = (fs::path(argument) / "core/x.json").string();
  return FolderPair{argument, golden, golden_place(in_core, "")->is_reserved ? golden / "core" : ""};
}

bool is_part_of_golden_file(const fs::directory_entry& entry) {
  const fs::path suffix = entry.path().extension();
  return (suffix == ".h5" || suffix == ".txt") && !is_folder(entry.path().string());
}

// Those in this folder and below, by their path without suffix, so that both parts count once.
void add_unreferenced(const FolderPair& folders, const fs::path& folder,
                      std::map<std::string, UnreferencedGolden>& found) {
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.path() == folders.core) continue;
      std::error_code no_status;  // Then it is no folder.
      if (entry.is_directory(no_status) && !entry.is_symlink(no_status))
        add_unreferenced(folders, entry.path(), found);
      if (!is_part_of_golden_file(entry)) continue;
      const fs::path stem = fs::path(entry.path()).replace_extension();
      fs::path scenario = folders.scenarios / stem.lexically_relative(folders.golden);
      scenario += ".json";
      const bool is_given = is_there(scenario.string()) || fs::is_symlink(scenario, no_status);
      if (is_given && !is_folder(scenario.string())) continue;
      found[stem.lexically_normal().string()] = {stem.generic_string(), "", scenario.generic_string()};
    }
  } catch (const fs::filesystem_error& error) {
    const std::string path = folder.generic_string();
    found[path] = {path, path + ": cannot be read: " + error.code().message(), ""};
  }
}

}  // namespace

std::vector<UnreferencedGolden> find_unreferenced(const std::vector<std::string>& arguments,
                                                  const std::string& golden_folder) {
  std::map<std::string, UnreferencedGolden> found;
  for (const std::string& argument : arguments) {
    const auto folders = folders_of(argument, golden_folder);
    if (!folders || !is_folder(folders->golden.string())) continue;
    add_unreferenced(*folders, folders->golden, found);
  }
  std::vector<UnreferencedGolden> golden_files;
  for (auto& [key, golden] : found) golden_files.push_back(std::move(golden));
  return golden_files;
}

}  // namespace hyrax
