#include "sim/trace/host/compiled_core.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "sim/trace/step_draw.h"
#include "sim/trace/step_player.h"

namespace hyrax::trace {
namespace {

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
    if (call.function == CoreFunction::construct)
      traced_.emplace(program_, State{a, b, c, d});
    else
      call_function(call.function, *traced_, call.numbers.data(), call.sizes.data());
  }

  const CompiledCore& core_;
  const StepProgram& program_;
  std::vector<std::max_align_t> memory_;
  std::optional<TracedBody> traced_;
};

// Draws calls: steps as the search tries them, and what no scenario has.
class Draw {
 public:
  explicit Draw(const TracedStep& step) : draw_(step, step, 20261123) {
    // What the language does not define, no two compilers need do alike.
    for (const Expression& expression : step.expressions)
      converts_to_whole_ |= expression.op == Operator::to_whole;
  }

  Call start() {
    StepNumbers numbers = draw_.numbers(converts_to_whole_ || below(2) == 0);
    auto& [x, y, vx, vy, dt, window_width, window_height, sprite_width, sprite_height] = numbers;
    if (below(2) == 0) x -= vx * dt;  // The step ends at what was drawn.
    if (below(2) == 0) y -= vy * dt;
    if (!converts_to_whole_ && below(16) == 0) numbers[below(4)] = kEdges[below(kEdges.size())];
    if (converts_to_whole_)
      for (double* const number : {&x, &y, &vx, &vy}) *number = std::clamp(*number, -1e6, 1e6);
    step_ = {.function = CoreFunction::update, .numbers = {dt}, .sizes = {}};
    for (std::size_t size = 0; size < step_.sizes.size(); ++size)
      step_.sizes[size] = static_cast<int>(numbers[kStepNumbers - step_.sizes.size() + size]);
    return {.function = CoreFunction::construct, .numbers = {x, y, vx, vy}};
  }
  // After start().
  [[nodiscard]] const Call& step() const { return step_; }
  Call setter() {
    static constexpr std::array kSetters = {CoreFunction::set_position, CoreFunction::set_velocity,
                                            CoreFunction::reset_velocity};
    const StepNumbers numbers = draw_.numbers(true);
    return {.function = kSetters[below(kSetters.size())], .numbers = {numbers[2], numbers[3]}};
  }

  std::size_t below(std::size_t count) { return draw_.below(count); }

 private:
  static constexpr std::array kEdges = {
      std::numeric_limits<double>::denorm_min(), -1e150, std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};

  StepDraw draw_;
  bool converts_to_whole_ = false;
  Call step_;
};

}  // namespace

std::optional<std::string> step_that_differs(const CompiledCore& core, const TracedStep& step,
                                             std::int64_t steps) {
  const auto program = make_step_program(step);
  Draw draw(step);
  // A state of x, y, vx and vy is drawn; what further members hold comes from playing.
  const std::size_t calls_max = step.members.size() > 4 ? 60 : 2;
  std::optional<std::string> why;
  while (steps > 0 && !why) {
    Pair pair(core, *program);
    const auto agree = [&](const Call& call) {
      why = pair.call(call);
      return !why;
    };
    if (!agree(draw.start())) break;
    for (std::size_t calls = 1 + draw.below(calls_max); calls > 0 && agree(draw.step()); --calls) {
      --steps;
      if (draw.below(20) == 0 && !agree(draw.setter())) break;
    }
  }
  return why;
}

}  // namespace hyrax::trace
