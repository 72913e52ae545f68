// A run that is hard on the core, what must hold in it, and which failures are expected.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/table.h"
#include "sim/scenario/scenario.h"
#include "sim/search/run_check.h"

namespace hyrax {

struct HardCase {
  std::string name = {};       ///< The scenario's, or of a member of a family: "any-frame/dt-1e-09".
  std::string made_from = {};  ///< Name of the scenario that it is, or was made from.
  std::string why = {};        ///< Why it is hard.
  Scenario scenario = {};
  bool must_come_to_rest = false;  ///< Left alone so long that it must end at zero speed.
  /// How the listing itself fails to, in one sentence without its full stop: an expected failure. Empty: it
  /// does not.
  std::string never_at_rest = {};
  /// Since when, at the latest, it must be at rest to the end; none: it need not.
  std::optional<double> rests_from_s = {};
  /// How the listing itself throws it from there, as above.
  std::string thrown_at_rest = {};
  /// Played by lossless().
  bool is_lossless = false;
  /// As a contact byte, the two walls that the exact fling from its start meets at one time; 0: it need not.
  std::uint8_t exact_corner = 0;
  bool is_long = false;  ///< Takes longer than all others together.
  /// Rows at which it is stopped and resumed, in order; empty: usual_stops.
  std::vector<std::int64_t> stops = {};
};

/// The listing with the core's gravity, without drag, friction, rest rule and loss at walls.
[[nodiscard]] Core lossless(const Core& core);

/// 100 random flings (ManyFlings) at 60 Hz, by the core and without losses, beside others that start apart by
/// an ulp of each value, or by more: in how many their contacts part, and when.
[[nodiscard]] Table parting_table(const Core& core);

/// The cases made from a scenario: itself with its expected failures, and the families of what it does
/// (hard_families.cpp), whatever its name. Of a core without constants those that need none.
[[nodiscard]] std::vector<HardCase> hard_cases_of(const Core& core, const Scenario& scenario);

/// A case with what was measured of it; `measures` with the invariants that are a case's own.
struct PlayedCase : CheckedRun {
  HardCase hard_case = {};
  /// The first of the scenario's own expectations that does not hold.
  std::string broken_expectation = {};
};

/// check_run, and the case's own invariants. @param report_steps see check_run.
[[nodiscard]] PlayedCase play_hard_case(const Core& core, HardCase hard_case,
                                        const std::function<void(std::int64_t)>& report_steps = {});

enum class CaseVerdict { held, expected_failure, broken, expected_failure_gone };

/// Compares what was measured of an invariant with what is expected.
[[nodiscard]] CaseVerdict judge(const PlayedCase& played, Invariant invariant);

}  // namespace hyrax
