// Steps to try: real display sizes and rates, the constants of the steps, and everything that is allowed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "sim/trace/step_player.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// The numbers that a step starts from.
enum class StepNumber : std::uint8_t {
  x,
  y,
  vx,
  vy,
  dt,
  window_width,
  window_height,
  sprite_width,
  sprite_height
};
inline constexpr std::size_t kStepNumbers = 9;
/// By StepNumber; sizes as whole doubles.
using StepNumbers = std::array<double, kStepNumbers>;

constexpr bool is_size(StepNumber number) { return number >= StepNumber::window_width; }

/// A bit for each StepNumber, and one for every further member and argument of another function.
using StepNumberBits = std::uint16_t;
template <class... Number>
constexpr StepNumberBits bits_of(Number... numbers) {
  return static_cast<StepNumberBits>((0u | ... | (1u << static_cast<unsigned>(numbers))));
}
inline constexpr StepNumberBits kSizeBits = bits_of(StepNumber::window_width, StepNumber::window_height,
                                                    StepNumber::sprite_width, StepNumber::sprite_height);

/// By expression: which numbers it depends on.
[[nodiscard]] std::vector<StepNumberBits> dependencies_of(const TracedStep& step);

[[nodiscard]] StepInput input_of(const StepNumbers& numbers);
/// The nearest value that a scenario may have.
[[nodiscard]] double limited(StepNumber number, double value);

/// Draws them. The same numbers on every machine: nothing but exact operations is used.
class StepDraw {
 public:
  /// Refers to nothing: takes the constants of both steps.
  StepDraw(const TracedStep& a, const TracedStep& b, std::uint64_t seed);

  /// Real sizes and rates, or any.
  [[nodiscard]] StepNumbers numbers(bool is_real);

  [[nodiscard]] std::size_t below(std::size_t count) { return random_() % count; }
  [[nodiscard]] double uniform(double low, double high);
  /// Of either sign, of a size between 2^low and 2^high.
  [[nodiscard]] double of_any_size(int low, int high);

 private:
  void draw_sizes(StepNumbers& numbers, bool is_real);
  [[nodiscard]] double any_side();
  [[nodiscard]] double drawn_dt_s(bool is_real);
  [[nodiscard]] double position(double bound_px);
  [[nodiscard]] double speed();

  std::mt19937_64 random_;
  std::vector<double> constants_;
};

}  // namespace hyrax
