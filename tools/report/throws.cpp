#include "tools/report/throws.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace hyrax {
namespace {

// Row `step`, if it was recorded.
std::optional<Row> row_at(const Columns& rows, std::int64_t step) {
  const auto found = std::lower_bound(rows.step.begin(), rows.step.end(), step);
  if (found == rows.step.end() || *found != step) return std::nullopt;
  return rows.row(static_cast<std::size_t>(std::distance(rows.step.begin(), found)));
}

std::optional<Velocity> velocity_given(const Action& action) {
  if (const auto* const fling = std::get_if<Fling>(&action)) return fling->velocity;
  if (const auto* const release = std::get_if<Release>(&action)) return release->velocity;
  return std::nullopt;
}

Throw thrown_from(const Position& corner, const Size& sprite, const Velocity& velocity) {
  return {corner.x_px + sprite.width_px / 2.0, corner.y_px + sprite.height_px / 2.0, velocity};
}

}  // namespace

std::vector<Throw> throws_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                             const Columns& rows, const SizesInForce& sizes) {
  std::vector<Throw> throws = {thrown_from(scenario.start, scenario.sprite, scenario.start_velocity)};
  std::optional<Position> placed;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i > 0 && frames[i] != frames[i - 1]) placed.reset();
    if (const auto* const place = std::get_if<Place>(&scenario.events[i].action)) placed = place->position;
    const auto velocity = velocity_given(scenario.events[i].action);
    const auto row = row_at(rows, frames[i]);
    if (velocity && row)
      throws.push_back(thrown_from(placed.value_or(Position{row->x_px, row->y_px}),
                                   sizes.at(frames[i]).sprite, *velocity));
  }
  return throws;
}

std::vector<TimedInput> timed_inputs_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                                        const Columns& rows, const SizesInForce& sizes) {
  constexpr std::ptrdiff_t kResizesMax = 4;
  const auto is_resize = [](const Event& event) { return std::holds_alternative<Resize>(event.action); };
  const auto resizes = std::count_if(scenario.events.begin(), scenario.events.end(), is_resize);
  std::ptrdiff_t resize_number = 0;
  std::vector<TimedInput> inputs;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Action& action = scenario.events[i].action;
    const auto row = row_at(rows, frames[i]);
    const bool is_between = is_resize(scenario.events[i]) && ++resize_number > 1 && resize_number < resizes &&
                            resizes > kResizesMax;
    if (!row || is_between) continue;
    const auto& size = sizes.at(frames[i]);
    TimedInput input{"", row->t_s, row->x_px + size.sprite.width_px / 2.0,
                     row->y_px + size.sprite.height_px / 2.0};
    if (std::holds_alternative<Grab>(action)) input.what = "grab";
    if (std::holds_alternative<Release>(action)) input.what = "release";
    if (const auto* const resize = std::get_if<Resize>(&action)) {
      input.what = resize->window ? "window" : "sprite";
      if (resize->window) {
        input.x_px = resize->window->width_px;
        input.y_px = resize->window->height_px / 2.0;
      }
    }
    if (!input.what.empty()) inputs.push_back(input);
  }
  return inputs;
}

double speed_px_per_s(const Velocity& velocity) {
  return std::hypot(velocity.vx_px_per_s, velocity.vy_px_per_s);
}

}  // namespace hyrax
