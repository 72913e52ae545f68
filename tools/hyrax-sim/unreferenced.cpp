#include <filesystem>
#include <map>

#include "tools/files/path.h"
#include "tools/hyrax-sim/check_verdict.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

struct FolderPair {
  fs::path scenarios;
  fs::path golden;
};

// Nothing where the folder is neither named `scenarios` nor below one.
std::optional<FolderPair> folders_of(const std::string& argument, const std::string& golden_folder) {
  if (!is_folder(argument)) return std::nullopt;
  const std::string any_scenario = (fs::path(argument) / "x.json").string();
  if (!golden_place(any_scenario, "")) return std::nullopt;
  return FolderPair{argument, fs::path(golden_place(any_scenario, golden_folder)->h5_path).parent_path()};
}

bool is_part_of_golden_file(const fs::directory_entry& entry) {
  const fs::path suffix = entry.path().extension();
  return (suffix == ".h5" || suffix == ".txt") && !is_folder(entry.path().string());
}

CheckVerdict verdict_on(const fs::path& path, CheckVerdict::Status status, ExitCode exit_code) {
  CheckVerdict verdict;
  verdict.path = path.generic_string();
  verdict.status = status;
  verdict.exit_code = exit_code;
  return verdict;
}

// By their path without suffix, so that both parts count once.
void add_unreferenced(const FolderPair& folders, std::map<std::string, CheckVerdict>& found) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folders.golden)) {
    if (!is_part_of_golden_file(entry)) continue;
    const fs::path stem = fs::path(entry.path()).replace_extension();
    fs::path scenario = folders.scenarios / stem.lexically_relative(folders.golden);
    scenario += ".json";
    if (is_there(scenario.string()) && !is_folder(scenario.string())) continue;
    found.emplace(stem.lexically_normal().string(),
                  verdict_on(stem, CheckVerdict::Status::unreferenced, ExitCode::disagreed));
  }
}

}  // namespace

std::vector<CheckVerdict> find_unreferenced(const std::vector<std::string>& arguments,
                                            const std::string& golden_folder) {
  std::map<std::string, CheckVerdict> found;
  for (const std::string& argument : arguments) {
    const auto folders = folders_of(argument, golden_folder);
    if (!folders || !is_folder(folders->golden.string())) continue;
    try {
      add_unreferenced(*folders, found);
    } catch (const fs::filesystem_error& error) {
      const std::string folder = folders->golden.generic_string();
      CheckVerdict verdict = verdict_on(folder, CheckVerdict::Status::failed, ExitCode::cannot_access);
      verdict.error = folder + ": cannot be read: " + error.code().message();
      found.emplace(folder, std::move(verdict));
    }
  }
  std::vector<CheckVerdict> verdicts;
  for (auto& [path, verdict] : found) verdicts.push_back(std::move(verdict));
  return verdicts;
}

}  // namespace hyrax
