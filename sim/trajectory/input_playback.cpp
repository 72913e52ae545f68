#include "sim/trajectory/input_playback.h"

#include <utility>

#include "sim/scenario/apply.h"

namespace hyrax {
namespace {

// The row as a body, which notes what is set.
struct Body {
  Row& row;
  Size& window;
  Size& sprite;
  bool& is_held;
  InputChange& change;

  void setPos(double x_px, double y_px) {
    row.x_px = x_px;
    row.y_px = y_px;
    change.sets_position = true;
  }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) {
    row.vx_px_per_s = vx_px_per_s;
    row.vy_px_per_s = vy_px_per_s;
    change.sets_velocity = true;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }
};

}  // namespace

InputPlayback::InputPlayback(const Scenario& scenario, std::vector<Input> inputs)
    : window_(scenario.window), sprite_(scenario.sprite), inputs_(std::move(inputs)) {}

InputChange InputPlayback::apply_due(Row& row) {
  InputChange change;
  Body body{row, window_, sprite_, is_held_, change};
  for (; next_ < inputs_.size() && inputs_[next_].frame <= row.step; ++next_) {
    const Action& action = inputs_[next_].action;
    hyrax::apply(action, body);
    change.ends_arc |= !std::holds_alternative<Hitch>(action);
    change.grabs |= std::holds_alternative<Grab>(action);
  }
  return change;
}

}  // namespace hyrax
