// An input as the group /events of a file has it: a code of its kind, and two numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "sim/scenario/schedule.h"

namespace hyrax {

/// Names of the kinds, by code.
[[nodiscard]] std::span<const std::string_view> input_kind_names();

/// `a` and `b`: a velocity, a position, a size, or a dt; 0 where the kind has no number.
struct InputRecord {
  std::int64_t frame = 0;
  std::uint8_t kind = 0;
  double a = 0.0;
  double b = 0.0;
};

/// REQUIRES: a resize is of the window or of the sprite.
[[nodiscard]] InputRecord record_of(const Input& input);
/// Nothing where no input has this record.
[[nodiscard]] std::optional<Input> input_of(const InputRecord& record);

}  // namespace hyrax
