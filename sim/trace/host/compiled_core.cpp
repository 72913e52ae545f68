#include "sim/trace/host/compiled_core.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include "sim/motion/displays.h"
#include "sim/trace/step_player.h"

namespace hyrax::trace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a call of `function` gets.
struct Call {
  CoreFunction function = CoreFunction::update;
  std::array<double, 4> numbers{};
  std::array<int, 4> sizes{};
};

using Members = std::array<double, 4>;  // x, y, vx, vy.

std::string numbers_of(const Members& members) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "(%.17g, %.17g, %.17g, %.17g)", members[0], members[1], members[2],
                members[3]);
  return text.data();
}

// Both cores, moved alike.
class Pair {
 public:
  Pair(const CompiledCore& core, const StepProgram& program)
      : core_(core), program_(program), memory_(core.size_bytes / sizeof(std::max_align_t) + 1) {}

  // What differs afterwards, in words; nothing if both have the same bits. NaNs are alike.
  std::optional<std::string> call(const Call& call) {
    const Members before = traced_ ? core_.read(memory_.data()) : Members{};
    core_.call(call.function, memory_.data(), call.numbers.data(), call.sizes.data());
    call_traced(call);
    const Members compiled = core_.read(memory_.data());
    const Members traced = {traced_->x(), traced_->y(), traced_->vx(), traced_->vy()};
    const bool are_same =
        std::equal(compiled.begin(), compiled.end(), traced.begin(),
                   [](double x, double y) { return same_bits(x, y) || (std::isnan(x) && std::isnan(y)); });
    if (are_same) return std::nullopt;
    std::string text(kCoreFunctionNames[static_cast<std::size_t>(call.function)]);
    text.append(" of ").append(numbers_of(call.numbers));
    if (call.function == CoreFunction::update)
      for (const int size : call.sizes) text.append(" ").append(std::to_string(size));
    return text + " from " + numbers_of(before) + " is " + numbers_of(compiled) + ", traced " +
           numbers_of(traced);
  }

 private:
  void call_traced(const Call& call) {
    const auto& [a, b, c, d] = call.numbers;
    switch (call.function) {
      case CoreFunction::construct:
        traced_.emplace(program_, State{a, b, c, d});
        break;
      case CoreFunction::update:
        traced_->update(a, call.sizes[0], call.sizes[1], call.sizes[2], call.sizes[3]);
        break;
      case CoreFunction::set_position:
        traced_->setPos(a, b);
        break;
      case CoreFunction::set_velocity:
        traced_->setVelocity(a, b);
        break;
      case CoreFunction::reset_velocity:
        traced_->resetVelocity();
        break;
    }
  }

  const CompiledCore& core_;
  const StepProgram& program_;
  std::vector<std::max_align_t> memory_;
  std::optional<TracedBody> traced_;
};

// Draws what steps may differ at: the step's own constants, bounds, real sizes and rates.
class Draw {
 public:
  explicit Draw(const TracedStep& step) {
    for (const Expression& expression : step.expressions) {
      if (expression.op == Operator::constant) constants_.push_back(expression.value);
      // What the language does not define, no two compilers need do alike.
      converts_to_whole_ |= expression.op == Operator::to_whole;
    }
    constants_.push_back(1.0);
  }

  Call start() {
    Call call{.function = CoreFunction::construct, .sizes = sizes()};
    dt_s_ = dt_s();
    const double right_px = call.sizes[0] - call.sizes[2];
    const double bottom_px = call.sizes[1] - call.sizes[3];
    const double vx = speed();
    const double vy = speed();
    call.numbers = {position(right_px, vx), position(bottom_px, vy), vx, vy};
    sizes_ = call.sizes;
    return call;
  }
  // After start().
  Call step() { return {.function = CoreFunction::update, .numbers = {dt_s_}, .sizes = sizes_}; }
  Call setter() {
    static constexpr std::array kSetters = {CoreFunction::set_position, CoreFunction::set_velocity,
                                            CoreFunction::reset_velocity};
    const CoreFunction function = pick(kSetters);
    if (function == CoreFunction::reset_velocity) return {.function = function};
    return {.function = function, .numbers = {speed(), speed()}};
  }

  std::uint64_t below(std::uint64_t count) { return random_() % count; }

 private:
  template <class List>
  typename List::value_type pick(const List& list) {
    return list[below(list.size())];
  }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  double near(double value) {
    switch (below(4)) {
      case 0:
        return std::nextafter(value, kInfinity);
      case 1:
        return std::nextafter(value, -kInfinity);
      case 2:
        return value * uniform(0.99, 1.01);
      default:
        return value;
    }
  }
  double signed_value(double value) { return below(2) == 0 ? value : -value; }
  double speed() {
    static constexpr std::array kEdges = {
        0.0,       std::numeric_limits<double>::denorm_min(), 1e-300, 1e12, 1e150,
        kInfinity, std::numeric_limits<double>::quiet_NaN()};
    switch (below(6)) {
      case 0:
        return signed_value(near(pick(constants_)));
      case 1:
        return signed_value(std::ldexp(uniform(1.0, 2.0), static_cast<int>(below(44)) - 24));
      case 2:
        return signed_value(kEdges[below(below(8) == 0 && !converts_to_whole_ ? kEdges.size() : 3)]);
      default:
        return uniform(-2500.0, 2500.0);
    }
  }
  double position(double bound_px, double speed_px_per_s) {
    const double flight_px = below(2) == 0 ? speed_px_per_s * dt_s_ : 0.0;
    switch (below(6)) {
      case 0:
        return near(bound_px) - flight_px;
      case 1:
        return signed_value(near(0.0)) - flight_px;
      case 2:
        return speed();
      case 3:
        return near(pick(constants_)) - flight_px;
      default:
        return uniform(0.0, std::max(1.0, bound_px));
    }
  }
  double dt_s() {
    switch (below(5)) {
      case 0:
        return uniform(0.0, 0.1);
      case 1:
        return near(pick(constants_));
      case 2:
        return std::ldexp(uniform(1.0, 2.0), static_cast<int>(below(30)) - 26);
      default:
        return below(20) == 0 ? 0.0 : 1.0 / pick(kDisplayRates_hz);
    }
  }
  int size(int usual) {
    if (below(8) != 0) return usual;
    const double near_constant = pick(constants_) + static_cast<double>(below(3)) - 1.0;
    return below(2) == 0 ? static_cast<int>(std::clamp(near_constant, 1.0, 1e6))
                         : 1 + static_cast<int>(below(9000));
  }
  std::array<int, 4> sizes() {
    const Size window = pick(kDisplays);
    const int sprite_px = 16 << below(5);
    return {size(window.width_px), size(window.height_px), size(sprite_px), size(sprite_px)};
  }

  std::mt19937_64 random_{20261123};
  std::vector<double> constants_;
  bool converts_to_whole_ = false;
  double dt_s_ = 0.0;
  std::array<int, 4> sizes_{};
};

}  // namespace

std::optional<std::string> step_that_differs(const CompiledCore& core, const TracedStep& step,
                                             std::int64_t steps) {
  const auto program = make_step_program(step);
  Draw draw(step);
  // A state of x, y, vx and vy is drawn; what further members hold comes from playing.
  const std::uint64_t calls_max = step.members.size() > 4 ? 60 : 2;
  std::optional<std::string> why;
  while (steps > 0 && !why) {
    Pair pair(core, *program);
    const auto agree = [&](const Call& call) {
      why = pair.call(call);
      return !why;
    };
    if (!agree(draw.start())) break;
    for (std::uint64_t calls = 1 + draw.below(calls_max); calls > 0 && agree(draw.step()); --calls) {
      --steps;
      if (draw.below(20) == 0 && !agree(draw.setter())) break;
    }
  }
  return why;
}

}  // namespace hyrax::trace
