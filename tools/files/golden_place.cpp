#include "tools/files/golden_place.h"

#include <filesystem>

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

}  // namespace hyrax
