#include "tools/recorder/frame_player.h"

#include <cassert>

namespace hyrax {

void FramePlayer::apply(const Action& action) {
  assert(!std::holds_alternative<Hitch>(action));
  assert(!std::holds_alternative<Grab>(action) || !now_.is_held);
  assert(!std::holds_alternative<Release>(action) || now_.is_held);
  stepper_->apply(action, now_);
}

void FramePlayer::advance(double dt_s) {
  assert(dt_s >= 0.0 && dt_s <= kFrameMax_s);
  const std::int64_t step = now_.row.step + 1;
  const Stretch frame{.window = now_.window,
                      .sprite = now_.sprite,
                      .is_held = now_.is_held,
                      .contact_before = now_.row.contact,
                      .dt_s = &dt_s,
                      .frames = 1};
  CoreBody body{state_of(now_.row), std::move(now_.core_object)};
  row_.shrink(0);
  stepper_->play(frame, body, rest_, row_, log_);
  now_.timeline.play(dt_s);
  now_.row = row_.row(0);
  now_.core_object = std::move(body.object);
  now_.row.step = step;
  now_.row.t_s = now_.timeline.time_s();
}

}  // namespace hyrax
