#include "tools/store/golden_seal.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "tools/files/failure.h"
#include "tools/files/scenario_writer.h"
#include "tools/store/input_record.h"

namespace hyrax {
namespace {

// Hashes values in a byte order of its own, whatever the machine.
class Bytes {
 public:
  void add(std::string_view text) {
    add(static_cast<std::int64_t>(text.size()));
    hash_.add(std::as_bytes(std::span(text.data(), text.size())));
  }
  void add(double value) { add_bits(little_endian_bits(value)); }
  void add(std::int64_t value) { add(std::bit_cast<double>(value)); }
  void add(const Row& row) {
    for (const double value : {row.t_s, row.dt_s, row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s})
      add(value);
    add(row.step);
    add(std::int64_t{row.contact});
  }
  void add(const Size& size) {
    add(std::int64_t{size.width_px});
    add(std::int64_t{size.height_px});
  }
  [[nodiscard]] std::string hash() const { return hex(hash_.value()); }

 private:
  void add_bits(std::uint64_t bits) { hash_.add(std::as_bytes(std::span(&bits, 1))); }
  ByteHash hash_;
};

void add(Bytes& bytes, const Contact& contact) {
  bytes.add(contact.step);
  bytes.add(contact.last_step);
  bytes.add(static_cast<std::int64_t>(contact.wall));
  for (const double value :
       {contact.t_s, contact.x_px, contact.y_px, contact.vx_before_px_per_s, contact.vy_before_px_per_s,
        contact.vx_after_px_per_s, contact.vy_after_px_per_s, contact.overshoot_px})
    bytes.add(value);
}

void add(Bytes& bytes, const StoredBlock& block) {
  const Keyframe& keyframe = block.keyframe;
  bytes.add(block.count);
  bytes.add(hex(block.digest));
  bytes.add(keyframe.row);
  for (const double value : {keyframe.timeline.base_s, keyframe.timeline.comp_s, keyframe.timeline.dt_s})
    bytes.add(value);
  bytes.add(keyframe.timeline.frames);
  bytes.add(keyframe.window);
  bytes.add(keyframe.sprite);
  bytes.add(std::int64_t{keyframe.is_held});
}

Scenario without_words(Scenario scenario) {
  scenario.name.clear();
  scenario.description.reset();
  scenario.schema.reset();
  scenario.expect.reset();
  return scenario;
}

constexpr std::string_view kSealKey = "seal: ";
constexpr std::size_t kDigits = 32;

bool is_hash(const std::string& text) {
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

std::string seal_line(const GoldenSeal& seal) {
  return std::string(kSealKey).append(seal.contents).append(" ").append(seal.file).append("\n");
}

std::optional<GoldenSeal> seal_in(const std::string& digest_text) {
  const std::size_t line = digest_text.rfind(std::string("\n").append(kSealKey));
  if (line == std::string::npos) return std::nullopt;
  const std::size_t begin = line + 1 + kSealKey.size();
  if (digest_text.size() != begin + 2 * kDigits + 2) return std::nullopt;
  const GoldenSeal seal{digest_text.substr(begin, kDigits), digest_text.substr(begin + kDigits + 1, kDigits)};
  const bool is_whole = is_hash(seal.contents) && is_hash(seal.file) &&
                        digest_text.compare(line + 1, std::string::npos, seal_line(seal)) == 0;
  return is_whole ? std::optional(seal) : std::nullopt;
}

std::string contents_hash(const StoredRun& run) {
  Bytes bytes;
  bytes.add(to_text(to_json(without_words(run.scenario))));
  bytes.add(run.physics);
  bytes.add(run.steps);
  bytes.add(run.state_hash);
  for (const double t_s : run.rows.t_s) bytes.add(t_s);
  for (const StoredBlock& block : run.blocks) add(bytes, block);
  bytes.add(run.final);
  bytes.add(run.contacts_total);
  run.each_contact([&](const Contact& contact) { add(bytes, contact); });
  for (const Input& input : run.inputs) {
    const InputRecord record = record_of(input);
    bytes.add(record.frame);
    bytes.add(std::int64_t{record.kind});
    bytes.add(record.a);
    bytes.add(record.b);
  }
  return bytes.hash();
}

std::string file_hash(const std::string& path) {
  const auto fail = [&path] {
    throw Failure(ExitCode::cannot_access, path + ": cannot be read: " + std::strerror(errno));
  };
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) fail();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> closed_at_end(file, std::fclose);
  ByteHash hash;
  std::vector<char> piece(std::size_t{1} << 16);
  while (const std::size_t bytes = std::fread(piece.data(), 1, piece.size(), file))
    hash.add(std::as_bytes(std::span(piece.data(), bytes)));
  if (std::ferror(file) != 0) fail();
  return hex(hash.value());
}

}  // namespace hyrax
