#include "sim/replay/contact_tracker.h"

namespace hyrax {

ContactTracker::ContactTracker(RowSink& sink)
    : sink_(sink), handed_on_max_(sink.wants().contacts ? kContactsRecordedMax : 0) {}

void ContactTracker::begin(const Contact& contact) {
  open_[wall_index(contact.wall)] = {is_full() ? kNone : handed_on_, contact.step};
  ++counts_[wall_index(contact.wall)];
  if (is_full()) return;
  ++handed_on_;
  sink_.contact_began(contact);
}

void ContactTracker::end(Wall wall, std::int64_t last_step) {
  Open& open = open_[wall_index(wall)];
  if (open.index != kNone && last_step > open.step) sink_.contact_ended(open.index, last_step);
  open.index = kNone;
}

void ContactTracker::count(const WallCounts& begun) {
  for (std::size_t wall = 0; wall < counts_.size(); ++wall) counts_[wall] += begun[wall];
}

void ContactTracker::finish(std::int64_t last_step) {
  for (const Wall wall : kWalls) end(wall, last_step);
}

}  // namespace hyrax
