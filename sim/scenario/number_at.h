// The numbers of a scenario, addressed by the JSON Pointers of its file.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "sim/scenario/scenario.h"

namespace hyrax {

/// What a key of the format `hyrax-scenario/1` holds: a real number, a whole number, or a seed, which may be
/// up to 2^64 - 1.
enum class NumberKind : std::uint8_t { real, integer, seed };

/// A number of a scenario: where it is stored, and the limits of its key.
struct NumberField {
  std::variant<double*, std::int32_t*, std::int64_t*, std::uint64_t*> at;
  double low = 0.0;
  double high = 0.0;
  bool excludes_low = false;
  /// Whether frame numbers or times of events may depend on it.
  bool is_timing = false;

  [[nodiscard]] bool allows(double value) const {
    return (excludes_low ? value > low : value >= low) && value <= high;
  }
};

/// Of the key that a pointer ends in.
[[nodiscard]] NumberKind number_kind(std::string_view pointer);

/// The number at a pointer, as `/start/x_px` or `/events/0/fling/vx_px_per_s`. It refers to the scenario.
/// Nothing if the scenario holds no number there, or in `expect`.
[[nodiscard]] std::optional<NumberField> number_at(Scenario& scenario, std::string_view pointer);

}  // namespace hyrax
