#include "sim/trace/step_player.h"

#include <algorithm>
#include <cmath>

#include "sim/trace/step_program.h"

namespace hyrax {

TracedBody::TracedBody(const StepProgram& program, const State& start) : program_(&program) {
  program.run(CoreFunction::construct, members_,
              {start.x_px, start.y_px, start.vx_px_per_s, start.vy_px_per_s, 0.0});
}

void TracedBody::update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
                        int sprite_height_px) {
  path_ = program_->run(
      CoreFunction::update, members_,
      update_arguments(dt_s, {window_width_px, window_height_px}, {sprite_width_px, sprite_height_px}));
  contact_ = 0;
  for (const PathContact& met : program_->contacts(path_)) contact_ |= static_cast<std::uint8_t>(met.wall);
  if (touches(contact_, Wall::ground) && vy() == 0.0) contact_ |= kRestBit;
}

void TracedBody::update(const StepInput& input) {
  const auto& [state, window, sprite, is_held] = input.world;
  update(input.dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
}

std::span<double> TracedBody::members() { return std::span(members_).first(program_->step().members.size()); }

void TracedBody::set_row(const State& row) {
  const std::array<double, 4> state = {row.x_px, row.y_px, row.vx_px_per_s, row.vy_px_per_s};
  std::copy(state.begin(), state.end(), members_.begin());
}

void TracedBody::setPos(double x_px, double y_px) {
  program_->run(CoreFunction::set_position, members_, {x_px, y_px});
}

void TracedBody::setVelocity(double vx_px_per_s, double vy_px_per_s) {
  program_->run(CoreFunction::set_velocity, members_, {vx_px_per_s, vy_px_per_s});
}

void TracedBody::resetVelocity() { program_->run(CoreFunction::reset_velocity, members_, {}); }

WallMeeting TracedBody::meeting(Wall wall, double dt_s, const Size& window, const Size& sprite) const {
  const StepArguments arguments = update_arguments(dt_s, window, sprite);
  TracedBody after = *this;
  const StepIndex path = program_->run(CoreFunction::update, after.members_, arguments);
  std::vector<double> values;
  program_->evaluate(members_, arguments, values);
  const auto velocity = [&](const VelocityIndices& at) {
    return at.vx == kNoIndex ? Velocity{vx(), vy()} : Velocity{values[at.vx], values[at.vy]};
  };
  for (const PathContact& contact : program_->contacts(path))
    if (contact.wall == wall)
      return {std::fabs(values[contact.position] - values[contact.bound]) / contact.scale,
              velocity(contact.before), velocity(contact.after)};
  return {};
}

}  // namespace hyrax
