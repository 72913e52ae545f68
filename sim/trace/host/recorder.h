// What the numbers of number.h record.
#pragma once

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
/// Outcomes of the path so far.
[[nodiscard]] const std::vector<StepOutcome>& path_outcomes();

/// What stop() calls first; it may throw. Where it returns, or is none, the process ends.
using StopHandler = void (*)(const char* why_incomplete);
void set_stop_handler(StopHandler handler);

inline constexpr char kTooManyPaths[] = "more than 4,096 paths";
inline constexpr char kMemoryOutside[] = "memory outside the body";
inline constexpr std::size_t kExpressionsMax = 100'000;

}  // namespace hyrax::trace
