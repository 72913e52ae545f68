#include "tools/files/quantity_reader.h"

namespace hyrax {
namespace {

Size read_size(const JsonPlace& here, std::int64_t low_px, std::int64_t high_px) {
  if (!here.is_object_of({"width_px", "height_px"})) return {};
  return {static_cast<std::int32_t>(here.required("width_px").integer(low_px, high_px).value_or(0)),
          static_cast<std::int32_t>(here.required("height_px").integer(low_px, high_px).value_or(0))};
}

}  // namespace

Size read_window(const JsonPlace& here) { return read_size(here, 0, kWindowSideMax_px); }
Size read_sprite(const JsonPlace& here) { return read_size(here, kSpriteSideMin_px, kSpriteSideMax_px); }

Position read_position(const JsonPlace& here) {
  return {here.required("x_px").number(kCoordinateRule).value_or(0.0),
          here.required("y_px").number(kCoordinateRule).value_or(0.0)};
}

Velocity read_velocity(const JsonPlace& here) {
  if (!here.is_object_of({"vx_px_per_s", "vy_px_per_s"})) return {};
  return {here.required("vx_px_per_s").number(kSpeedRule).value_or(0.0),
          here.required("vy_px_per_s").number(kSpeedRule).value_or(0.0)};
}

}  // namespace hyrax
