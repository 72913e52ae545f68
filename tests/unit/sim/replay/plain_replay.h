// The frame rule implemented literally, one physics::update a frame: the result that the replay must give.
//
// Clamps are found by the paper's own conditions on the flight without walls, every contact is
// found again from the rows, and nothing is batched, skipped or resumed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "sim/physics/physics.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/state_hash.h"

namespace hyrax {

struct PlainRun {
  std::vector<Row> rows;
  std::vector<Contact> contacts;
  std::optional<std::int64_t> out_of_bounds_step;
  std::vector<double> floors_px;          // By row.
  std::vector<std::int64_t> input_steps;  // The rows after which inputs act.

  [[nodiscard]] std::string state_hash() const {
    StateHash hash;
    for (const Row& row : rows) hash.add(row);
    return hex(hash.value());
  }

  [[nodiscard]] std::optional<double> at_rest_since_s() const {
    const Row* anchor = &rows.front();
    for (const Row& row : rows)
      if (std::fabs(row.x_px - anchor->x_px) > 0.5 || std::fabs(row.y_px - anchor->y_px) > 0.5) anchor = &row;
    if (rows.back().t_s - anchor->t_s >= 1.0) return anchor->t_s;
    return std::nullopt;
  }

  [[nodiscard]] bool stays_near_floor(std::int64_t first, std::int64_t last) const {
    for (auto row = static_cast<std::size_t>(first); row <= static_cast<std::size_t>(last); ++row)
      if (std::fabs(rows[row].y_px - floors_px[row]) > 0.5) return false;
    return true;
  }
  [[nodiscard]] bool is_resting(const Contact& contact) const {
    std::int64_t last = rows.back().step;
    for (const std::int64_t step : input_steps)
      if (step >= contact.step) last = std::min(last, step);
    return contact.wall == Wall::ground && contact.step < last && stays_near_floor(contact.step, last);
  }
  [[nodiscard]] std::optional<std::int64_t> resting_contact_from_step() const {
    const std::int64_t first = input_steps.empty() ? 0 : input_steps.back() + 1;
    for (const Contact& contact : contacts) {
      if (!is_resting(contact) || contact.last_step < first) continue;
      if (contact.step >= first) return contact.step;
      if (stays_near_floor(first, rows.back().step)) return first;
    }
    return std::nullopt;
  }

  /// Single steps clamped by a wall, or zeroed by the rest rule.
  [[nodiscard]] std::int64_t steps_with(std::uint8_t bit) const {
    std::int64_t count = 0;
    for (const Row& row : rows) count += (row.contact & bit) != 0 ? 1 : 0;
    return count;
  }
};

class PlainReplay {
 public:
  explicit PlainReplay(const Scenario& scenario) : scenario_(scenario), clock_(scenario.clock) {}

  PlainRun play() {
    body_ = {scenario_.start.x_px, scenario_.start.y_px, scenario_.start_velocity.vx_px_per_s,
             scenario_.start_velocity.vy_px_per_s};
    window_ = scenario_.window;
    sprite_ = scenario_.sprite;
    const std::int64_t steps = step_count(scenario_);
    const std::vector<std::int64_t> event_frames = schedule_events(scenario_, steps).frames;
    record(0, 0.0, 0);
    for (std::int64_t frame = 0; frame < steps; ++frame) {
      dt_s_ = clock_.dt_s(frame);
      for (std::size_t event = 0; event < event_frames.size(); ++event) {
        if (event_frames[event] != frame) continue;
        apply(scenario_.events[event].action);
        run_.input_steps.push_back(frame);
      }
      timeline_.play(dt_s_);
      record(frame + 1, timeline_.time_s(), is_held_ ? std::uint8_t{0} : step(frame + 1));
    }
    return run_;
  }

 private:
  void apply(const Action& action) {
    if (const auto* fling = std::get_if<Fling>(&action)) set(fling->velocity);
    if (const auto* place = std::get_if<Place>(&action))
      body_.setPos(place->position.x_px, place->position.y_px);
    if (std::holds_alternative<Stop>(action)) body_.resetVelocity();
    if (const auto* hitch = std::get_if<Hitch>(&action)) dt_s_ = hitch->dt_s;
    if (const auto* resize = std::get_if<Resize>(&action)) {
      if (resize->window) window_ = *resize->window;
      if (resize->sprite) sprite_ = *resize->sprite;
    }
    if (std::holds_alternative<Grab>(action)) {
      body_.resetVelocity();
      is_held_ = true;
    }
    if (const auto* release = std::get_if<Release>(&action)) {
      set(release->velocity);
      is_held_ = false;
    }
  }

  void set(const Velocity& velocity) { body_.setVelocity(velocity.vx_px_per_s, velocity.vy_px_per_s); }

  // One update; notes what touched and returns the contact byte.
  std::uint8_t step(std::int64_t number) {
    // The listing's flight, written out.
    const double vx = body_.vx() * physics::AIR_DRAG;
    const double vy = (body_.vy() + physics::GRAVITY * dt_s_) * physics::AIR_DRAG;
    const physics flight(body_.x() + vx * dt_s_, body_.y() + vy * dt_s_, vx, vy);
    body_.update(dt_s_, window_.width_px, window_.height_px, sprite_.width_px, sprite_.height_px);
    const double right_px = window_.width_px - sprite_.width_px;
    const double bottom_px = window_.height_px - sprite_.height_px;
    std::uint8_t contact = 0;
    double vx_px_per_s = flight.vx();
    if (flight.x() < 0.0 || flight.x() > right_px) {
      vx_px_per_s = -flight.vx() * physics::RESTITUTION;
      const bool is_left = flight.x() < 0.0;
      contact |= touch(number, is_left ? Wall::left : Wall::right, flight.vx(), flight.vy(), vx_px_per_s,
                       flight.vy(), is_left ? -flight.x() : flight.x() - right_px);
    }
    if (flight.y() < 0.0 || flight.y() > bottom_px) {
      const bool is_top = flight.y() < 0.0;
      contact |= touch(number, is_top ? Wall::top : Wall::ground, vx_px_per_s, flight.vy(), body_.vx(),
                       body_.vy(), is_top ? -flight.y() : flight.y() - bottom_px);
      if (!is_top && std::fabs(flight.vy() * physics::RESTITUTION) < physics::REST_THRESHOLD)
        contact |= kRestBit;
    }
    return contact;
  }

  std::uint8_t touch(std::int64_t number, Wall wall, double vx_before, double vy_before, double vx_after,
                     double vy_after, double overshoot_px) {
    std::optional<std::size_t>& open = open_[wall_index(wall)];
    if (!open || run_.contacts[*open].last_step != number - 1) {
      open = run_.contacts.size();
      run_.contacts.push_back({number, number, wall, timeline_.time_s(), body_.x(), body_.y(), vx_before,
                               vy_before, vx_after, vy_after, overshoot_px});
    }
    run_.contacts[*open].last_step = number;
    return static_cast<std::uint8_t>(wall);
  }

  void record(std::int64_t number, double t_s, std::uint8_t contact) {
    run_.rows.push_back(
        {number, t_s, number == 0 ? 0.0 : dt_s_, body_.x(), body_.y(), body_.vx(), body_.vy(), contact});
    run_.floors_px.push_back(window_.height_px - sprite_.height_px);
    const bool is_inside = body_.x() >= 0.0 && body_.x() <= window_.width_px - sprite_.width_px &&
                           body_.y() >= 0.0 && body_.y() <= window_.height_px - sprite_.height_px;
    if (!is_inside && !run_.out_of_bounds_step) run_.out_of_bounds_step = number;
  }

  const Scenario& scenario_;
  FrameClock clock_;
  physics body_;
  Size window_;
  Size sprite_;
  bool is_held_ = false;
  double dt_s_ = 0.0;
  Timeline timeline_;
  std::array<std::optional<std::size_t>, 4> open_;
  PlainRun run_;
};

}  // namespace hyrax
