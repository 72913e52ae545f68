// Another build of hyrax-sim, which computes the state hash of scenarios.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "tools/files/child_process.h"

namespace hyrax {

class OtherProgram {
 public:
  using SteadyClock = std::chrono::steady_clock;

  /// Plays a scenario with it, to see that it is a hyrax-sim.
  /// @param option for the message, as "hyrax-sim fuzz: --against".
  /// @param deadline see set_deadline.
  /// @param limit_s for each process.
  /// ERRORS: Failure(cannot_access) if it cannot be started; Failure(bad_input) if it prints no state hash.
  OtherProgram(std::string program, const std::string& option,
               std::optional<SteadyClock::time_point> deadline = std::nullopt, double limit_s = 60.0);

  /// From then on no process is started, and one that runs is ended.
  void set_deadline(SteadyClock::time_point deadline) { deadline_ = deadline; }
  [[nodiscard]] bool is_over() const { return deadline_ && SteadyClock::now() >= *deadline_; }

  /// How many scenarios one process plays best: `check`, which writes no file, takes some 0.1 ms for each,
  /// `run` some 3 ms. Starting the process takes 5 ms.
  [[nodiscard]] std::size_t batch() const { return uses_check_ ? 256 : 16; }

  /// The state hash of each scenario; of one that it prints no hash for, how it ended instead, as
  /// "signal 11 (exit code 139)"; empty if the deadline came before. One process plays all of them; only if a
  /// hash is missing is each played alone. REQUIRES: scenarios of different names.
  [[nodiscard]] std::vector<std::string> state_hashes(std::span<const Scenario> scenarios) const;

 private:
  enum class Query { run, check };
  [[nodiscard]] std::vector<std::string> query(Query command, std::span<const Scenario> scenarios,
                                               ChildEnd& end) const;

  [[nodiscard]] double left_s() const;

  std::string program_;
  double limit_s_;
  std::optional<SteadyClock::time_point> deadline_;
  bool uses_check_ = false;
};

}  // namespace hyrax
