#include "sim/trajectory/stored_run.h"

#include <bit>

namespace hyrax {
namespace {

// The upper byte of a product depends on every bit of the factor.
std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>((std::bit_cast<std::uint64_t>(value) * 0x9E3779B97F4A7C15u) >> 56);
}

bool is_same_but_for_time(const Keyframe& a, const Keyframe& b) {
  return same_bits(state_of(a.row), state_of(b.row)) && a.row.contact == b.row.contact &&
         same_bits(a.timeline.dt_s, b.timeline.dt_s) && same_bits(a.timeline.base_s, b.timeline.base_s) &&
         same_bits(a.timeline.comp_s, b.timeline.comp_s) && a.window == b.window && a.sprite == b.sprite &&
         a.is_held == b.is_held;
}

}  // namespace

bool is_same_keyframe(const Keyframe& a, const Keyframe& b) {
  return is_same_but_for_time(a, b) && same_bits(a.row, b.row) && a.timeline.frames == b.timeline.frames;
}

RowCheck check_of(const Row& row) {
  return {byte_of(row.dt_s),        byte_of(row.x_px),        byte_of(row.y_px),
          byte_of(row.vx_px_per_s), byte_of(row.vy_px_per_s), row.contact};
}

void StoredRun::each_contact(const std::function<void(const Contact&)>& take) const {
  if (replay_contacts) return replay_contacts(take);
  for (const Contact& contact : contacts) take(contact);
}

void RunRecorder::block(const Block& block, std::int64_t count) {
  if (!run_.blocks.empty()) {
    StoredBlock& last = run_.blocks.back();
    if (last.digest == block.digest && is_same_but_for_time(last.keyframe, block.keyframe)) {
      last.count += count;
      return;
    }
  }
  StoredBlock& stored = run_.blocks.emplace_back(StoredBlock{count, block.digest, block.keyframe, {}});
  if (run_.blocks.size() > kCheckedBlocksMax) return;
  for (std::size_t index = 0; index < block.rows.size(); ++index)
    stored.checks.push_back(check_of(block.rows.row(index)));
}

}  // namespace hyrax
