#include <fmt/format.h>

#include "sim/explain/candidate.h"
#include "sim/motion/listing.h"

namespace hyrax {
namespace {

constexpr std::array<Operation, 5> kWithConstant = {
    Operation::gravity, Operation::restitution, Operation::drag, Operation::friction, Operation::rest_rule};

}  // namespace

std::vector<Candidate> constant_candidates(const Constants& golden, const Constants& program) {
  std::vector<Candidate> candidates;
  std::string all;
  for (const Operation operation : kWithConstant) {
    double Constants::*const constant = constant_of(operation);
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): none of these lacks one.
    const double from = golden.*constant;
    const double to = program.*constant;
    if (same_bits(from, to)) continue;
    Constants changed = golden;
    changed.*constant = to;
    const std::string detail = fmt::format("{} {} -> {}", constant_name_of(operation), from, to);
    all += (all.empty() ? "" : ", ") + detail;
    candidates.emplace_back(Cause{name_of(operation), CauseKind::constant, detail, from, to},
                            TieRank::constant_of_program, listing(changed));
  }
  if (candidates.size() > 1)
    candidates.emplace_back(Cause{kSeveralOperations, CauseKind::constant, all, {}, {}},
                            TieRank::all_constants_of_program, listing(program));
  return candidates;
}

}  // namespace hyrax
