#include "tools/recorder/tape.h"

#include <algorithm>
#include <cassert>

namespace hyrax {
namespace {

void pack(std::vector<std::byte>& rows, const Row& row) {
  rows.resize(rows.size() + kPackedRowBytes);
  pack_row(&*rows.end() - kPackedRowBytes, row);
}

// A scenario starts with a sprite that is not held. If it is held here, it is grabbed at the first frame,
// which stops it, so that a speed set while it was held must be set again.
std::vector<Event> first_inputs(const Keyframe& start) {
  if (!start.is_held) return {};
  std::vector<Event> inputs = {{std::int64_t{0}, Grab{}}};
  const Velocity velocity{start.row.vx_px_per_s, start.row.vy_px_per_s};
  if (!same_bits(velocity.vx_px_per_s, 0.0) || !same_bits(velocity.vy_px_per_s, 0.0))
    inputs.push_back({std::int64_t{0}, Fling{velocity}});
  return inputs;
}

}  // namespace

RecordedSteps frame_times(std::span<const std::byte> rows, std::size_t row_bytes) {
  RecordedSteps trace;
  for (std::size_t at = row_bytes; at < rows.size(); at += row_bytes)
    trace.dt_s.push_back(from_little_endian(&rows[at]));
  return trace;
}

Digest hash_of_rows(std::span<const std::byte> rows, std::size_t row_bytes) {
  StateHash hash;
  while (!rows.empty()) {
    const std::size_t block_bytes = std::min(rows.size(), kBlockRows * row_bytes);
    hash.add(digest(rows.first(block_bytes)));
    rows = rows.subspan(block_bytes);
  }
  return hash.value();
}

Tape::Tape(const Keyframe& start) : start_(start) {
  Row row = start.row;
  row.dt_s = 0.0;
  row.contact = 0;
  pack(rows_, row);
}

void Tape::add_frame(const Row& row) { pack(rows_, row); }

void Tape::append(const Tape& next) {
  // x, y, vx and vy of the last row and of the first.
  assert(std::equal(next.rows_.begin() + 8, next.rows_.begin() + 40, rows_.end() - kPackedRowBytes + 8));
  const std::int64_t frames_before = frames();
  for (const Event& input : next.inputs_)
    inputs_.push_back({std::get<std::int64_t>(input.when) + frames_before, input.action});
  rows_.insert(rows_.end(), next.rows_.begin() + kPackedRowBytes, next.rows_.end());
}

Scenario Tape::scenario(const std::string& name) const {
  assert(frames() > 0);
  Scenario scenario;
  scenario.name = name;
  scenario.window = start_.window;
  scenario.sprite = start_.sprite;
  scenario.start = {start_.row.x_px, start_.row.y_px};
  scenario.start_velocity = {start_.row.vx_px_per_s, start_.row.vy_px_per_s};
  scenario.clock.base = frame_times(rows_, kPackedRowBytes);
  scenario.events = first_inputs(start_);
  for (const Event& input : inputs_)
    if (std::get<std::int64_t>(input.when) < frames()) scenario.events.push_back(input);
  scenario.expect.emplace().state_hash = hex(state_hash());
  return scenario;
}

}  // namespace hyrax
