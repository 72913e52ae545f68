// A core as a table of functions, so that one program can hold two.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sim/replay/kernel.h"

namespace hyrax {

/// What sim/replay offers of class physics: its kernel, and the functions of core.h by their names there.
/// Each core is compiled into a library of its own that hides all its other symbols (core_library.cpp), so
/// that two headers that both define `class physics`, and whatever else they define, never meet.
struct CoreFunctions {
  int number = 0;  ///< Names the core where it is refused: 0 the base, 1 the candidate.
  const Kernel* kernel = nullptr;
  std::string_view (*model)() = nullptr;
  State (*step)(const State& body, double dt_s, const Bounds& bounds) = nullptr;
  State (*steps)(State body, double dt_s, const Bounds& bounds, std::int64_t steps) = nullptr;
  /// As steps; only these are not counted (PlayWatch::updates), which would take time.
  State (*timed_steps)(const State& body, double dt_s, const Bounds& bounds, std::int64_t steps) = nullptr;
  State (*played)(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                  int parts) = nullptr;
  State (*stopped)(const State& body) = nullptr;
  State (*flight)(const State& body, double dt_s) = nullptr;
  /// The paper's constants that the header does not have, as "GRAVITY, AIR_DRAG"; null: it has all.
  const char* (*lacking)() = nullptr;
  /// Why results of this core cannot be compared, in a sentence without its full stop; null: no such reason
  /// was found.
  const char* (*defect)() = nullptr;
};

/// The one symbol of a core's library. @param updates where it counts the updates that begin.
using CoreEntry = const CoreFunctions*(int number, volatile std::int64_t* updates);
inline constexpr char kCoreEntry[] = "hyrax_core_functions";

/// A core cannot be compared: why, a sentence without its full stop.
struct CoreRefused : std::runtime_error {
  CoreRefused(int number, const std::string& reason) : std::runtime_error(reason), core(number) {}
  int core;  ///< CoreFunctions::number.
};

}  // namespace hyrax
