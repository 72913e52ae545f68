#include "tools/hyrax/session.h"

#include <cassert>
#include <exception>

#include "tools/files/failure.h"

namespace hyrax {

Session::Session(const Core& core, const Keyframe& start) : player_(core, start), ring_(start) {}

void Session::apply(const Action& action) {
  player_.apply(action);
  wake();
  ring_.add_input(action);
  if (recording_) recording_->add_input(action);
}

void Session::advance(double dt_s) {
  const Row before = now().row;
  player_.advance(dt_s);
  const bool is_in_place = same_bits(now().row.x_px, before.x_px) && same_bits(now().row.y_px, before.y_px);
  if (!is_in_place) still_frames_ = 0;
  if (is_in_place && dt_s > 0.0 && !is_still()) ++still_frames_;
  ring_.add_frame(now());
  if (recording_) recording_->add_frame(now());
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
  recording_.emplace(finished.next(now()));
  if (failure) std::rethrow_exception(failure);
}

}  // namespace hyrax
