#include "tools/store/golden_digest.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/files/failure.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr std::size_t kContactsListed = 40;  // All of a run of so many, else half at each end.
constexpr std::string_view kHashKey = "state hash: ";
constexpr std::string_view kReasonKey = "reason: ";

std::string line_of(const Contact& contact) {
  const std::string_view wall = kWallNames[wall_index(contact.wall)];
  if (contact.step == contact.last_step) return fmt::format("  {} {}\n", contact.step, wall);
  return fmt::format("  {} .. {} {}\n", contact.step, contact.last_step, wall);
}

std::string list_of(const std::vector<Contact>& contacts) {
  const bool is_long = contacts.size() > kContactsListed;
  std::string text;
  for (std::size_t index = 0; index < contacts.size(); ++index) {
    if (is_long && index == kContactsListed / 2) {
      text += fmt::format("  ... {} more\n", contacts.size() - kContactsListed);
      index = contacts.size() - kContactsListed / 2;
    }
    text += line_of(contacts[index]);
  }
  return text;
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
  std::string text = fmt::format("scenario: {}\nphysics: {}\nsteps: {}\n{}{}\n", run.scenario.name,
                                 run.physics, run.steps, kHashKey, run.state_hash);
  text += fmt::format("contacts: left {}, right {}, top {}, ground {}\n", counts[0], counts[1], counts[2],
                      counts[3]);
  text += list_of(run.contacts);
  text += fmt::format("end: t {} s\n", end.t_s);
  text += fmt::format("  x  {} px  {:a}\n  y  {} px  {:a}\n", end.x_px, end.x_px, end.y_px, end.y_px);
  text += fmt::format("  vx {} px/s  {:a}\n  vy {} px/s  {:a}\n", end.vx_px_per_s, end.vx_px_per_s,
                      end.vy_px_per_s, end.vy_px_per_s);
  text += summary.at_rest_since_s ? fmt::format("at rest since: {} s\n", *summary.at_rest_since_s)
                                  : std::string("at rest since: never\n");
  if (!margin.empty()) text += fmt::format("margin: {}\n", margin);
  return text + fmt::format("{}{}\n", kReasonKey, one_line(reason));
}

std::string digest_reason(const std::string& text) {
  const std::size_t key = text.find(std::string("\n").append(kReasonKey));
  if (key == std::string::npos) return "";
  const std::size_t begin = key + 1 + kReasonKey.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::string read_digest_hash(const std::string& path) {
  const std::string text = read_text_file(path);
  const std::size_t key = text.find(std::string("\n").append(kHashKey));
  constexpr std::size_t kDigits = 32;
  const std::size_t begin = key == std::string::npos ? text.size() : key + 1 + kHashKey.size();
  if (text.find_first_not_of("0123456789abcdef", begin) != begin + kDigits || text[begin + kDigits] != '\n')
    throw Failure(ExitCode::bad_input, path + ": has no line '" + std::string(kHashKey) +
                                           "' of 32 hex digits; bless the scenario again");
  return text.substr(begin, kDigits);
}

}  // namespace hyrax
