#include "tools/files/golden_place.h"

#include <filesystem>
#include <map>

#include "tools/files/failure.h"
#include "tools/files/printable.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// A path below the current folder stays relative, as the user wrote it.
fs::path nearest_scenarios_folder(const fs::path& scenario_path) {
  for (fs::path folder = scenario_path.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    if (folder.filename() == "scenarios") return folder;
    if (folder == folder.root_path()) break;
  }
  return {};
}

// As lexically_normal, but after a link to a folder `..` is the parent of the folder linked to.
fs::path without_dots(const fs::path& path) {
  fs::path plain;
  std::error_code unknown;
  for (const fs::path& part : path) {
    if (part == "..") plain = fs::is_symlink(plain, unknown) ? fs::canonical(plain, unknown) : plain;
    plain = (plain / part).lexically_normal();
  }
  return plain;
}

// The file's path without dots, and the folder named `scenarios` in it; empty if there is none.
struct ScenarioPlace {
  fs::path path;
  fs::path scenarios;
};

ScenarioPlace scenario_place(const std::string& scenario_path) {
  ScenarioPlace place{.path = without_dots(scenario_path), .scenarios = {}};
  place.scenarios = nearest_scenarios_folder(place.path);
  if (!place.scenarios.empty() || place.path.is_absolute()) return place;
  std::error_code unknown;  // Of the empty path.
  place.path = without_dots(fs::absolute(scenario_path, unknown));
  place.scenarios = nearest_scenarios_folder(place.path);
  return place;
}

// The one that was given, or the one beside the folder `scenarios`; empty without either.
fs::path golden_folder(const fs::path& scenarios, const std::string& given) {
  if (!given.empty()) return given;
  return scenarios.empty() ? fs::path() : scenarios.parent_path() / "golden";
}

}  // namespace

std::optional<GoldenPlace> golden_place(const std::string& scenario_path, const std::string& given) {
  const auto [path, scenarios] = scenario_place(scenario_path);
  const fs::path folder = golden_folder(scenarios, given);
  if (folder.empty()) return std::nullopt;
  const fs::path below = scenarios.empty() ? path.filename() : path.lexically_relative(scenarios);
  fs::path file = folder / below;
  return GoldenPlace{.h5_path = file.replace_extension(".h5").generic_string(),
                     .txt_path = file.replace_extension(".txt").generic_string(),
                     .is_reserved = below.has_parent_path() && *below.begin() == "core",
                     .folder = folder.generic_string()};
}

std::string golden_folder_of(const std::string& scenario_path, const std::string& given) {
  return golden_folder(scenario_place(scenario_path).scenarios, given).generic_string();
}

std::string scenarios_folder_of(const std::string& scenario_path) {
  return scenario_place(scenario_path).scenarios.generic_string();
}

bool has_golden_file(const GoldenPlace& place) {
  if (place.is_reserved)
    refuse_input(place.h5_path +
                 ": is where the accepted core is kept; `core` is a reserved name at "
                 "the top of scenarios: rename that folder");
  for (const std::string& path : {place.h5_path, place.txt_path})
    if (is_device_or_pipe(path))
      refuse_input(path + ": is a pipe or a device; a golden file must be a regular file");
  return is_there(place.h5_path) && is_there(place.txt_path);
}

GoldenPlace required_golden_place(const std::string& scenario_path, const std::string& given) {
  if (scenario_path == "-") refuse_input("-: standard input has no golden file; name a scenario file");
  const auto place = golden_place(scenario_path, given);
  if (!place)
    refuse_input(scenario_path +
                 ": no folder `scenarios` above it; name the folder of its golden file with --golden DIR");
  return *place;
}

std::string missing_golden_sentence(const std::optional<GoldenPlace>& place) {
  if (!place)
    return "no golden file: no folder `scenarios` above it; --golden DIR names the folder to look in";
  const bool has_h5 = is_there(place->h5_path);
  std::string sentence = "no golden file at " + printable(place->h5_path);
  if (!has_h5 && !is_there(place->txt_path)) return sentence;
  return sentence.append(": ")
      .append(printable(has_h5 ? place->h5_path : place->txt_path))
      .append(" exists, but ")
      .append(printable(has_h5 ? place->txt_path : place->h5_path))
      .append(" is missing");
}

bool is_judged_by_hash(bool expects_hash, const std::optional<GoldenPlace>& place) {
  return expects_hash && !(place && (is_there(place->h5_path) || is_there(place->txt_path)));
}

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
