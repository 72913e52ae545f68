#include "sim/trace/step_draw.h"

#include <algorithm>
#include <cmath>

#include "sim/motion/displays.h"

namespace hyrax {
namespace {

constexpr double kSideMax_px = 1'000'000.0;
constexpr double kMotionMax = 1e12;  // Of coordinates in px and of speeds in px/s.
constexpr double kFrameMax_s = 1e9;

constexpr std::array kLongFrames_s = {0.01, 0.05, 0.1, 0.11, 0.125, 0.2, 0.25, 0.35, 0.5, 1.0, 0.0, -0.0};

double& of(StepNumbers& numbers, StepNumber number) { return numbers[static_cast<std::size_t>(number)]; }

}  // namespace

std::vector<StepNumberBits> dependencies_of(const TracedStep& step) {
  std::vector<std::string> names;
  for (std::size_t member = 0; member < 4; ++member) names.push_back(member_name(member));
  const auto& arguments = kArgumentNames[static_cast<std::size_t>(CoreFunction::update)];
  names.insert(names.end(), arguments.begin(), arguments.end());
  std::vector<StepNumberBits> dependencies;
  for (const Expression& expression : step.expressions) {
    StepNumberBits bits = 0;
    if (expression.op == Operator::argument)
      bits = bits_of(std::ranges::find(names, expression.name) - names.begin());
    for (const StepIndex operand : expression.used_operands()) bits |= dependencies[operand];
    dependencies.push_back(bits);
  }
  return dependencies;
}

StepInput input_of(const StepNumbers& numbers) {
  const auto side = [&](StepNumber number) {
    return static_cast<std::int32_t>(numbers[static_cast<std::size_t>(number)]);
  };
  StepInput input;
  input.world.state = {numbers[0], numbers[1], numbers[2], numbers[3]};
  input.world.window = {side(StepNumber::window_width), side(StepNumber::window_height)};
  input.world.sprite = {side(StepNumber::sprite_width), side(StepNumber::sprite_height)};
  input.dt_s = numbers[4];
  return input;
}

double limited(StepNumber number, double value) {
  switch (number) {
    case StepNumber::dt:
      return std::clamp(value, 0.0, kFrameMax_s);
    case StepNumber::window_width:
    case StepNumber::window_height:
      return std::clamp(std::nearbyint(value), 0.0, kSideMax_px);
    case StepNumber::sprite_width:
    case StepNumber::sprite_height:
      return std::clamp(std::nearbyint(value), 1.0, kSideMax_px);
    default:
      return std::clamp(value, -kMotionMax, kMotionMax);
  }
}

StepDraw::StepDraw(const TracedStep& a, const TracedStep& b, std::uint64_t seed) : random_(seed) {
  for (const TracedStep* const step : {&a, &b})
    for (const Expression& expression : step->expressions)
      if (expression.op == Operator::constant && std::isfinite(expression.value))
        constants_.push_back(expression.value);
  constants_.push_back(1.0);
  std::sort(constants_.begin(), constants_.end());
  constants_.erase(std::unique(constants_.begin(), constants_.end()), constants_.end());
}

double StepDraw::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
}

double StepDraw::of_any_size(int low, int high) {
  const int exponent = low + static_cast<int>(below(static_cast<std::size_t>(high - low)));
  return std::ldexp(uniform(1.0, 2.0), exponent) * (below(2) == 0 ? 1.0 : -1.0);
}

StepNumbers StepDraw::numbers(bool is_real) {
  StepNumbers numbers{};
  draw_sizes(numbers, is_real);
  of(numbers, StepNumber::dt) = drawn_dt_s(is_real);
  of(numbers, StepNumber::x) =
      position(of(numbers, StepNumber::window_width) - of(numbers, StepNumber::sprite_width));
  of(numbers, StepNumber::y) =
      position(of(numbers, StepNumber::window_height) - of(numbers, StepNumber::sprite_height));
  of(numbers, StepNumber::vx) = speed();
  of(numbers, StepNumber::vy) = speed();
  for (std::size_t index = 0; index < kStepNumbers; ++index)
    numbers[index] = limited(static_cast<StepNumber>(index), numbers[index]);
  return numbers;
}

void StepDraw::draw_sizes(StepNumbers& numbers, bool is_real) {
  const Size& display = kDisplays[below(kDisplays.size())];
  const double side_px = below(4) != 0 ? 128.0 : below(2) == 0 ? 64.0 : std::nearbyint(uniform(1.0, 300.0));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double& window_px = numbers[static_cast<std::size_t>(StepNumber::window_width) + axis];
    double& sprite_px = numbers[static_cast<std::size_t>(StepNumber::sprite_width) + axis];
    sprite_px = is_real || below(4) != 0 ? side_px : any_side();
    window_px = is_real || below(4) == 0 ? (axis == 0 ? display.width_px : display.height_px) : any_side();
    // A bound rather than a side may be what is asked for.
    if (!is_real && below(3) == 0) window_px += sprite_px;
  }
}

// At, around and between the constants of the steps; else any.
double StepDraw::any_side() {
  const std::size_t first = below(constants_.size());
  switch (below(4)) {
    case 0:
      return constants_[first] + static_cast<double>(below(3)) - 1.0;
    case 1:
      return uniform(constants_[first], constants_[std::min(first + 1, constants_.size() - 1)]);
    case 2:
      return uniform(1.0, 6000.0);
    default:
      return std::fabs(of_any_size(0, 20));
  }
}

double StepDraw::drawn_dt_s(bool is_real) {
  if (is_real ? below(8) != 0 : below(2) != 0) return 1.0 / kDisplayRates_hz[below(kDisplayRates_hz.size())];
  if (is_real || below(2) == 0) return kLongFrames_s[below(kLongFrames_s.size())];
  if (below(4) == 0) return constants_[below(constants_.size())];
  return std::fabs(below(8) == 0 ? of_any_size(-40, 30) : of_any_size(-10, 1));
}

double StepDraw::position(double bound_px) {
  switch (below(8)) {
    case 0:
      return below(4) == 0 ? -0.0 : 0.0;
    case 1:
      return bound_px;
    case 2:
      return uniform(-3.0, 3.0);
    case 3:
      return bound_px + uniform(-3.0, 3.0);
    case 4:
      return constants_[below(constants_.size())];
    case 5:
      return below(4) == 0 ? of_any_size(-10, 39) : uniform(-20.0, bound_px + 20.0);
    default:
      return uniform(0.0, bound_px);
  }
}

double StepDraw::speed() {
  const double sign = below(2) == 0 ? 1.0 : -1.0;
  switch (below(6)) {
    case 0:
      return 0.0 * sign;
    case 1:
      return constants_[below(constants_.size())] * sign;
    case 2:
      return constants_[below(constants_.size())] * sign * uniform(0.99, 1.01);
    case 3:
      return below(4) == 0 ? of_any_size(-40, 39) : of_any_size(-6, 14);
    default:
      return uniform(-3000.0, 3000.0);
  }
}

}  // namespace hyrax
