#include "tools/store/golden_summary.h"

#include <fmt/format.h>

#include <cmath>

#include "tools/files/json.h"
#include "tools/files/scenario_writer.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

constexpr std::size_t kContactsListed = 40;  // All of a run with up to this many; else half at each end.

// To 6 digits; a zero has no sign.
std::string decimal(double value) {
  std::string text = fmt::format("{:.6f}", value);
  return text == "-0.000000" ? text.substr(1) : text;
}

// In px/s, as it met the wall. By sqrt, whose bits are the same everywhere; those of hypot are not.
double speed_before(const Contact& contact) {
  return std::sqrt(contact.vx_before_px_per_s * contact.vx_before_px_per_s +
                   contact.vy_before_px_per_s * contact.vy_before_px_per_s);
}

std::string line_of(const Contact& contact) {
  const std::string_view wall = name_of(contact.wall);
  const std::string last_step =
      contact.step == contact.last_step ? "" : fmt::format(" .. {}", contact.last_step);
  return fmt::format("  {}{} {} at {} px/s\n", contact.step, last_step, wall, decimal(speed_before(contact)));
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

std::string place_text(const Row& row) {
  return fmt::format("x {} px, y {} px, step {}\n", decimal(row.x_px), decimal(row.y_px), row.step);
}

std::string waypoints_text(const Waypoints& waypoints) {
  std::string text = fmt::format("apex: {}", place_text(waypoints.apex));
  if (!waypoints.at_seconds.empty()) text += "position:\n";
  int second = 0;
  for (const Row& row : waypoints.at_seconds) text += fmt::format("  {} s  {}", ++second, place_text(row));
  return text;
}

// Hashes values in the same byte order on every machine.
class ContentsHash {
 public:
  void add(std::string_view text) {
    add(static_cast<std::int64_t>(text.size()));
    hash_.add(std::as_bytes(std::span(text)));
  }
  void add(double value) {
    const std::uint64_t bits = little_endian_bits(value);
    hash_.add(std::as_bytes(std::span(&bits, 1)));
  }
  void add(std::int64_t value) { add(std::bit_cast<double>(value)); }
  void add(const Row& row) {
    for (const RowColumn& column : kRowColumns) add(column.number(row).value());
    add(row.step);
    add(std::int64_t{row.contact});
  }
  [[nodiscard]] std::string value() const { return hex(hash_.value()); }

 private:
  ByteHash hash_;
};

void add(ContentsHash& hash, const Contact& contact) {
  hash.add(contact.step);
  hash.add(contact.last_step);
  hash.add(static_cast<std::int64_t>(contact.wall));
  for (const ColumnOf<Contact>& column : std::span(kContactColumns).subspan(3))
    hash.add(column.number(contact).value());
}

void add(ContentsHash& hash, const StoredBlock& block) {
  const Keyframe& keyframe = block.keyframe;
  hash.add(block.count);
  hash.add(hex(block.digest));
  hash.add(keyframe.row);
  visit_numbers(keyframe, [&](const char*, auto number) {
    if constexpr (std::is_same_v<decltype(number), double>)
      hash.add(number);
    else
      hash.add(std::int64_t{number});
  });
}

// The last line. @param head the text up to the reason's.
std::string checksums_line(const std::string& head, const std::string& contents, const std::string& file) {
  ContentsHash hash;
  hash.add(contents);
  hash.add(head);
  return fmt::format("{}{} {}\n", kChecksumsKey, hash.value(), file);
}

}  // namespace

std::string contents_checksum(const StoredRun& run) {
  ContentsHash hash;
  hash.add(to_text(to_json(without_texts(run.scenario))));
  hash.add(run.physics);
  if (run.constants)
    for (const double constant : numbers_of(*run.constants)) hash.add(constant);
  hash.add(run.steps);
  hash.add(run.state_hash);
  for (const double t_s : run.rows.t_s) hash.add(t_s);
  for (const StoredBlock& block : run.blocks) add(hash, block);
  hash.add(run.final);
  hash.add(run.contacts_total);
  run.each_contact([&](const Contact& contact) { add(hash, contact); });
  for (const Input& input : run.inputs) {
    const InputRecord record = record_of(input);
    hash.add(record.frame);
    hash.add(std::int64_t{record.kind});
    hash.add(record.a);
    hash.add(record.b);
  }
  return hash.value();
}

std::string file_checksum(const std::string& path) {
  ByteHash hash;
  read_pieces(path, [&hash](std::string_view piece) { hash.add(std::as_bytes(std::span(piece))); });
  return hex(hash.value());
}

std::string golden_summary_text(const StoredRun& run, const RunSummary& summary, const Waypoints& waypoints,
                                const std::string& reason, const std::string& margin,
                                const GoldenChecksums& checksums) {
  const Row& end = summary.final;
  std::string text = fmt::format("scenario: {}\nphysics: {}\nsteps: {}\n{}{}\n", run.scenario.name,
                                 run.physics, run.steps, kStateHashKey, run.state_hash);
  for (const auto& [name, value] : run.scenario.parameters)
    text += fmt::format("parameter: {} {}\n", name, value);
  text += fmt::format("contacts: {}\n", contacts_text(summary, true));
  text += list_of(run);
  text += waypoints_text(waypoints);
  text += fmt::format("end: t {} s\n", end.t_s);
  text += fmt::format("  x  {} px  {}\n  y  {} px  {}\n", end.x_px, hex_float(end.x_px), end.y_px,
                      hex_float(end.y_px));
  text += fmt::format("  vx {} px/s  {}\n  vy {} px/s  {}\n", end.vx_px_per_s, hex_float(end.vx_px_per_s),
                      end.vy_px_per_s, hex_float(end.vy_px_per_s));
  text += summary.at_rest_since_s ? fmt::format("settled since: {} s\n", *summary.at_rest_since_s)
                                  : fmt::format("not settled: {}\n", summary.why_not_settled());
  if (!margin.empty()) text += fmt::format("margin: {}\n", margin);
  if (!checksums.core.empty()) text += fmt::format("{}{}\n", kCoreKey, checksums.core);
  return with_checksums(text, reason, checksums.contents, checksums.file);
}

std::string with_checksums(const std::string& lines, const std::string& reason, const std::string& contents,
                           const std::string& file) {
  const std::string head = lines + std::string(kReasonKey);
  return head + reason + "\n" + checksums_line(head, contents, file);
}

bool has_checksums(const std::string& text, const std::string& contents, const std::string& file) {
  const std::size_t reason = text.find(std::string("\n").append(kReasonKey));
  if (reason == std::string::npos) return false;
  return text == with_checksums(text.substr(0, reason + 1), summary_reason(text), contents, file);
}

}  // namespace hyrax
