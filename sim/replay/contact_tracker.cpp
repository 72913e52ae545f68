#include "sim/replay/contact_tracker.h"

namespace hyrax {

ContactTracker::ContactTracker(RowSink& sink, std::uint8_t contact_before, std::int64_t step)
    : sink_(sink), handed_on_max_(sink.wants().contacts ? kContactsRecordedMax : 0) {
  touch(contact_before, step);
}

void ContactTracker::begin(const Contact& contact) {
  Open& open = open_[wall_index(contact.wall)];
  end(open);
  open = {is_full() ? -1 : handed_on_, contact.step, contact.step};
  ++counts_[wall_index(contact.wall)];
  if (is_full()) return;
  ++handed_on_;
  sink_.contact_began(contact);
}

void ContactTracker::pass_over(std::int64_t step, std::int64_t steps, const WallCounts& begun) {
  for (std::size_t wall = 0; wall < open_.size(); ++wall) {
    if (open_[wall].last_step == step) open_[wall].last_step += steps;
    counts_[wall] += begun[wall];
  }
}

void ContactTracker::finish() {
  for (Open& open : open_) end(open);
}

void ContactTracker::end(Open& open) {
  if (open.index >= 0 && open.last_step > open.step) sink_.contact_ended(open.index, open.last_step);
  open.index = -1;
}

}  // namespace hyrax
