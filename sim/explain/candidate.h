// The candidates: steps that differ from the listing by one change.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/explain/cause.h"
#include "sim/motion/state.h"
#include "sim/motion/statement.h"

namespace hyrax {

/// Of candidates that reproduce equally many runs the one of the lowest rank is taken. Inputs and the clock
/// come after all: they are told apart from the step before candidates are tried (see diagnose).
enum class TieRank : std::uint8_t {
  constant_of_program,
  all_constants_of_program,
  dropped,
  doubled,
  added,
  sign,
  comparison,
  order,
  swapped,
  fused,
  other_constant
};

struct Candidate {
  /// A candidate without the values of a constant; its rank is that of the kind.
  Candidate(std::string_view operation, CauseKind kind, std::string detail, StepStatements changed_step);
  /// A constant, or all of them.
  Candidate(Cause cause_of, TieRank its_rank, StepStatements changed_step);

  Cause cause;
  TieRank rank;
  StepStatements step;
  /// Where frames have one dt, if not `step`: a compiler takes what does not change out of its loop.
  std::optional<StepStatements> even_step;

  [[nodiscard]] const StepStatements& step_for(bool is_dt_fixed) const {
    return is_dt_fixed && even_step ? *even_step : step;
  }
};

/// The listing with the constants of `program` where they differ from those of `golden`: each alone, then
/// all.
[[nodiscard]] std::vector<Candidate> constant_candidates(const Constants& golden, const Constants& program);

/// The listing with statements dropped, doubled, added, their sign, comparison or components changed, fused.
[[nodiscard]] std::vector<Candidate> statement_candidates(const Constants& golden);

/// The listing in other orders: operations, then single statements, then the statements of a wall.
[[nodiscard]] std::vector<Candidate> order_candidates(const Constants& golden);

}  // namespace hyrax
