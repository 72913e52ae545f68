#include "tools/store/output_guard.h"

#include <algorithm>
#include <cerrno>
#include <deque>
#include <filesystem>
#include <fstream>

#include "tools/files/failure.h"
#include "tools/files/golden_place.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"
#include "tools/platform/file_state.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// A large result of before is not read to see that it is none.
bool begins_as_json(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char first = 0;
  return file >> first && first == '{';
}

bool holds_scenario(const std::string& path) {
  if (!is_regular_file(path) || !begins_as_json(path)) return false;
  try {
    return read_text_file(path).find("\"hyrax-scenario/") != std::string::npos;
  } catch (const Failure&) {
    return false;  // Too large for a scenario, or unreadable.
  }
}

[[noreturn]] void refuse(const std::string& option, const std::string& what, const std::string& path) {
  refuse_input(option + ": would overwrite " + what + " (found " + path + "); name another file");
}

void require_folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !is_folder(folder.string())) fail_to_write(path, ENOENT);
}

bool is_beside_scenarios(const fs::path& folder) {
  return folder.filename() == "golden" && is_folder((folder.parent_path() / "scenarios").string());
}

}  // namespace

// The target of a path, and whether it, or a link on the way to it, is in a folder of that kind.
struct OutputGuard::Route {
  std::string end;  // The file's absolute path, without links and dots; it need not exist.
  bool is_in_golden = false;
  bool is_in_scenarios = false;
};

OutputGuard::Route OutputGuard::route_to(const std::string& path) const {
  constexpr int kLinksMax = 40;
  std::error_code unknown;
  const fs::path start = fs::absolute(path);
  std::deque<fs::path> ahead(start.begin(), start.end());
  std::set<std::string> golden_folders = golden_folders_;
  fs::path here;
  Route route;
  const auto check_folders = [&] {
    for (fs::path folder = here; folder.has_relative_path(); folder = folder.parent_path()) {
      if (is_beside_scenarios(folder) || golden_folders.count(folder.string()) > 0) route.is_in_golden = true;
      if (folder.filename() == "scenarios") route.is_in_scenarios = true;
    }
  };
  for (int links = 0; !ahead.empty();) {
    const fs::path part = ahead.front();
    ahead.pop_front();
    const fs::path next = here / part;
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      here = here.parent_path();
    } else if (fs::is_symlink(next, unknown) && ++links <= kLinksMax) {
      check_folders();
      if (is_beside_scenarios(next)) golden_folders.insert(fs::weakly_canonical(next, unknown).string());
      const fs::path target = fs::read_symlink(next, unknown);
      if (target.is_absolute()) here.clear();
      ahead.insert(ahead.begin(), target.begin(), target.end());
    } else {
      here = next;
    }
  }
  check_folders();
  route.end = here.string();
  return route;
}

OutputGuard::OutputGuard(const std::vector<std::string>& inputs, const std::string& golden_folder) {
  const auto add_golden_folder = [this](const std::string& folder) {
    if (!folder.empty()) golden_folders_.insert(route_to(folder).end);
  };
  add_golden_folder(golden_folder);
  for (const std::string& input : inputs) {
    if (const auto identity = identity_of(input)) inputs_.insert(*identity);
    add_golden_folder(golden_folder_of(input));
    if (const auto golden = golden_place(input, golden_folder))
      for (const std::string& path : {golden->h5_path, golden->txt_path})
        if (const auto identity = identity_of(path)) golden_files_.insert(*identity);
  }
}

void OutputGuard::admit(const std::string& option, const std::string& path,
                        const std::vector<std::string_view>& suffixes) {
  admit_any(option, path, suffixes);
  refuse_scenarios(option, path);
}

void OutputGuard::admit_file(const std::string& option, const std::string& path,
                             const std::vector<std::string_view>& suffixes) {
  admit(option, path, suffixes);
  require_folder_of(path);
}

void OutputGuard::admit_scenario(const std::string& option, const std::string& path, bool is_forced,
                                 const std::vector<std::string_view>& suffixes) {
  admit_any(option, path, suffixes);
  if (!is_forced && is_there(path)) refuse_input(path + ": exists; `--force` replaces it");
  require_folder_of(path);
}

void OutputGuard::admit_any(const std::string& option, const std::string& path,
                            const std::vector<std::string_view>& suffixes) {
  if (!suffixes.empty() && std::ranges::find(suffixes, file_name(path).extension) == suffixes.end())
    refuse_input(option + ": unknown suffix (found " + path + "); allowed: " + listed(suffixes));
  const Route route = route_to(path);
  const auto identity = identity_of(path);
  if (route.is_in_golden || (identity && golden_files_.count(*identity) > 0))
    refuse_input(option + ": is a golden file or in a golden folder (found " + path +
                 "); only `hyrax-sim bless` writes there");
  refuse_inputs(option, path);
  if (!outputs_.insert(route.end).second) refuse(option, "another output of this command", path);
}

void OutputGuard::admit_golden(const std::string& option, const std::string& path) const {
  refuse_inputs(option, path);
  refuse_scenarios(option, path);
}

void OutputGuard::refuse_inputs(const std::string& option, const std::string& path) const {
  const auto identity = identity_of(path);
  if (identity && inputs_.count(*identity) > 0) refuse(option, "an input of this command", path);
}

void OutputGuard::refuse_scenarios(const std::string& option, const std::string& path) const {
  const Route route = route_to(path);
  const bool is_scenario_by_name =
      route.is_in_scenarios && identity_of(path) && fs::path(route.end).extension() == ".json";
  if (is_scenario_by_name || holds_scenario(path)) refuse(option, "a scenario", path);
}

void require_writable(const std::string& path) {
  fs::path folder = fs::absolute(path).parent_path();
  while (!is_there(folder.string()) && folder.has_relative_path()) folder = folder.parent_path();
  if (!is_folder(folder.string())) fail_to_write(path, ENOTDIR);
  if (is_folder(path)) fail_to_write(path, EISDIR);
  if (const int error = error_of_writing_in(folder.string())) fail_to_write(path, error);
}

void make_folder(const std::string& path, const std::string& what) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw Failure(ExitCode::cannot_access, path + ": " + what + ": " + error.message());
}

}  // namespace hyrax
