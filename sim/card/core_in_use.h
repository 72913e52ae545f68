// Which core the functions of sim/replay/core.h and its kernel stand for in this program.
#pragma once

#include <string>

#include "sim/card/core_functions.h"
#include "sim/card/play_watch.h"

namespace hyrax {

/// While it lives, `core_kernel`, `core_model`, `core_constants` and the functions of sim/replay/core.h are
/// those of this core: so replays, invariants and studies measure any core without knowing it. A program that
/// links hyrax_card has no other core. Refers to the functions. Not for several threads.
///
/// Where its header lacks one of the constants, core_constants are the paper's, from which random runs and
/// hard cases can be made; no run by it may be judged by them.
///
/// Each call of them ERRORS: CoreRefused, if the core throws or changes how the processor computes.
class CoreInUse {
 public:
  /// @param place what it plays, for PlayWatch::place.
  CoreInUse(const CoreFunctions& core, std::string place);
  ~CoreInUse();
  CoreInUse(const CoreInUse&) = delete;
  CoreInUse& operator=(const CoreInUse&) = delete;

  [[nodiscard]] const CoreFunctions& core() const { return core_; }

 private:
  void show() const;

  const CoreFunctions& core_;
  std::string place_;
  const CoreInUse* before_;
};

/// From now on, what the core in use does is written there.
void watch_plays_in(PlayWatch& watch);

/// ERRORS: CoreRefused if rounding mode, subnormals or trapped exceptions are not as they were when the
/// program began. @param core number of the core that was called last.
void require_usual_arithmetic(int core, const std::string& where);

}  // namespace hyrax
