#include "tools/recorder/physics_recorder.h"

#include <cmath>

namespace hyrax {
namespace {

bool is_within(double value, double max) { return std::fabs(value) <= max; }  // A NaN is not.

bool fits(const State& body) {
  return is_within(body.x_px, kCoordinateMax_px) && is_within(body.y_px, kCoordinateMax_px) &&
         is_within(body.vx_px_per_s, kSpeedMax_px_per_s) && is_within(body.vy_px_per_s, kSpeedMax_px_per_s);
}

bool fits(const Size& size, std::int64_t min, std::int64_t max) {
  return size.width_px >= min && size.width_px <= max && size.height_px >= min && size.height_px <= max;
}

bool fits(const State& body, const Size& window, const Size& sprite) {
  return fits(body) && fits(window, 0, kWindowSideMax_px) &&
         fits(sprite, kSpriteSideMin_px, kSpriteSideMax_px);
}

constexpr char kUnfit[] = "a dt, size, position or speed that no scenario may have";

Keyframe keyframe_of(const State& body, const Size& window, const Size& sprite) {
  Keyframe keyframe;
  set_state(keyframe.row, body);
  keyframe.window = window;
  keyframe.sprite = sprite;
  return keyframe;
}

}  // namespace

FrameRecorder::FrameRecorder(const std::string& path, const Core& core, const State& start, Size window,
                             Size sprite)
    : ProgramRecorder(path, scenario_file_text), player_(core, keyframe_of(start, window, sprite)) {
  fits(start, window, sprite) ? ProgramRecorder::start(player_.now()) : stop(kUnfit);
}

void FrameRecorder::begin_frame(const State& body, std::vector<std::byte> object, double dt_s,
                                const Size& window, const Size& sprite, bool is_held) {
  if (!is_recording()) return;
  if (!fits(body, window, sprite) || !(dt_s >= 0.0 && dt_s <= kFrameMax_s)) return stop(kUnfit);
  const Keyframe& now = player_.now();
  const auto input = [&](const Action& action) {
    player_.apply(action);
    add_input(action);
  };
  Resize resize;
  if (now.window != window) resize.window = window;
  if (now.sprite != sprite) resize.sprite = sprite;
  if (resize.window || resize.sprite) input(resize);
  if (is_held && !now.is_held) input(Grab{});
  if (!same_bits(now.row.x_px, body.x_px) || !same_bits(now.row.y_px, body.y_px))
    input(Place{{body.x_px, body.y_px}});
  if (!is_held && now.is_held) input(Release{velocity_of(body)});
  if (!same_bits(now.row.vx_px_per_s, body.vx_px_per_s) || !same_bits(now.row.vy_px_per_s, body.vy_px_per_s))
    input(Fling{velocity_of(body)});
  player_.go_on_from(body, std::move(object));
}

// The row is what the program has: if that is not what its step makes, the replay shows it.
void FrameRecorder::end_frame(const State& body, double dt_s) {
  if (!is_recording()) return;
  player_.advance(dt_s);
  if (!same_bits(state_of(player_.now().row), body)) player_.go_on_from(body, {});
  add_frame(player_.now());
  if (!is_finite(body)) stop("the state is not finite");
}

}  // namespace hyrax
