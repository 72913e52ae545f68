#include "tools/hyrax/desk.h"

#include <cmath>

namespace hyrax {
namespace {

// Positions may be farther away than any window can be.
constexpr double kScreenMax_px = 1e6;

std::int32_t nearest(double offset_px) {
  if (!(offset_px > -kScreenMax_px)) return static_cast<std::int32_t>(-kScreenMax_px);
  if (offset_px > kScreenMax_px) return static_cast<std::int32_t>(kScreenMax_px);
  return static_cast<std::int32_t>(std::lround(offset_px));
}

struct Box {
  double left, top, right, bottom;
};

Box common(const Box& a, const Box& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

double area(const Box& box) {
  return std::max(box.right - box.left, 0.0) * std::max(box.bottom - box.top, 0.0);
}

Box box_of(ScreenPoint origin, const Position& corner, Size size) {
  const double left = origin.x_px + corner.x_px;
  const double top = origin.y_px + corner.y_px;
  return {left, top, left + size.width_px, top + size.height_px};
}

Box box_of(const Desk& desk) { return box_of(desk.origin, {}, desk.work_area); }

// The desks of single monitors, then those of two that touch.
std::vector<Desk> desks_of(const std::vector<Desk>& monitors, Size sprite) {
  std::vector<Desk> desks = monitors;
  for (std::size_t i = 0; i < monitors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Box a = box_of(monitors[i]);
      const Box b = box_of(monitors[j]);
      Box both = common(a, b);  // Their border.
      const bool is_beside = both.left == both.right && both.top < both.bottom;
      const bool is_below = both.top == both.bottom && both.left < both.right;
      if (is_beside) both = {std::min(a.left, b.left), both.top, std::max(a.right, b.right), both.bottom};
      if (is_below) both = {both.left, std::min(a.top, b.top), both.right, std::max(a.bottom, b.bottom)};
      if (is_beside || is_below)
        desks.push_back({{static_cast<std::int32_t>(both.left), static_cast<std::int32_t>(both.top)},
                         {static_cast<int>(both.right - both.left), static_cast<int>(both.bottom - both.top)},
                         sprite});
    }
  return desks;
}

}  // namespace

Size sprite_at(int dpi) {
  const int side_px = std::max((kUsualSprite_px * dpi + kUsualDpi / 2) / kUsualDpi, 1);
  return {side_px, side_px};
}

int frame_rate_hz(int display_hz) { return display_hz <= 1 ? 60 : std::clamp(display_hz, 30, 240); }

ScreenPoint on_screen(const Desk& desk, const Position& position) {
  return {desk.origin.x_px + nearest(position.x_px), desk.origin.y_px + nearest(position.y_px)};
}

Shown shown_on(const Desk& desk, Size window, Size sprite, const Position& position) {
  const double scale = std::min({1.0, static_cast<double>(desk.work_area.width_px) / window.width_px,
                                 static_cast<double>(desk.work_area.height_px) / window.height_px});
  return {on_screen(desk, {position.x_px * scale, position.y_px * scale}),
          {std::max(static_cast<int>(sprite.width_px * scale), 1),
           std::max(static_cast<int>(sprite.height_px * scale), 1)}};
}

bool is_one_of(const std::vector<Desk>& monitors, const Desk& desk) {
  return std::ranges::count(desks_of(monitors, desk.sprite), desk) > 0;
}

Desk desk_of_way(const std::vector<Desk>& monitors, const Desk& now, const Position& from,
                 const Position& to) {
  const Box begin = box_of(now.origin, from, now.sprite);
  const Box end = box_of(now.origin, to, now.sprite);
  const Box way{std::min(begin.left, end.left), std::min(begin.top, end.top),
                std::max(begin.right, end.right), std::max(begin.bottom, end.bottom)};
  Desk best = now;
  double best_area = 0.0;
  for (const Desk& desk : desks_of(monitors, now.sprite)) {
    const Box room = box_of(desk);
    const bool has_sprite = begin.left >= room.left && begin.top >= room.top && begin.right <= room.right &&
                            begin.bottom <= room.bottom;
    const double room_area = area(common(way, room));
    if (!has_sprite || !(room_area > best_area)) continue;
    best = desk;
    best_area = room_area;
  }
  return best;
}

std::vector<Action> inputs_of_move(const Desk& from, const Desk& to, const Position& position) {
  std::vector<Action> inputs;
  Resize resize;
  if (from.work_area != to.work_area) resize.window = to.work_area;
  if (from.sprite != to.sprite) resize.sprite = to.sprite;
  if (resize.window || resize.sprite) inputs.emplace_back(resize);
  if (from.origin != to.origin)
    inputs.emplace_back(Place{{position.x_px + (from.origin.x_px - to.origin.x_px),
                               position.y_px + (from.origin.y_px - to.origin.y_px)}});
  return inputs;
}

}  // namespace hyrax
