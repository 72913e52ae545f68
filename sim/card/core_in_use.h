// Which core the functions of sim/replay/core.h and its kernel stand for in this program.
#pragma once

#include "sim/card/core_functions.h"

namespace hyrax {

/// While it lives, `core_kernel`, `core_model`, `core_constants` and the functions of sim/replay/core.h are
/// those of this core: so replays, invariants and studies measure any core without knowing it. A program that
/// links hyrax_card has no other core. Refers to the functions. Not for several threads.
class CoreInUse {
 public:
  explicit CoreInUse(const CoreFunctions& core);
  ~CoreInUse();
  CoreInUse(const CoreInUse&) = delete;
  CoreInUse& operator=(const CoreInUse&) = delete;

 private:
  const CoreFunctions* before_;
};

}  // namespace hyrax
