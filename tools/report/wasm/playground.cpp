#include "tools/report/wasm/playground.h"

#include <cassert>

namespace hyrax {
namespace {

constexpr std::int64_t kTicksPerSecond = 1'000'000;

}  // namespace

void Playground::grab(ScreenPoint hand, std::int64_t ticks) {
  assert(!hold_);
  apply(Grab{});
  const Row& row = now().row;
  hold_ = Hold{.hand = Hand(kTicksPerSecond, hand, ticks),
               .at = hand,
               .offset = {row.x_px - hand.x_px, row.y_px - hand.y_px}};
}

void Playground::drag(ScreenPoint hand, std::int64_t ticks) {
  assert(hold_);
  if (hand == hold_->at) return;
  hold_->hand.move(hand, ticks);
  hold_->at = hand;
  hold_->has_moved = true;
}

void Playground::release(ScreenPoint hand, std::int64_t ticks) {
  drag(hand, ticks);
  follow_hand();
  apply(Release{hold_->hand.velocity(ticks)});
  hold_.reset();
}

void Playground::frame(double dt_s) {
  follow_hand();
  player_.advance(dt_s);
  tape_.add_frame(now().row);
}

void Playground::apply(const Action& action) {
  player_.apply(action);
  tape_.add_input(action);
}

// One `place` a frame, however often the hand moved.
void Playground::follow_hand() {
  if (!hold_ || !hold_->has_moved) return;
  hold_->has_moved = false;
  apply(Place{{hold_->offset.x_px + hold_->at.x_px, hold_->offset.y_px + hold_->at.y_px}});
}

}  // namespace hyrax
