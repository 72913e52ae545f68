#include "tools/report/run_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "sim/scenario/apply.h"

namespace hyrax {
namespace {

// Row `step`, if it was recorded.
std::optional<Row> row_at(const Columns& rows, std::int64_t step) {
  const auto found = std::lower_bound(rows.step.begin(), rows.step.end(), step);
  if (found == rows.step.end() || *found != step) return std::nullopt;
  return rows.row(static_cast<std::size_t>(std::distance(rows.step.begin(), found)));
}

// The body that the events of a frame are applied to.
struct Thrown {
  void setPos(double x_px, double y_px) { position = Position{x_px, y_px}; }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) { velocity = Velocity{vx_px_per_s, vy_px_per_s}; }
  void resetVelocity() { velocity.reset(); }

  Size window;
  Size sprite;
  bool is_held = false;
  std::optional<Position> position;
  std::optional<Velocity> velocity;
};

Throw thrown_from(const Position& corner, const Size& sprite, const Velocity& velocity) {
  return {corner.x_px + sprite.width_px / 2.0, corner.y_px + sprite.height_px / 2.0, velocity};
}

}  // namespace

std::vector<Throw> throws_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                             const Columns& rows, const SizesInForce& sizes) {
  std::vector<Throw> throws = {thrown_from(scenario.start, scenario.sprite, scenario.start_velocity)};
  Thrown thrown;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    apply(scenario.events[i].action, thrown);
    if (i + 1 < frames.size() && frames[i + 1] == frames[i]) continue;
    const auto row = row_at(rows, frames[i]);
    if (thrown.velocity && !thrown.is_held && row)
      throws.push_back(thrown_from(thrown.position.value_or(Position{row->x_px, row->y_px}),
                                   sizes.at(frames[i]).sprite, *thrown.velocity));
    thrown.position.reset();
    thrown.velocity.reset();
  }
  return throws;
}

std::vector<TimedInput> timed_inputs_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                                        const Columns& rows, const SizesInForce& sizes) {
  constexpr std::int64_t kOfAKindMax = 4;
  std::array<std::int64_t, kActionNames.size()> counts{}, numbers{};
  for (const Event& event : scenario.events) ++counts[event.action.index()];
  std::vector<TimedInput> inputs;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Action& action = scenario.events[i].action;
    const std::int64_t count = counts[action.index()], number = ++numbers[action.index()];
    const auto row = row_at(rows, frames[i]);
    if (!row || (count > kOfAKindMax && number > 1 && number < count)) continue;
    const Size& sprite = sizes.at(frames[i]).sprite;
    TimedInput input{name_of(action), row->t_s, row->x_px + sprite.width_px / 2.0,
                     row->y_px + sprite.height_px / 2.0};
    if (const auto* const place = std::get_if<Place>(&action)) {
      input.x_px = place->position.x_px + sprite.width_px / 2.0;
      input.y_px = place->position.y_px + sprite.height_px / 2.0;
    }
    if (const auto* const resize = std::get_if<Resize>(&action)) {
      input.what = resize->window ? "window" : "sprite";
      if (resize->window) {
        input.x_px = resize->window->width_px;
        input.y_px = resize->window->height_px / 2.0;
      }
    }
    inputs.push_back(input);
  }
  return inputs;
}

double speed_px_per_s(const Velocity& velocity) {
  return std::hypot(velocity.vx_px_per_s, velocity.vy_px_per_s);
}

}  // namespace hyrax
