#include "sim/trajectory/input_playback.h"

#include <utility>

#include "sim/scenario/apply.h"

namespace hyrax {
namespace {

// A body that notes what is set.
struct Body : World {
  InputChange change = {};

  void setPos(double x_px, double y_px) {
    World::setPos(x_px, y_px);
    change.sets_position = true;
  }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) {
    World::setVelocity(vx_px_per_s, vy_px_per_s);
    change.sets_velocity = true;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }
};

}  // namespace

InputPlayback::InputPlayback(const Scenario& scenario, std::vector<Input> inputs)
    : world_{.state = {}, .window = scenario.window, .sprite = scenario.sprite}, inputs_(std::move(inputs)) {}

InputChange InputPlayback::apply_due(Row& row) {
  Body body{world_};
  body.state = state_of(row);
  for (; has_inputs_after(row.step); ++next_) {
    const Action& action = inputs_[next_].action;
    hyrax::apply(action, body);
    body.change.ends_arc |= !std::holds_alternative<Hitch>(action);
    body.change.grabs |= std::holds_alternative<Grab>(action);
  }
  world_ = static_cast<const World&>(body);
  set_state(row, body.state);
  return body.change;
}

}  // namespace hyrax
