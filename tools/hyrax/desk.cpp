#include "tools/hyrax/desk.h"

#include <algorithm>
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

}  // namespace

Size sprite_at(int dpi) {
  const int side_px = std::max((kUsualSprite_px * dpi + kUsualDpi / 2) / kUsualDpi, 1);
  return {side_px, side_px};
}

int frame_rate_hz(int display_hz) { return display_hz <= 1 ? 60 : std::clamp(display_hz, 30, 240); }

ScreenPoint on_screen(const Desk& desk, const Position& position) {
  return {desk.origin.x_px + nearest(position.x_px), desk.origin.y_px + nearest(position.y_px)};
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
