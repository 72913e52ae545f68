// What the numbers of number.h record.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/trace/host/number.h"
#include "sim/trace/numbered.h"

namespace hyrax::trace {

/// So far, each once.
[[nodiscard]] const std::vector<Expression>& recorded_expressions();
[[nodiscard]] const std::vector<StepComparison>& recorded_comparisons();

/// Forgets all.
void start_recording();

[[nodiscard]] Index record_argument(NumberKind kind, const std::string& name);

/// Takes a path that begins with these outcomes; comparisons after them hold or not, as said.
void start_path(std::vector<StepOutcome> planned, bool others_hold);

/// What all numbers have in common, in the memory of a body.
struct Slot {
  double value;
  Index expression;
  std::uint32_t tag;

  [[nodiscard]] bool is_number() const { return tag >= kNumberTag && tag <= kTruthTag; }
  [[nodiscard]] NumberKind kind() const {
    return tag == kTruthTag ? NumberKind::whole : static_cast<NumberKind>(tag - kNumberTag);
  }
  [[nodiscard]] Index index() const {
    return expression == kConstant ? record_constant(kind(), value) : expression;
  }
};
static_assert(sizeof(Slot) == sizeof(Real));

/// All paths through what `run` does, which returns what it makes of every member.
/// @param count goes up by each; more than kStepPathsMax end in stop().
[[nodiscard]] std::vector<StepPath> paths_of(const std::function<std::vector<Index>()>& run,
                                             std::size_t& count);

/// What stop() calls first; it may throw. Where it returns, or is none, the process ends.
using StopHandler = void (*)(const char* why_incomplete);
void set_stop_handler(StopHandler handler);

inline constexpr char kTooManyPaths[] = "more than 4,096 paths";
inline constexpr char kMemoryOutside[] = "memory outside the body";
inline constexpr std::size_t kExpressionsMax = 100'000;

}  // namespace hyrax::trace
