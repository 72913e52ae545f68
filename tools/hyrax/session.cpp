#include "tools/hyrax/session.h"

#include <cassert>
#include <exception>

#include "tools/files/failure.h"

namespace hyrax {

Session::Session(const Keyframe& start) : now_(start), ring_(start) {}

void Session::apply(const Action& action) {
  assert(!std::holds_alternative<Hitch>(action));
  assert(!std::holds_alternative<Grab>(action) || !now_.is_held);
  assert(!std::holds_alternative<Release>(action) || now_.is_held);
  shipped_kernel().apply(action, now_);
  wake();
  ring_.add_input(action);
  if (recording_) recording_->add_input(action);
}

void Session::advance(double dt_s) {
  assert(dt_s >= 0.0 && dt_s <= kFrameMax_s);
  const Row before = now_.row;
  const Stretch frame{.window = now_.window,
                      .sprite = now_.sprite,
                      .is_held = now_.is_held,
                      .contact_before = before.contact,
                      .dt_s = &dt_s,
                      .frames = 1};
  State body = state_of(before);
  row_.shrink(0);
  shipped_kernel().play(frame, body, rest_, row_, log_);
  now_.timeline.play(dt_s);
  now_.row = row_.row(0);
  now_.row.step = before.step + 1;
  now_.row.t_s = now_.timeline.time_s();
  const bool is_in_place = same_bits(now_.row.x_px, before.x_px) && same_bits(now_.row.y_px, before.y_px);
  if (!is_in_place) still_frames_ = 0;
  if (is_in_place && dt_s > 0.0 && !is_still()) ++still_frames_;
  ring_.add_frame(now_);
  if (recording_) recording_->add_frame(now_);
}

void Session::finish_recording() {
  assert(is_recording());
  Recording finished = std::move(*recording_);
  recording_.reset();
  finished.finish();
}

void Session::continue_recording() {
  assert(is_recording());
  Recording finished = std::move(*recording_);
  recording_.reset();
  std::exception_ptr failure;
  try {
    finished.finish();  // First, to free the names of its parts.
  } catch (const Failure&) {
    failure = std::current_exception();
  }
  recording_.emplace(finished.next(now_));
  if (failure) std::rethrow_exception(failure);
}

}  // namespace hyrax
