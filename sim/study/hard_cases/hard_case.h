// A run that is hard on the core, what must hold in it, and what is known not to.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/study/hard_cases/invariant.h"

namespace hyrax {

/// Something that the core really does wrong: an invariant that is known not to hold in a case.
struct Finding {
  Invariant invariant;
  std::string what;  ///< What happens, in one sentence without its full stop.
};

struct HardCase {
  std::string name;  ///< The scenario's, and of a family's member what sets it apart: "any-frame/dt-1e-09".
  std::string made_from;  ///< Name of the scenario that it is, or was made from.
  std::string why;        ///< Why it is hard.
  Scenario scenario;
  bool asks_rest = false;  ///< Left alone so long that it must have come to rest.
  bool is_long = false;    ///< Takes longer than all others together.
  std::vector<Finding> findings;
};

/// The cases that a scenario of this name stands for: itself, with what is known of it; of one of the names
/// in hard_families.cpp, its family as well.
[[nodiscard]] std::vector<HardCase> hard_cases_of(const Scenario& scenario);

enum class CaseVerdict { held, finding, broken, finding_gone };

/// How a case fared.
struct HardCaseResult {
  InvariantMeasures measures{};
  std::int64_t steps = 0;
  std::int64_t knife_edges = 0;
  std::string
      expectation_broken;  ///< The first of the scenario's own that does not hold, with what was measured.
};

/// Plays the case, watching every step, then once more, and once more stopped and resumed twice.
/// `tell` gets the number of steps watched, as the first of these goes on, which takes most of the time.
[[nodiscard]] HardCaseResult play_hard_case(const HardCase& hard_case,
                                            const std::function<void(std::int64_t)>& tell = {});

/// What was expected of an invariant against how it fared.
[[nodiscard]] CaseVerdict judge(const HardCase& hard_case, const HardCaseResult& result, Invariant invariant);

}  // namespace hyrax
