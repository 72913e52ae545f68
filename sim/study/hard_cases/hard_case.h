// A run that is hard on the core, what must hold in it, and which failures are expected.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/scenario/scenario.h"
#include "sim/search/run_check.h"

namespace hyrax {

struct HardCase {
  std::string name;       ///< The scenario's, or of a member of a family: "any-frame/dt-1e-09".
  std::string made_from;  ///< Name of the scenario that it is, or was made from.
  std::string why;        ///< Why it is hard.
  Scenario scenario;
  bool must_come_to_rest = false;  ///< Left alone so long that it must end at zero speed.
  /// How the listing itself fails to, in one sentence without its full stop: an expected failure. Empty: it
  /// does not.
  std::string never_at_rest = {};
  bool is_long = false;  ///< Takes longer than all others together.
};

/// The cases made from a scenario: itself with its expected failures, and the families of what it does
/// (hard_families.cpp), whatever its name.
[[nodiscard]] std::vector<HardCase> hard_cases_of(const Core& core, const Scenario& scenario);

enum class CaseVerdict { held, expected_failure, broken, expected_failure_gone };

/// What was measured of a case; `measures` with the invariants that are a case's own.
struct HardCaseResult : CheckedRun {
  /// The first of the scenario's own expectations that does not hold.
  std::string broken_expectation = {};
};

/// check_run at the usual stops, and the case's own invariants. @param report_steps see check_run.
[[nodiscard]] HardCaseResult play_hard_case(const Core& core, const HardCase& hard_case,
                                            const std::function<void(std::int64_t)>& report_steps = {});

/// Compares what was measured of an invariant with what is expected.
[[nodiscard]] CaseVerdict judge(const HardCase& hard_case, const HardCaseResult& result, Invariant invariant);

struct PlayedCase {
  HardCase hard_case;
  HardCaseResult result;
};

/// One invariant that was checked in one case.
struct Judgement {
  const PlayedCase* played = nullptr;
  Invariant invariant = Invariant::finite;
  CaseVerdict verdict = CaseVerdict::held;

  [[nodiscard]] const InvariantText& text() const {
    return kInvariantTexts[static_cast<std::size_t>(invariant)];
  }
  [[nodiscard]] const InvariantMeasure& measure() const {
    return played->result.measures[static_cast<std::size_t>(invariant)];
  }
};

/// Every invariant that was checked, case by case. They refer to the cases.
[[nodiscard]] std::vector<Judgement> judgements_of(std::span<const PlayedCase> cases);

/// One invariant over many cases.
struct InvariantCount {
  std::int64_t cases = 0;
  std::int64_t held = 0;
  std::int64_t expected_failures = 0;
  std::int64_t broken = 0;  ///< With the expected failures that did not occur.
  double slack = std::numeric_limits<double>::quiet_NaN();  ///< The smallest of the cases in which it held.
  std::string least_slack_case;                             ///< The first one with that slack.
};

/// @param made_from name of a scenario: counts only the cases made from it; empty: all.
[[nodiscard]] InvariantCount count(const std::vector<Judgement>& judgements, Invariant invariant,
                                   const std::string& made_from = "");

}  // namespace hyrax
