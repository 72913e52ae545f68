#include "tools/report/run_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/resting_contact.h"

namespace hyrax {
namespace {

Box sprite_box(double x_px, double y_px, const Size& sprite) {
  return {x_px, y_px, x_px + sprite.width_px, y_px + sprite.height_px};
}

Box around(const Box& a, const Box& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

Box grown(const Box& box, double by_px) {
  return {box.left - by_px, box.top - by_px, box.right + by_px, box.bottom + by_px};
}

double longer_side_px(const Box& box) { return std::max(box.width(), box.height()); }

std::vector<Size> windows_of(const SizesInForce& sizes) {
  std::vector<Size> windows;
  for (const auto& change : sizes.changes())
    if (std::find(windows.begin(), windows.end(), change.window) == windows.end())
      windows.push_back(change.window);
  return windows;
}

std::vector<Size> shown(const std::vector<Size>& windows) {
  if (windows.size() <= kWindowsShownMax) return windows;
  std::vector<Size> some;
  for (std::size_t i = 0; i < kWindowsShownMax; ++i)
    some.push_back(windows[i * (windows.size() - 1) / (kWindowsShownMax - 1)]);
  return some;
}

// Of a view that is much longer than wide only what is visited along its longer side, and some space.
Box cropped(const Box& view, const Box& visited) {
  constexpr double kOdd = 4.0;
  const double shorter_px = std::min(view.width(), view.height());
  if (longer_side_px(view) < kOdd * shorter_px || !(visited.left <= visited.right)) return view;
  const Box part = grown(visited, 0.5 * shorter_px);
  Box kept = view;
  if (view.width() > view.height()) {
    kept.left = std::max(view.left, part.left);
    kept.right = std::min(view.right, part.right);
  } else {
    kept.top = std::max(view.top, part.top);
    kept.bottom = std::min(view.bottom, part.bottom);
  }
  return kept;
}

// The windows, with the sprite wherever it is no farther from them than half their longer side: a
// start a million px away must not make the window a dot.
Box view_of(const std::vector<Size>& windows, const Columns& rows, const SizesInForce& sizes) {
  Box room;
  for (const Size& window : windows)
    room =
        around(room, {0.0, 0.0, static_cast<double>(window.width_px), static_cast<double>(window.height_px)});
  const Size& sprite = sizes.changes().front().sprite;
  const Box near = grown(room, longer_side_px(room) / 2 + std::max(sprite.width_px, sprite.height_px));

  Box view = room, visited = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Box outline = sprite_box(rows.x_px[i], rows.y_px[i], sizes.at(rows.step[i]).sprite);
    if (near.holds(outline.left, outline.top) && near.holds(outline.right, outline.bottom))
      visited = around(visited, outline);
  }
  view = around(view, visited.left <= visited.right ? visited : view);
  return grown(cropped(view, visited), 0.015 * std::max(longer_side_px(view), 1.0));
}

// Row `step`, if it was recorded.
std::optional<Row> row_at(const Columns& rows, std::int64_t step) {
  const auto found = std::lower_bound(rows.step.begin(), rows.step.end(), step);
  if (found == rows.step.end() || *found != step) return std::nullopt;
  return rows.row(static_cast<std::size_t>(std::distance(rows.step.begin(), found)));
}

Throw thrown_from(const State& state, const Size& sprite) {
  return {state.x_px + sprite.width_px / 2.0, state.y_px + sprite.height_px / 2.0, velocity_of(state)};
}

// In order of time; those in rows that are not recorded are left out. `frames` are those of the events.
std::vector<Throw> throws_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                             const Columns& rows, const SizesInForce& sizes) {
  std::vector<Throw> throws = {thrown_from(start_state(scenario), scenario.sprite)};
  World world;
  for (std::size_t i = 0; i < frames.size();) {
    const std::int64_t frame = frames[i];
    const auto row = row_at(rows, frame);
    if (row) world.state = state_of(*row);
    bool is_thrown = false;
    for (; i < frames.size() && frames[i] == frame; ++i) {
      const Action& action = scenario.events[i].action;
      apply(action, world);
      is_thrown |= std::holds_alternative<Fling>(action) || std::holds_alternative<Release>(action);
    }
    if (is_thrown && !world.is_held && row)
      throws.push_back(thrown_from(world.state, sizes.at(frame).sprite));
  }
  return throws;
}

// The same, and of many inputs of one kind all but the first and the last are left out.
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
    const auto* const place = std::get_if<Place>(&action);
    const Position corner = place != nullptr ? place->position : Position{row->x_px, row->y_px};
    TimedInput input{name_of(action), row->t_s, corner.x_px + sprite.width_px / 2.0,
                     corner.y_px + sprite.height_px / 2.0};
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

// The first throws that can be seen.
std::vector<Throw> throws_in(const Box& view, std::vector<Throw> throws) {
  std::erase_if(throws, [&view](const Throw& one) {
    return one.velocity == Velocity{} || !view.holds(one.x_px, one.y_px);
  });
  throws.resize(std::min(throws.size(), kThrowsShownMax));
  return throws;
}

// By the rows that are recorded: the floor is that of the contact's stretch, which the next event ends.
bool is_resting(const Contact& contact, const Columns& rows, const SizesInForce& sizes,
                const std::vector<std::int64_t>& frames) {
  if (contact.wall != Wall::ground) return false;
  const auto event = std::lower_bound(frames.begin(), frames.end(), contact.step);
  const std::int64_t end = event == frames.end() ? rows.step.back() : *event;
  const SizesInForce::Change& size = sizes.at(contact.step);
  const double floor_px = bounds_of(size.window, size.sprite).bottom_px;
  auto row = std::upper_bound(rows.step.begin(), rows.step.end(), contact.step);
  if (row == rows.step.end() || *row > end) return false;
  for (; row != rows.step.end() && *row <= end; ++row)
    if (!RestingContact::is_near(rows.y_px[static_cast<std::size_t>(row - rows.step.begin())], floor_px))
      return false;
  return true;
}

std::vector<Box> ghosts_of(const std::vector<Touch>& touches) {
  constexpr double kTolerance = 0.2;
  std::vector<Box> ghosts;
  for (const Touch& touch : touches) {
    const auto covers = [&touch](const Box& ghost) { return nearly_cover(ghost, touch.sprite, kTolerance); };
    if (!touch.is_resting && std::none_of(ghosts.begin(), ghosts.end(), covers))
      ghosts.push_back(touch.sprite);
  }
  return ghosts;
}

std::optional<Box> outline_at(const Columns& rows, std::size_t index, const SizesInForce& sizes) {
  const Row row = rows.row(index);
  if (!is_finite(state_of(row))) return std::nullopt;
  return sprite_box(row.x_px, row.y_px, sizes.at(row.step).sprite);
}

// Nothing where the run stays finite.
std::optional<SvgPoint> last_finite(const Columns& rows, const SizesInForce& sizes, const Box& view) {
  std::size_t index = rows.size() - 1;
  while (index > 0 && !outline_at(rows, index, sizes)) --index;
  const std::optional<Box> box = outline_at(rows, index, sizes);
  if (!box || index + 1 == rows.size()) return std::nullopt;
  const SvgPoint centre = box->centre();
  return view.holds(centre.x, centre.y) ? std::optional(centre) : std::nullopt;
}

}  // namespace

SizesInForce::SizesInForce(const Scenario& scenario, const std::vector<std::int64_t>& frames)
    : changes_{{0, scenario.window, scenario.sprite}} {
  World world{.state = {}, .window = scenario.window, .sprite = scenario.sprite};
  for (std::size_t i = 0; i < scenario.events.size(); ++i) {
    apply(scenario.events[i].action, world);
    if (world.window != changes_.back().window || world.sprite != changes_.back().sprite)
      changes_.push_back({frames[i] + 1, world.window, world.sprite});
  }
}

const SizesInForce::Change& SizesInForce::at(std::int64_t step) const {
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), step,
                       [](std::int64_t value, const Change& change) { return value < change.first_step; });
  return *std::prev(after);
}

bool nearly_cover(const Box& a, const Box& b, double tolerance) {
  const double dx_px = std::max(std::fabs(a.left - b.left), std::fabs(a.right - b.right));
  const double dy_px = std::max(std::fabs(a.top - b.top), std::fabs(a.bottom - b.bottom));
  return dx_px < tolerance * a.width() && dy_px < tolerance * a.height();
}

RunScene make_run_scene(const Scenario& scenario, const Columns& rows, const std::vector<Contact>& contacts,
                        double view_parts) {
  std::vector<std::int64_t> frames;
  if (!scenario.events.empty()) frames = schedule_events(scenario, step_count(scenario)).frames;
  const SizesInForce sizes(scenario, frames);

  RunScene scene;
  const std::vector<Size> windows = windows_of(sizes);
  scene.windows = shown(windows);
  scene.view = view_of(windows, rows, sizes);
  scene.path = make_run_path(rows, sizes, longer_side_px(scene.view) / view_parts);
  scene.throws = throws_in(scene.view, throws_of(scenario, frames, rows, sizes));
  scene.inputs = timed_inputs_of(scenario, frames, rows, sizes);
  std::erase_if(scene.inputs,
                [&scene](const TimedInput& input) { return !scene.view.holds(input.x_px, input.y_px); });
  scene.inputs.resize(std::min(scene.inputs.size(), kInputsLabelledMax));
  for (const Contact& contact : contacts) {
    const bool rests = is_resting(contact, rows, sizes, frames);
    if (!rests) ++scene.bounces[contact.wall];
    if (scene.touches.size() < kTouchesShownMax)
      scene.touches.push_back(
          {contact.wall, sprite_box(contact.x_px, contact.y_px, sizes.at(contact.step).sprite), rests});
  }
  scene.ghosts = ghosts_of(scene.touches);
  if (rows.size() > 0) {
    scene.start = outline_at(rows, 0, sizes);
    scene.end = outline_at(rows, rows.size() - 1, sizes);
    scene.not_finite = last_finite(rows, sizes, scene.view);
  }
  return scene;
}

}  // namespace hyrax
