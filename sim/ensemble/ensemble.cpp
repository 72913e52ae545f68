#include "sim/ensemble/ensemble.h"

namespace hyrax {

StepTally play_members(const Sweep& sweep, const SweepPart& part, std::int64_t first_row,
                       std::span<MemberResult> results) {
  SweepMembers members(sweep);
  StepTally tally;
  std::int64_t row = first_row;
  for (MemberResult& result : results)
    tally += play_member(members.scenario(part.member(row++)), sweep.keep, result);
  return tally;
}

}  // namespace hyrax
