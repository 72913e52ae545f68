#include "sim/explain/candidate.h"

#include <cassert>
#include <utility>

namespace hyrax {
namespace {

TieRank rank_of(CauseKind kind) {
  switch (kind) {
    case CauseKind::dropped:
      return TieRank::dropped;
    case CauseKind::doubled:
      return TieRank::doubled;
    case CauseKind::added:
      return TieRank::added;
    case CauseKind::sign:
      return TieRank::sign;
    case CauseKind::comparison:
      return TieRank::comparison;
    case CauseKind::order:
      return TieRank::order;
    case CauseKind::swapped:
      return TieRank::swapped;
    case CauseKind::fused:
      return TieRank::fused;
    case CauseKind::constant:
    case CauseKind::changed:
    case CauseKind::unknown:
      break;
  }
  assert(kind == CauseKind::constant);
  return TieRank::other_constant;
}

}  // namespace

Candidate::Candidate(std::string_view operation, CauseKind kind, std::string detail,
                     StepStatements changed_step)
    : cause{operation, kind, std::move(detail), {}, {}}, rank(rank_of(kind)), step(std::move(changed_step)) {}

Candidate::Candidate(Cause cause_of, TieRank its_rank, StepStatements changed_step)
    : cause(std::move(cause_of)), rank(its_rank), step(std::move(changed_step)) {}

}  // namespace hyrax
