#include "tools/store/golden_digest.h"

#include <algorithm>

#include <fmt/format.h>

#include "tools/store/hex_float.h"

namespace hyrax {
namespace {

constexpr std::size_t kContactsListed = 40;  // All of a run of so many, else half at each end.
constexpr std::string_view kNameKey = "scenario: ";
constexpr std::string_view kHashKey = "state hash: ";
constexpr std::string_view kReasonKey = "reason: ";
constexpr std::string_view kMarginKey = "margin: ";

std::string line_of(const Contact& contact) {
  const std::string_view wall = kWallNames[wall_index(contact.wall)];
  if (contact.step == contact.last_step) return fmt::format("  {} {}\n", contact.step, wall);
  return fmt::format("  {} .. {} {}\n", contact.step, contact.last_step, wall);
}

std::string list_of(const StoredRun& run) {
  std::vector<Contact> listed;
  std::size_t left_out = 0;
  run.each_contact([&](const Contact& contact) {
    if (listed.size() == kContactsListed) {
      listed.erase(listed.begin() + kContactsListed / 2);
      ++left_out;
    }
    listed.push_back(contact);
  });
  std::string text;
  for (std::size_t index = 0; index < listed.size(); ++index) {
    if (left_out > 0 && index == kContactsListed / 2) text += fmt::format("  ... {} more\n", left_out);
    text += line_of(listed[index]);
  }
  return text;
}

// What stands behind the key, which begins a line; empty where there is no such line.
std::string value_of(const std::string& text, std::string_view line_key) {
  const std::size_t key = text.find(std::string("\n").append(line_key));
  if (key == std::string::npos) return "";
  const std::size_t begin = key + 1 + line_key.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

// The line that begins at `begin`, its end included; empty behind the last one.
std::string_view line_at(std::string_view text, std::size_t begin) {
  const std::size_t end = text.find('\n', begin);
  return text.substr(begin, end == std::string_view::npos ? end : end + 1 - begin);
}

std::string quoted(std::string_view line) {
  if (line.empty()) return "nothing";
  const bool is_ended = line.back() == '\n';
  if (is_ended) line.remove_suffix(1);
  return fmt::format("'{}'{}", line, is_ended ? "" : " without an end of line");
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::string golden_digest_text(const StoredRun& run, const RunSummary& summary, const std::string& reason,
                               const std::string& margin) {
  const WallCounts& counts = summary.contacts;
  const Row& end = summary.final;
  std::string text = fmt::format("{}{}\nphysics: {}\nsteps: {}\n{}{}\n", kNameKey, run.scenario.name,
                                 run.physics, run.steps, kHashKey, run.state_hash);
  text += fmt::format("contacts: left {}, right {}, top {}, ground {}\n", counts.left, counts.right,
                      counts.top, counts.ground);
  text += list_of(run);
  text += fmt::format("end: t {} s\n", end.t_s);
  text += fmt::format("  x  {} px  {}\n  y  {} px  {}\n", end.x_px, hex_float(end.x_px), end.y_px,
                      hex_float(end.y_px));
  text += fmt::format("  vx {} px/s  {}\n  vy {} px/s  {}\n", end.vx_px_per_s, hex_float(end.vx_px_per_s),
                      end.vy_px_per_s, hex_float(end.vy_px_per_s));
  text += summary.at_rest_since_s ? fmt::format("at rest since: {} s\n", *summary.at_rest_since_s)
                                  : std::string("at rest since: never\n");
  if (!margin.empty()) text += fmt::format("{}{}\n", kMarginKey, margin);
  return text + fmt::format("{}{}\n", kReasonKey, one_line(reason));
}

std::string digest_reason(const std::string& text) { return value_of(text, kReasonKey); }

std::optional<std::string> digest_fault(const std::string& kept, const std::string& fresh) {
  std::size_t kept_begin = 0;
  std::size_t fresh_begin = 0;
  for (int number = 1; kept_begin < kept.size() || fresh_begin < fresh.size(); ++number) {
    const std::string_view kept_line = line_at(kept, kept_begin);
    const std::string_view fresh_line = line_at(fresh, fresh_begin);
    if (kept_line != fresh_line)
      return fmt::format("line {}: must be {}, is {}", number, quoted(fresh_line), quoted(kept_line));
    kept_begin += kept_line.size();
    fresh_begin += fresh_line.size();
  }
  return std::nullopt;
}

}  // namespace hyrax
