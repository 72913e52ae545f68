#include "tools/app/library/blessing.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "tools/files/failure.h"
#include "tools/files/golden_place.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/file_state.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(ExitCode exit_code, const std::string& what) {
  throw Failure(exit_code, "hyrax-sim bless: --prune: nothing removed: " + what);
}

// Its golden files may be in another folder only where that one is named.
void require_no_link(const std::string& folder, const std::string& golden_folder) {
  const std::string any_scenario = (fs::path(folder) / "x.json").string();
  const fs::path root =
      fs::path(golden_folder.empty() ? golden_folder_of(any_scenario) : golden_folder + "/x").parent_path();
  fs::path below = fs::path(golden_place(any_scenario, golden_folder)->h5_path).parent_path();
  std::error_code unknown;
  for (; !below.empty(); below = below.parent_path()) {
    if (fs::is_symlink(below, unknown))
      refuse(ExitCode::bad_input,
             below.string() + ": is a link; name the folder that it leads to with --golden");
    if (below == root || below == below.root_path()) return;
  }
}

// An empty folder is more often one that is not mounted, or a submodule that was not fetched, than a library
// that was given up.
void require_scenarios(const std::string& folder) {
  if (!is_folder(folder) || !golden_place((fs::path(folder) / "x.json").string(), ""))
    refuse_input("hyrax-sim bless: --prune: must be a folder named scenarios or below one (found " + folder +
                 (is_there(folder) ? ")" : ", which does not exist)"));
  std::vector<Failure> unlisted;
  const std::vector<std::string> paths = list_scenarios({folder}, unlisted);
  if (!unlisted.empty())
    refuse(ExitCode::bad_input,
           std::string(unlisted.front().what()) + "; is it mounted, or a submodule that is not checked out?");
  for (const std::string& path : paths) {
    try {
      static_cast<void>(read_scenario_text(path));
    } catch (const Failure& failure) {
      refuse(failure.exit_code(), failure.what());
    }
  }
}

// The scenario may be behind a link to a folder that is not mounted.
void require_no_broken_link(const std::string& scenario_path) {
  std::error_code unknown;
  for (fs::path path = scenario_path; !path.empty() && path != path.root_path(); path = path.parent_path()) {
    if (fs::is_symlink(path, unknown) && !is_there(path.string()))
      refuse(ExitCode::cannot_access, path.string() + ": cannot be read: " + std::strerror(ENOENT));
    if (is_there(path.string())) return;
  }
}

bool is_written_summary(const std::string& path) try {
  return is_summary(read_text_file(path));
} catch (const Failure&) {
  return false;
}

[[noreturn]] void fail_to_remove(const std::string& path, int error_number) {
  throw Failure(ExitCode::cannot_access, path + ": cannot be removed: " + std::strerror(error_number));
}

void require_removable(const std::string& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  if (const int error = error_of_writing_in(folder.string())) fail_to_remove(path, error);
}

}  // namespace

Pruning find_prunable(const std::vector<std::string>& folders, const std::string& golden_folder,
                      const std::function<bool(const std::string& path)>& is_golden_h5) {
  for (const std::string& folder : folders) {
    require_scenarios(folder);
    require_no_link(folder, golden_folder);
  }
  Pruning pruning;
  for (const UnreferencedGolden& golden : find_unreferenced(folders, golden_folder)) {
    if (!golden.error.empty()) refuse(ExitCode::cannot_access, golden.error);
    require_no_broken_link(golden.scenario_path);
    for (const char* const suffix : {".h5", ".txt"}) {
      const std::string path = golden.path + suffix;
      std::error_code unknown;
      if (is_folder(path) || (!is_there(path) && !fs::is_symlink(path, unknown))) continue;
      const bool is_ours =
          file_name(path).extension == ".txt" ? is_written_summary(path) : is_golden_h5(path);
      if (is_ours) require_removable(path);
      (is_ours ? pruning.removed : pruning.left).push_back(path);
    }
  }
  return pruning;
}

void remove_files(const std::vector<std::string>& files) {
  for (const std::string& path : files)
    if (const int error = error_of_removing(path)) fail_to_remove(path, error);
}

}  // namespace hyrax
