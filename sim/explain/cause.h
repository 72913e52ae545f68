// What makes the runs of two programs differ: one change of the step, or of what it is fed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sim/motion/statement.h"

namespace hyrax {

/// How an operation changed.
enum class CauseKind : std::uint8_t {
  constant,
  comparison,
  order,
  dropped,
  doubled,
  added,
  sign,
  swapped,
  fused,
  changed,
  unknown
};
inline constexpr std::array<std::string_view, 11> kCauseKindNames = {
    "constant", "comparison", "order", "dropped", "doubled", "added",
    "sign",     "swapped",    "fused", "changed", "unknown"};
[[nodiscard]] constexpr std::string_view name_of(CauseKind kind) {
  return kCauseKindNames[static_cast<std::size_t>(kind)];
}

/// What else than one operation can be the cause.
inline constexpr std::string_view kSeveralOperations = "several";
inline constexpr std::string_view kClockCause = "clock";
inline constexpr std::string_view kInputCause = "input";
inline constexpr std::string_view kScenarioCause = "scenario";
inline constexpr std::string_view kUnknownCause = "unknown";

struct Cause {
  std::string_view operation = kUnknownCause;  ///< One of kOperationNames or of the names above.
  CauseKind kind = CauseKind::unknown;
  std::string detail;          ///< As "GRAVITY 1200 -> 1250"; of kind unknown a sentence.
  std::optional<double> from;  ///< Of one constant.
  std::optional<double> to;
  bool operator==(const Cause&) const = default;
};

/// The name of the constant of an operation in the listing; empty: it has none.
[[nodiscard]] constexpr std::string_view constant_name_of(Operation operation) {
  switch (operation) {
    case Operation::gravity:
      return "GRAVITY";
    case Operation::drag:
      return "AIR_DRAG";
    case Operation::restitution:
      return "RESTITUTION";
    case Operation::friction:
      return "GROUND_FRICTION";
    case Operation::rest_rule:
      return "REST_THRESHOLD";
    case Operation::position:
    case Operation::wall_x:
    case Operation::wall_y:
      return "";
  }
  return "";
}

}  // namespace hyrax
