#include "tools/files/check_status.h"

#include <algorithm>
#include <cassert>

#include "sim/result/number_text.h"

namespace hyrax {

std::string_view name_of(CheckStatus status) {
  constexpr std::string_view kNames[] = {"agreed", "disagreed", "missing", "failed", "unreferenced"};
  return kNames[static_cast<std::size_t>(status)];
}

ExitCode exit_code_of(CheckStatus status) {
  assert(status != CheckStatus::failed);
  if (status == CheckStatus::agreed) return ExitCode::agreed;
  return status == CheckStatus::missing ? ExitCode::golden_missing : ExitCode::disagreed;
}

std::string counts_sentence(const std::vector<CheckStatus>& statuses, std::int64_t folders_failed) {
  const auto count = [&](CheckStatus status) { return std::ranges::count(statuses, status); };
  const auto part = [&](const char* separator, CheckStatus status, const char* name) {
    return separator + std::to_string(count(status)) + " " + name;
  };
  const auto unreferenced = count(CheckStatus::unreferenced);
  std::string sentence = std::to_string(std::ssize(statuses) - unreferenced) + " checked";
  sentence += part(": ", CheckStatus::agreed, "agreed");
  sentence += part(", ", CheckStatus::disagreed, "disagreed");
  sentence += part(", ", CheckStatus::missing, "without golden file");
  sentence += part(", ", CheckStatus::failed, "failed");
  if (unreferenced > 0) sentence += part("; ", CheckStatus::unreferenced, "unreferenced");
  if (folders_failed > 0) sentence += "; " + plain_counted(folders_failed, "folder") + " failed";
  return sentence;
}

}  // namespace hyrax
