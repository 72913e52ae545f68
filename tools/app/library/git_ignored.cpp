// What was blessed and will be in no commit.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "tools/app/command_line/shell_command.h"
#include "tools/app/library/blessing.h"
#include "tools/platform/guarded_child.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

// Of a command line.
constexpr std::size_t kBytesMax = 60'000;

// Those that git ignores, of files in and below the folder: none outside of a repository, or without git.
std::vector<std::string> ignored_files(const std::string& folder, const std::vector<std::string>& files) {
  std::vector<std::string> ignored;
  for (auto file = files.begin(); file != files.end();) {
    std::vector<std::string> words = {"git", "-C", folder, "-c", "core.quotePath=off", "check-ignore", "--"};
    for (std::size_t bytes = 0; file != files.end() && bytes < kBytesMax; ++file) {
      words.push_back(fs::absolute(*file).lexically_normal().string());
      bytes += words.back().size();
    }
    std::istringstream lines(printed_by(words).value_or(""));
    for (std::string line; std::getline(lines, line);) ignored.push_back(line);
  }
  return ignored;
}

}  // namespace

std::vector<std::string> git_ignored_sentences(const BlessReport& report) {
  std::map<std::string, std::vector<std::string>> written;  // By golden folder.
  for (const Blessing& blessing : report.blessings)
    if (blessing.writes_golden_file() && !blessing.has_failed())
      for (const std::string& path : {blessing.verdict->golden->h5_path, blessing.verdict->golden->txt_path})
        written[blessing.verdict->golden_folder].push_back(path);
  std::error_code error;
  for (const CoreAcceptance& core : report.cores)
    if (core.why_not.empty())
      for (const auto& entry :
           fs::recursive_directory_iterator(accepted_core_folder(core.golden_folder), error))
        if (entry.is_regular_file(error)) written[core.golden_folder].push_back(entry.path().string());
  std::vector<std::string> sentences;
  for (const auto& [folder, files] : written)
    if (const std::vector<std::string> ignored = ignored_files(folder, files); !ignored.empty())
      sentences.push_back(fmt::format(
          "{}: ignored by git{}: another checkout will not have it; to see why: {}", ignored.front(),
          ignored.size() == 1 ? "" : fmt::format(" (and {} more)", ignored.size() - 1),
          shell_command({"git", "check-ignore", "-v", ignored.front()})));
  return sentences;
}

}  // namespace hyrax
