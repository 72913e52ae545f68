#include "tools/report/run_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

Box sprite_box(double x_px, double y_px, const Size& sprite) {
  return {x_px, y_px, x_px + sprite.width_px, y_px + sprite.height_px};
}

Box around(const Box& a, const Box& b) {
  return {std::min(a.left_px, b.left_px), std::min(a.top_px, b.top_px), std::max(a.right_px, b.right_px),
          std::max(a.bottom_px, b.bottom_px)};
}

Box grown(const Box& box, double by_px) {
  return {box.left_px - by_px, box.top_px - by_px, box.right_px + by_px, box.bottom_px + by_px};
}

double longer_side_px(const Box& box) { return std::max(box.width_px(), box.height_px()); }

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
  const double shorter_px = std::min(view.width_px(), view.height_px());
  if (longer_side_px(view) < kOdd * shorter_px || !(visited.left_px <= visited.right_px)) return view;
  const Box part = grown(visited, 0.5 * shorter_px);
  Box kept = view;
  if (view.width_px() > view.height_px()) {
    kept.left_px = std::max(view.left_px, part.left_px);
    kept.right_px = std::min(view.right_px, part.right_px);
  } else {
    kept.top_px = std::max(view.top_px, part.top_px);
    kept.bottom_px = std::min(view.bottom_px, part.bottom_px);
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
    if (near.holds(outline.left_px, outline.top_px) && near.holds(outline.right_px, outline.bottom_px))
      visited = around(visited, outline);
  }
  view = around(view, visited.left_px <= visited.right_px ? visited : view);
  return grown(cropped(view, visited), 0.015 * std::max(longer_side_px(view), 1.0));
}

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

// In order of time; those in rows that are not recorded are left out. `frames` are those of the events.
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

std::vector<Bounce> bounces_of(const std::vector<Contact>& contacts, const SizesInForce& sizes) {
  std::vector<Bounce> bounces;
  for (std::size_t i = 0; i < std::min(contacts.size(), kBouncesShownMax); ++i)
    bounces.push_back({contacts[i].wall,
                       sprite_box(contacts[i].x_px, contacts[i].y_px, sizes.at(contacts[i].step).sprite)});
  return bounces;
}

std::vector<Box> ghosts_of(const std::vector<Bounce>& bounces) {
  constexpr double kTolerance = 0.2;  // Contacts at rest would pile up.
  std::vector<Box> ghosts;
  for (const Bounce& bounce : bounces) {
    const auto covers = [&bounce](const Box& ghost) {
      return nearly_cover(ghost, bounce.sprite, kTolerance);
    };
    if (std::none_of(ghosts.begin(), ghosts.end(), covers)) ghosts.push_back(bounce.sprite);
  }
  return ghosts;
}

std::optional<Box> outline_at(const Columns& rows, std::size_t index, const SizesInForce& sizes) {
  const Row row = rows.row(index);
  if (!is_finite(state_of(row))) return std::nullopt;
  return sprite_box(row.x_px, row.y_px, sizes.at(row.step).sprite);
}

// Nothing where the run stays finite.
std::optional<PathPoint> last_finite(const Columns& rows, const SizesInForce& sizes, const Box& view) {
  std::size_t index = rows.size() - 1;
  while (index > 0 && !outline_at(rows, index, sizes)) --index;
  const std::optional<Box> box = outline_at(rows, index, sizes);
  if (!box || index + 1 == rows.size()) return std::nullopt;
  const PathPoint centre{(box->left_px + box->right_px) / 2, (box->top_px + box->bottom_px) / 2, 0.0};
  return view.holds(centre.x_px, centre.y_px) ? std::optional(centre) : std::nullopt;
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
  const double dx_px = std::max(std::fabs(a.left_px - b.left_px), std::fabs(a.right_px - b.right_px));
  const double dy_px = std::max(std::fabs(a.top_px - b.top_px), std::fabs(a.bottom_px - b.bottom_px));
  return dx_px < tolerance * a.width_px() && dy_px < tolerance * a.height_px();
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
  scene.bounces = bounces_of(contacts, sizes);
  scene.ghosts = ghosts_of(scene.bounces);
  for (const Contact& contact : contacts) ++scene.contacts[contact.wall];
  if (rows.size() > 0) {
    scene.start = outline_at(rows, 0, sizes);
    scene.end = outline_at(rows, rows.size() - 1, sizes);
    scene.not_finite = last_finite(rows, sizes, scene.view);
  }
  return scene;
}

}  // namespace hyrax
