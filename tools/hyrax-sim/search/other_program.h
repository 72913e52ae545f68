// Another build of hyrax-sim, which computes the state hash of scenarios.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "tools/files/child_process.h"

namespace hyrax {

class OtherProgram {
 public:
  /// Plays a scenario with it, to see that it is a hyrax-sim.
  /// @param option for the message, as "hyrax-sim fuzz: --against".
  /// ERRORS: Failure(cannot_access) if it cannot be started; Failure(bad_input) if it prints no state hash.
  OtherProgram(std::string program, const std::string& option);

  /// How many scenarios one process plays best: `check`, which writes no file, takes some 0.1 ms for each,
  /// `run` some 3 ms. Starting the process takes 5 ms.
  [[nodiscard]] std::size_t batch() const { return uses_check_ ? 256 : 16; }

  /// The state hash of each scenario; of one that it prints no hash for, how it ended instead, as
  /// "signal 11 (exit code 139)". One process plays all of them; only if a hash is missing is each played
  /// alone. REQUIRES: scenarios of different names.
  [[nodiscard]] std::vector<std::string> state_hashes(std::span<const Scenario> scenarios) const;

 private:
  enum class Query { run, check };
  [[nodiscard]] std::vector<std::string> query(Query command, std::span<const Scenario> scenarios,
                                               ChildEnd& end) const;

  std::string program_;
  bool uses_check_ = false;
};

}  // namespace hyrax
