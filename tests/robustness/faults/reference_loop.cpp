// Plays a scenario as plainly as it can be played: one physics::update a step, every row hashed,
// nothing skipped and no rows kept. Prints the state hash. For a fixed dt and flings alone.
#include <cmath>
#include <cstdio>

#include "sim/motion/state.h"
#include "sim/physics/physics.h"
#include "sim/scenario/frame_clock.h"
#include "sim/trajectory/state_hash.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

State flight_of(const physics& body, double dt_s) {
  const double vx = body.vx() * physics::AIR_DRAG;
  const double vy = (body.vy() + physics::GRAVITY * dt_s) * physics::AIR_DRAG;
  return {body.x() + vx * dt_s, body.y() + vy * dt_s, vx, vy};
}

// The walls at which the paper's conditions clamp a flight without walls.
std::uint8_t contact_of(const State& flight, double right_px, double bottom_px) {
  std::uint8_t contact = 0;
  if (flight.x_px < 0.0) contact |= static_cast<std::uint8_t>(Wall::left);
  if (flight.x_px > right_px) contact |= static_cast<std::uint8_t>(Wall::right);
  if (flight.y_px < 0.0) contact |= static_cast<std::uint8_t>(Wall::top);
  if (flight.y_px > bottom_px) {
    contact |= static_cast<std::uint8_t>(Wall::ground);
    if (std::fabs(flight.vy_px_per_s * physics::RESTITUTION) < physics::REST_THRESHOLD) contact |= kRestBit;
  }
  return contact;
}

class Hasher {
 public:
  void add(double dt_s, const physics& body, std::uint8_t contact) {
    pack_row(block_.extend(1), dt_s, body.x(), body.y(), body.vx(), body.vy(), contact);
    if (block_.room() > 0) return;
    hash_.add(digest(block_));
    block_.shrink(0);
  }
  std::string finish() {
    if (block_.size() > 0) hash_.add(digest(block_));
    return hex(hash_.value());
  }

 private:
  StateHash hash_;
  RowBlock block_;
};

std::string play(const Scenario& scenario) {
  const auto [width_px, height_px] = scenario.window;
  const auto [sprite_width_px, sprite_height_px] = scenario.sprite;
  const double dt_s = base_dt_s(scenario.clock);
  physics body(scenario.start.x_px, scenario.start.y_px, scenario.start_velocity.vx_px_per_s,
               scenario.start_velocity.vy_px_per_s);
  Hasher hasher;
  hasher.add(0.0, body, 0);
  auto event = scenario.events.begin();
  for (std::int64_t frame = 0; frame < step_count(scenario); ++frame) {
    for (; event != scenario.events.end() && std::get<std::int64_t>(event->when) == frame; ++event) {
      const Velocity& velocity = std::get<Fling>(event->action).velocity;
      body.setVelocity(velocity.vx_px_per_s, velocity.vy_px_per_s);
    }
    const State flight = flight_of(body, dt_s);
    body.update(dt_s, width_px, height_px, sprite_width_px, sprite_height_px);
    hasher.add(dt_s, body, contact_of(flight, width_px - sprite_width_px, height_px - sprite_height_px));
  }
  return hasher.finish();
}

}  // namespace
}  // namespace hyrax

int main(int argc, char** argv) {
  try {
    if (argc == 2) std::printf("%s\n", hyrax::play(hyrax::load_scenario(argv[1])).c_str());
    return argc == 2 ? 0 : 2;
  } catch (const hyrax::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return static_cast<int>(failure.exit_code());
  }
}
