#include "tools/files/summary_text.h"

namespace hyrax {
namespace {

constexpr std::size_t kHashDigits = 32;

bool is_hash(const std::string& text) {
  return text.size() == kHashDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string hash_of(const std::string& text, std::string_view key) {
  const std::string hash = line_value(text, key);
  return is_hash(hash) ? hash : "";
}

}  // namespace

std::string contacts_text(const RunSummary& run, bool names_all) {
  const std::int64_t bounces = run.bounces.ground;
  const std::int64_t resting = run.contacts.ground - bounces;
  const auto counted = [](std::int64_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  std::string text;
  for (const Wall wall : kWalls) {
    if (run.contacts[wall] == 0 && !names_all) continue;
    text += (text.empty() ? "" : ", ") + std::string(name_of(wall)) + " ";
    if (wall != Wall::ground || (resting == 0 && !run.resting_contact_from_step))
      text += std::to_string(run.contacts[wall]);
    else if (!run.resting_contact_from_step)
      text += counted(bounces, "bounce") + " and " + counted(resting, "resting contact");
    else
      text += (bounces > 0 ? counted(bounces, "bounce") + ", then " : "in ") + "resting contact from row " +
              std::to_string(*run.resting_contact_from_step);
  }
  return text.empty() ? "none" : text;
}

std::string line_value(const std::string& text, std::string_view key) {
  const std::size_t line = text.find(std::string("\n").append(key));
  if (line == std::string::npos) return "";
  const std::size_t begin = line + 1 + key.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

bool is_summary(const std::string& text) {
  return text.starts_with("scenario: ") && !summary_state_hash(text).empty() && summary_file_checksum(text);
}

std::string summary_reason(const std::string& text) { return line_value(text, kReasonKey); }

std::string summary_state_hash(const std::string& text) { return hash_of(text, kStateHashKey); }

std::string summary_core(const std::string& text) { return hash_of(text, kCoreKey); }

std::optional<std::string> summary_file_checksum(const std::string& text) {
  const std::size_t line_length = kChecksumsKey.size() + 2 * kHashDigits + 2;
  if (text.size() < line_length || text.back() != '\n' ||
      text.compare(text.size() - line_length, kChecksumsKey.size(), kChecksumsKey) != 0)
    return std::nullopt;
  const std::string checksum = text.substr(text.size() - 1 - kHashDigits, kHashDigits);
  return is_hash(checksum) ? std::optional(checksum) : std::nullopt;
}

}  // namespace hyrax
