#include "sim/replay/player.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace hyrax {

ContactTracker::ContactTracker(std::span<RowSink* const> sinks) {
  std::copy_if(sinks.begin(), sinks.end(), std::back_inserter(sinks_),
               [](const RowSink* sink) { return sink->wants().contacts; });
  passed_max_ = sinks_.empty() ? 0 : kContactsRecordedMax;
}

void ContactTracker::begin(const Contact& contact) {
  open_[wall_index(contact.wall)] = {is_full() ? kNone : passed_, contact.step};
  ++counts_[contact.wall];
  if (is_full()) return;
  ++passed_;
  for (RowSink* const sink : sinks_) sink->contact_began(contact);
}

void ContactTracker::end(Wall wall, std::int64_t last_step) {
  Open& open = open_[wall_index(wall)];
  if (open.index != kNone && last_step > open.step)
    for (RowSink* const sink : sinks_) sink->contact_ended(open.index, last_step);
  open.index = kNone;
}

void ContactTracker::count(const WallCounts& begun) {
  assert(is_full() || begun == WallCounts{});
  for (const Wall wall : kWalls) counts_[wall] += begun[wall];
}

void ContactTracker::finish(std::int64_t last_step) {
  for (const Wall wall : kWalls) end(wall, last_step);
}

}  // namespace hyrax
