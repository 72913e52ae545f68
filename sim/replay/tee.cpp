#include "sim/replay/replay.h"

#include <algorithm>
#include <limits>

namespace hyrax {
namespace {

constexpr std::int64_t kNoRow = std::numeric_limits<std::int64_t>::max();

}  // namespace

Tee::Tee(std::span<RowSink* const> sinks, std::int64_t first_step) {
  for (RowSink* const sink : sinks) {
    Outlet& outlet = outlets_.emplace_back(Outlet{*sink, sink->wants()});
    outlet.batch->clear();
    outlet.last_row = first_step - 1;
    set_next_row(outlet, first_step - 1);
    wants_blocks_ |= outlet.wants.blocks;
    if (outlet.wants.contacts) contacts_max_ = kContactsRecordedMax;
  }
  find_next_row();
}

void Tee::row(const Row& row) {
  assert(row.step == next_row_);
  for (Outlet& outlet : outlets_)
    if (outlet.next_row == row.step) pass(outlet, row);
  find_next_row();
}

void Tee::pass(Outlet& outlet, const Row& row) {
  outlet.batch->append(row);
  outlet.last_row = row.step;
  if (outlet.batch->size() >= kBlockRows) flush(outlet);
  set_next_row(outlet, row.step);
}

// Late, so that a sink may know already that its rows repeat, and want fewer of them.
void Tee::flush(Outlet& outlet) {
  if (outlet.batch->size() == 0) return;
  outlet.sink.rows(*outlet.batch);
  outlet.batch->clear();
  outlet.wants = outlet.sink.wants();
}

void Tee::set_next_row(Outlet& outlet, std::int64_t after_step) {
  const std::int64_t every = outlet.wants.rows_every;
  if (every == 0)
    outlet.next_row = kNoRow;
  else if (after_step < outlet.wants.all_rows_to)
    outlet.next_row = after_step + 1;
  else
    outlet.next_row = (after_step / every + 1) * every;
}

void Tee::find_next_row() {
  next_row_ = kNoRow;
  for (const Outlet& outlet : outlets_) next_row_ = std::min(next_row_, outlet.next_row);
}

void Tee::block(const Block& block, std::int64_t count) {
  for (const Outlet& outlet : outlets_)
    if (outlet.wants.blocks) outlet.sink.block(block, count);
}

void Tee::repeats(const Repetition& repetition) {
  for (const Outlet& outlet : outlets_) outlet.sink.repeats(repetition);
}

void Tee::contact(const Contact& contact, bool begins) {
  if (!begins) return end_contact(contact.wall, contact.step - 1);
  open_[wall_index(contact.wall)] = {is_full() ? kNone : contacts_passed_, contact.step};
  ++contacts_[contact.wall];
  if (is_full()) return;
  ++contacts_passed_;
  for (const Outlet& outlet : outlets_)
    if (outlet.wants.contacts) outlet.sink.contact_began(contact);
}

void Tee::end_contact(Wall wall, std::int64_t last_step) {
  OpenContact& open = open_[wall_index(wall)];
  if (open.index != kNone && last_step > open.step)
    for (const Outlet& outlet : outlets_)
      if (outlet.wants.contacts) outlet.sink.contact_ended(open.index, last_step);
  open.index = kNone;
}

void Tee::count_contacts(const WallCounts& begun) {
  assert(is_full() || begun == WallCounts{});
  for (const Wall wall : kWalls) contacts_[wall] += begun[wall];
}

void Tee::finish(const Row& last) {
  for (Outlet& outlet : outlets_) {
    if (outlet.wants.rows_every > 0 && outlet.last_row != last.step) pass(outlet, last);
    flush(outlet);
  }
  for (const Wall wall : kWalls) end_contact(wall, last.step);
}

}  // namespace hyrax
