#include "tools/app/library/check_flow.h"

#include <filesystem>
#include <span>

#include "sim/trajectory/state_hash.h"
#include "tools/files/text_file.h"
#include "tools/platform/process.h"

namespace hyrax {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) {
  std::error_code unknown;
  return fs::absolute(path, unknown).lexically_normal().string();
}

}  // namespace

LastFailed::LastFailed() {
  std::error_code error;
  const std::string folder = fs::current_path(error).string();
  const std::string cache = cache_folder();
  if (error || cache.empty()) return;
  file_ = (fs::path(cache) / "hyrax-sim" / hex(digest(std::as_bytes(std::span(folder))))).string();
  try {
    const std::string text = read_text_file(file_);
    for (std::size_t at = 0, end = 0; (end = text.find('\0', at)) != std::string::npos; at = end + 1)
      paths_.insert(text.substr(at, end - at));
  } catch (const Failure&) {
    // Nothing was recorded, or it cannot be read: all are checked.
  }
}

bool LastFailed::contains(const std::string& path) const { return paths_.contains(absolute(path)); }

void LastFailed::update(const std::vector<ScenarioVerdict*>& verdicts, OutputGuard& guard) {
  const std::set<std::string> before = paths_;
  for (const ScenarioVerdict* const verdict : verdicts)
    if (verdict->status == CheckStatus::agreed)
      paths_.erase(absolute(verdict->path));
    else
      paths_.insert(absolute(verdict->path));
  if (file_.empty() || paths_ == before) return;
  try {
    guard.admit("hyrax-sim check: cache", file_);
    std::error_code error;
    fs::create_directories(fs::path(file_).parent_path(), error);
    std::string text;  // The one byte that no path has ends each.
    for (const std::string& path : paths_) text.append(path).push_back('\0');
    write_text_file(file_, text);
  } catch (const Failure&) {
    // The verdicts do not depend on it.
  }
}

}  // namespace hyrax
