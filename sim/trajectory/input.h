// The inputs of a run, as they were applied.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/scenario/scenario.h"

namespace hyrax {

enum class InputKind : std::uint8_t {
  fling = 0,
  place = 1,
  stop = 2,
  resize_window = 3,
  resize_sprite = 4,
  hitch = 5,
  grab = 6,
  release = 7,
};

inline constexpr std::array<std::string_view, 8> kInputKindNames = {
    "fling", "place", "stop", "resize-window", "resize-sprite", "hitch", "grab", "release"};

/// One input: velocities, a position, a size or a dt stand in `a` and `b`, 0 where there is none.
struct Input {
  std::int64_t frame = 0;
  InputKind kind = InputKind::fling;
  double a = 0.0;
  double b = 0.0;
  bool operator==(const Input&) const = default;
};

/// The inputs of an event; a resize of window and sprite is two.
[[nodiscard]] std::vector<Input> inputs_of(const Action& action, std::int64_t frame);

/// All inputs of a scenario whose events fall on `frames`, up to frame `frame_end` (exclusive).
[[nodiscard]] std::vector<Input> inputs_of(const Scenario& scenario, const std::vector<std::int64_t>& frames,
                                           std::int64_t frame_end);

}  // namespace hyrax
