#include "tools/files/non_finite_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/scenario/frame_clock.h"

namespace hyrax {
namespace {

std::string time_text(double t_s) {
  char text[32];
  const auto format = t_s < 0.1 ? std::chars_format::general : std::chars_format::fixed;
  return {text, std::to_chars(text, std::end(text), t_s, format, 2).ptr};
}

}  // namespace

std::string non_finite_text(const Scenario& scenario, const Row& last) {
  const std::array<std::pair<const char*, double>, 4> fields = {
      {{"vx", last.vx_px_per_s}, {"vy", last.vy_px_per_s}, {"x", last.x_px}, {"y", last.y_px}}};
  for (const auto& [name, value] : fields) {
    if (std::isfinite(value)) continue;
    return std::string(name) + (std::isnan(value) ? " is NaN" : " is infinite") + " from step " +
           std::to_string(last.step) + " of " + std::to_string(step_count(scenario)) + " (" +
           time_text(last.t_s) + " s)";
  }
  return "";
}

}  // namespace hyrax
