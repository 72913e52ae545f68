// What a stretch comes to whose state repeats exactly: nothing of it is computed again.
#include <algorithm>
#include <optional>

#include "sim/replay/player.h"

namespace hyrax {
namespace {

// Fills the block with whole periods, doubling what stands.
void multiply(RowBlock& rows) {
  while (rows.size() <= rows.room()) rows.append(rows, 0, rows.size());
}

// Appends rows of the cycle from `offset` on.
void append_cyclic(RowBlock& block, const Cycle& cycle, std::int64_t offset, std::int64_t count) {
  while (count > 0) {
    const std::int64_t first = offset % cycle.period;
    const std::int64_t run = std::min(count, static_cast<std::int64_t>(cycle.rows.size()) - first);
    block.append(cycle.rows, static_cast<std::size_t>(first), static_cast<std::size_t>(run));
    offset += run;
    count -= run;
  }
}

WallCounts begun_in(const StretchLog& log, std::int64_t periods) {
  WallCounts begun{};
  for (const ContactChange& change : log.changes)
    if (change.begins) begun[wall_index(change.contact.wall)] += periods;
  return begun;
}

}  // namespace

void Replay::Player::repeat(std::int64_t period, std::int64_t end) {
  if (end == steps_) {
    summary_.periodic_from_step = step() - period;
    summary_.period_steps = period;
  }
  if (!options_.skips_repetition) {
    while (step() < end) play_batch(stretch(std::min(end - step(), room())));
    return;
  }
  const Cycle cycle = make_cycle(period);
  repeat_clamps(cycle, end);
  repeat_contacts(cycle, end);
  repeat_rest(cycle, end);
  repeat_rows(cycle, end);
  repeat_blocks(cycle, end);
  now_ = keyframe_in(cycle, end);
}

Cycle Replay::Player::make_cycle(std::int64_t period) {
  Cycle cycle;
  cycle.period = period;
  Body moving = body();
  RestAnchor unused;
  play(stretch(period), moving, unused, cycle.rows, cycle.log);
  summary_.steps_computed += period;
  multiply(cycle.rows);
  return cycle;
}

Row Replay::Player::row_in(const Cycle& cycle, std::int64_t at) const {
  Row row = cycle.row(at - step() - 1);
  row.step = at;
  row.t_s = now_.timeline.time_s(at - step());
  return row;
}

Keyframe Replay::Player::keyframe_in(const Cycle& cycle, std::int64_t at) const {
  Keyframe keyframe = now_;
  keyframe.row = row_in(cycle, at);
  keyframe.timeline.frames += at - step();
  return keyframe;
}

void Replay::Player::repeat_clamps(const Cycle& cycle, std::int64_t end) {
  count_clamps(cycle.log, (end - step()) / cycle.period);
  for (std::int64_t offset = 0; offset < (end - step()) % cycle.period; ++offset) {
    StretchLog one;
    one.rows[cycle.row(offset).contact] = 1;
    count_clamps(one, 1);
  }
  if (options_.checks_bounds)
    for (std::int64_t at = step() + 1; at <= step() + cycle.period; ++at) see_bounds(row_in(cycle, at));
}

void Replay::Player::repeat_contacts(const Cycle& cycle, std::int64_t end) {
  if (cycle.log.changes.empty()) return;
  const std::int64_t period = cycle.period;
  std::int64_t stands = step();
  // Contacts are handed on as long as they are taken, and once more, so that the ones that are
  // passed over go on from one that nobody was told of.
  for (bool was_full = false; stands + period <= end && !was_full; stands += period) {
    was_full = contacts_.is_full();
    repeat_changes(cycle, stands + 1, stands + period);
  }
  const std::int64_t periods = (end - stands) / period;
  contacts_.count(begun_in(cycle.log, periods));
  repeat_changes(cycle, stands + periods * period + 1, end);
}

// Steps `first` .. `last`, at most a period; `first` begins one.
void Replay::Player::repeat_changes(const Cycle& cycle, std::int64_t first, std::int64_t last) {
  for (const ContactChange& change : cycle.log.changes) {
    Contact contact = change.contact;
    contact.step = contact.last_step = first + change.offset;
    if (contact.step > last) return;
    contact.t_s = now_.timeline.time_s(contact.step - step());
    if (change.begins)
      contacts_.begin(contact);
    else
      contacts_.end(contact.wall, contact.step - 1);
  }
}

// Which row of a pass becomes the anchor last depends only on which one was it before, so passes
// repeat too, and those that are equal are jumped over.
void Replay::Player::repeat_rest(const Cycle& cycle, std::int64_t end) {
  const std::int64_t period = cycle.period;
  std::vector<std::int64_t> step_of_anchor(static_cast<std::size_t>(period), -1);
  std::optional<std::int64_t> anchor_step;
  for (std::int64_t stands = step(); stands < end;) {
    const std::int64_t rows = std::min(period, end - stands);
    std::int64_t moved_last = -1;
    for (std::int64_t offset = 0; offset < rows; ++offset) {
      const Row row = cycle.row(offset);
      if (rest_.moves_to(row.x_px, row.y_px)) moved_last = offset;
    }
    if (moved_last < 0) break;
    anchor_step = stands + 1 + moved_last;
    stands += rows;
    std::int64_t& seen = step_of_anchor[static_cast<std::size_t>(moved_last)];
    if (seen >= 0) {
      const std::int64_t lap = *anchor_step - seen;
      const std::int64_t jump = (end - stands) / lap * lap;
      stands += jump;
      *anchor_step += jump;
    }
    seen = *anchor_step;
  }
  if (anchor_step) rest_.t_s = now_.timeline.time_s(*anchor_step - step());
}

void Replay::Player::repeat_rows(const Cycle& cycle, std::int64_t end) {
  if (wants_.rows_every == 0) return;
  while (next_recorded_step_ <= end) record(row_in(cycle, next_recorded_step_));
}

void Replay::Player::repeat_blocks(const Cycle& cycle, std::int64_t end) {
  constexpr auto kRows = static_cast<std::int64_t>(kBlockRows);
  std::int64_t stands = step();
  const auto take = [&](std::int64_t rows) {
    if (block_.size() == 0) block_keyframe_ = keyframe_in(cycle, stands + 1);
    append_cyclic(block_, cycle, stands - step(), rows);
    stands += rows;
  };
  take(std::min(end - stands, static_cast<std::int64_t>(block_.room())));
  if (block_.room() > 0) return;
  close_block();
  // The period divides a block, so whole blocks are equal.
  if (const std::int64_t count = (end - stands) / kRows; count > 0) {
    take(kRows);
    stands += (count - 1) * kRows;
    close_block(count);
  }
  if (stands < end) take(end - stands);
}

}  // namespace hyrax
