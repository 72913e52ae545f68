// Frames of a stretch whose state repeats exactly: filled in from one period, which is computed once.
#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "sim/replay/replay.h"

namespace hyrax {
namespace {

// Fills the block with whole periods by doubling its rows.
void multiply(RowBlock& rows) {
  while (rows.size() <= rows.room()) rows.append(rows, 0, rows.size());
}

// Appends rows of the cycle from row `step` on.
void append_cyclic(RowBlock& block, const Cycle& cycle, std::int64_t step, std::int64_t count) {
  while (count > 0) {
    const std::int64_t first = cycle.phase(step);
    const std::int64_t run = std::min(count, static_cast<std::int64_t>(cycle.rows.size()) - first);
    block.append(cycle.rows, static_cast<std::size_t>(first), static_cast<std::size_t>(run));
    step += run;
    count -= run;
  }
}

WallCounts begun_in(const StretchLog& log, std::int64_t periods) {
  WallCounts begun{};
  for (const ContactChange& change : log.changes)
    if (change.begins) begun[change.contact.wall] += periods;
  return begun;
}

}  // namespace

void Replay::repeat(const Cycle& cycle, std::int64_t end) {
  // The cycle's first pass counts as computed.
  const std::int64_t computed_end = std::min(end, cycle.first_step + cycle.period - 1);
  summary_.steps_computed += std::max<std::int64_t>(0, computed_end - step());
  repeat_clamps(cycle, end);
  repeat_contacts(cycle, end);
  repeat_rest(cycle, end);
  repeat_floor(cycle, end);
  while (tee_.next_row() <= end) tee_.row(row_in(cycle, tee_.next_row()));
  repeat_blocks(cycle, end);
  now_ = keyframe_in(cycle, end);
}

Cycle Replay::make_cycle(std::int64_t period) const {
  Cycle cycle;
  cycle.period = period;
  cycle.first_step = step() + 1;
  cycle.before = body();
  CoreBody moving = cycle.before;
  RestAnchor unused;
  stepper_->play(stretch(period), moving, unused, cycle.rows, *cycle.log);
  multiply(cycle.rows);
  return cycle;
}

Row Replay::row_in(const Cycle& cycle, std::int64_t at) const {
  Row row = cycle.row(at);
  row.step = at;
  row.t_s = now_.timeline.time_s(at - step());
  return row;
}

Keyframe Replay::keyframe_in(const Cycle& cycle, std::int64_t at) const {
  Keyframe keyframe = now_;
  keyframe.row = row_in(cycle, at);
  keyframe.timeline.frames += at - step();
  if (!cycle.before.object.empty()) {
    CoreBody moved = cycle.before;
    RestAnchor rest;
    RowBlock rows;
    Reused<StretchLog> log;
    stepper_->play(stretch(cycle.phase(at) + 1), moved, rest, rows, *log);
    keyframe.core_object = std::move(moved.object);
  }
  return keyframe;
}

void Replay::repeat_clamps(const Cycle& cycle, std::int64_t end) {
  count_clamps(*cycle.log, (end - step()) / cycle.period);
  for (std::int64_t rest = (end - step()) % cycle.period; rest > 0; --rest) {
    StretchLog one;
    one.rows[cycle.row(step() + rest).contact] = 1;
    count_clamps(one, 1);
  }
}

void Replay::repeat_contacts(const Cycle& cycle, std::int64_t end) {
  if (cycle.log->changes.empty()) return;
  const std::int64_t period = cycle.period;
  std::int64_t next = step() + 1;
  // Contacts are passed on while the list has room, and for one whole pass more, so that no contact
  // that was passed on is still open when passes are only counted.
  for (bool is_counted_only = false; next <= end && !is_counted_only;) {
    const std::int64_t last = std::min(end, next - cycle.phase(next) + period - 1);
    is_counted_only = tee_.is_full() && last - next + 1 == period;
    repeat_changes(cycle, next, last);
    next = last + 1;
  }
  const std::int64_t periods = (end - next + 1) / period;
  tee_.count_contacts(begun_in(*cycle.log, periods));
  repeat_changes(cycle, next + periods * period, end);
}

// REQUIRES: steps `first` .. `last` are of one pass, or there are none.
void Replay::repeat_changes(const Cycle& cycle, std::int64_t first, std::int64_t last) {
  assert(first > last || cycle.phase(first) + (last - first) < cycle.period);
  const std::int64_t pass_first = first - cycle.phase(first);
  for (const ContactChange& change : cycle.log->changes) {
    Contact contact = change.contact;
    contact.step = contact.last_step = pass_first + change.offset;
    if (contact.step < first) continue;
    if (contact.step > last) return;
    contact.t_s = now_.timeline.time_s(contact.step - step());
    tee_.contact(contact, change.begins);
  }
}

// A pass is one period of rows. The anchor of rest at its end depends only on the anchor at its beginning,
// which is a row of the pass before. So as soon as two passes end with the same row of the pass as anchor,
// all passes between them repeat as well: such a lap is jumped over as often as it fits.
void Replay::repeat_rest(const Cycle& cycle, std::int64_t end) {
  const std::int64_t period = cycle.period;
  std::vector<std::int64_t> step_of_anchor(static_cast<std::size_t>(period), -1);
  std::optional<std::int64_t> anchor_step;
  for (std::int64_t at = step(); at < end;) {
    const std::int64_t rows = std::min(period, end - at);
    std::int64_t moved_last = -1;
    for (std::int64_t offset = 0; offset < rows; ++offset) {
      const Row row = cycle.row(at + 1 + offset);
      if (rest_.moves_to(row.x_px, row.y_px)) moved_last = offset;
    }
    if (moved_last < 0) break;
    anchor_step = at + 1 + moved_last;
    at += rows;
    std::int64_t& seen = step_of_anchor[static_cast<std::size_t>(moved_last)];
    if (seen >= 0) {
      const std::int64_t lap = *anchor_step - seen;
      const std::int64_t jump = (end - at) / lap * lap;
      at += jump;
      *anchor_step += jump;
    }
    seen = *anchor_step;
  }
  if (anchor_step) rest_.t_s = now_.timeline.time_s(*anchor_step - step());
}

// After one pass all others are like it.
void Replay::repeat_floor(const Cycle& cycle, std::int64_t end) {
  const double floor_px = bounds_of(now_.window, now_.sprite).bottom_px;
  std::uint8_t contact_before = now_.row.contact;
  std::int64_t at = step();
  const auto play_to = [&](std::int64_t last) {
    while (at < last) {
      const Row row = cycle.row(++at);
      resting_.row(at, std::exchange(contact_before, row.contact), row.contact, row.y_px, floor_px);
    }
  };
  play_to(std::min(end, at + cycle.period));
  const std::int64_t passes = (end - at) / cycle.period;
  resting_.repeat(at, passes, cycle.period, begun_in(*cycle.log, 1).ground);
  at += passes * cycle.period;
  play_to(end);
}

void Replay::repeat_blocks(const Cycle& cycle, std::int64_t end) {
  constexpr auto kRows = static_cast<std::int64_t>(kBlockRows);
  std::int64_t at = step();
  const auto append = [&](std::int64_t rows) {
    if (block_.size() == 0) block_keyframe_ = keyframe_in(cycle, at + 1);
    append_cyclic(block_, cycle, at + 1, rows);
    at += rows;
  };
  append(std::min(end - at, static_cast<std::int64_t>(block_.room())));
  if (block_.room() > 0) return;
  close_block();
  // Whole blocks are equal if the period divides them.
  while (end - at >= kRows) {
    const std::int64_t count = kRows % cycle.period == 0 ? (end - at) / kRows : 1;
    append(kRows);
    at += (count - 1) * kRows;
    close_block(count);
  }
  if (at < end) append(end - at);
}

}  // namespace hyrax
