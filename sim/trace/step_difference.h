// What only one of two traced steps does, and the search for a state that shows it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/trace/expression_text.h"
#include "sim/trace/step_player.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// A condition or expression that only one of two complete steps has while both have its operands.
struct StepDifference {
  bool is_in_accepted = false;  ///< Else in the current step.
  std::string text;  ///< As "vx * AIR_DRAG > 9000", "dt * 1250"; long ones shortened in the middle.
  std::vector<bool> is_on_path;     ///< By path of update of the step that has it: whether it evaluates it.
  StepIndex comparison = kNoIndex;  ///< In that step; kNoIndex: an expression.
};

/// What was found by trying steps.
struct DifferenceSearch {
  /// From here both steps differ in a bit while the difference is evaluated, or further members have not been
  /// alike since it was.
  std::optional<StepInput> found;
  /// After so many frames of found->dt_s; more than 1 only where there are further members.
  std::int64_t frames = 1;
  std::int64_t steps_tried = 0;
};

/// Whether the further members of both are alike; which NaN arose is no difference.
[[nodiscard]] bool are_further_alike(TracedBody& a, TracedBody& b);

/// Two complete steps, made ready to be compared.
class StepPair {
 public:
  /// Of steps that are not playable (step_player.h) nothing is noticed or found.
  /// @param names of numbers, in the texts of differences.
  /// REQUIRES: steps as canonical() or read_step() return them.
  StepPair(const TracedStep& accepted, const TracedStep& current, const NumberNames& names = {});

  /// In the order of the steps' text: those of the accepted step first. Empty: proved equal in update
  /// (setters are compared by are_setters_equal).
  [[nodiscard]] const std::vector<StepDifference>& differences() const { return differences_; }
  [[nodiscard]] bool are_setters_equal() const { return are_setters_equal_; }

  /// What plays the accepted step and the current one; null: not playable.
  [[nodiscard]] const std::vector<std::shared_ptr<const StepProgram>>& programs() const { return programs_; }

  /// Takes both steps once; `bodies` are theirs, of one row. Marks in `evaluated` (one a difference) those
  /// that are evaluated, and if both rows differ in a bit then also in `noticed` all that were since further
  /// members were last alike. Returns whether the rows differ.
  bool notice(const StepInput& input, std::span<TracedBody> bodies, std::vector<bool>& evaluated,
              std::vector<bool>& noticed) const;

  /// Looks for a step that shows the difference: states within the limits of scenarios (start 1e12, windows
  /// 1,000,000 px, dt 0 .. 1e9 s), real display sizes and rates first, then both sides of the conditions
  /// driven together. Deterministic: the same on every machine.
  [[nodiscard]] DifferenceSearch search(std::size_t difference, std::uint64_t seed,
                                        std::int64_t steps_max) const;

 private:
  std::vector<std::shared_ptr<const StepProgram>> programs_;
  std::vector<StepDifference> differences_;
  bool are_setters_equal_;
};

}  // namespace hyrax
