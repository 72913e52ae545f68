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

/// A bit a member of a step, in their order.
using MemberBits = std::uint64_t;
static_assert(kStepMembersMax + kStepContactsMax <= 64);

/// A condition or expression that only one of two complete steps has while both have its operands.
struct StepDifference {
  bool is_in_accepted = false;  ///< Else in the current step.
  std::string text;  ///< As "vx * AIR_DRAG > 9000", "dt * 1250"; long ones shortened in the middle.
  std::vector<bool> is_on_path;     ///< By path of update of the step that has it: whether it evaluates it.
  StepIndex comparison = kNoIndex;  ///< In that step; kNoIndex: an expression.
  std::vector<MemberBits> members = {};  ///< By such a path: those whose end it is a part of.
  /// That step with the outcomes of one comparison exchanged, for each that it is a part of.
  std::vector<std::shared_ptr<const StepProgram>> exchanged = {};
};

/// What a function of two cores that describe themselves does otherwise.
struct ValueDifference {
  std::string function;             ///< As "step", "strike(vx_px_per_s)".
  std::vector<std::string> values;  ///< Values and contacts that it makes otherwise; none: those that a
                                    ///< condition decides.
  std::vector<std::string> before;  ///< Expressions or conditions that only the accepted step has.
  std::vector<std::string> after;   ///< Those of the current one.
};

/// Both bodies of a step, of the step that has a difference and of the other one.
struct BodyPair {
  TracedBody own;
  TracedBody other;
};

/// Whether a difference decides anything, step after step. Beside others it does where a member ends
/// otherwise by the two steps, and
/// - the difference is a part of that end, or
/// - with the other outcome of a comparison that it is a part of, the member would be nearer to what the
///   other step makes of it, or
/// - so it would be with the other step's further members, where the difference decided those.
class DifferenceWatch {
 public:
  /// Returns whether it decides a member that a row shows. @param after one step of both.
  bool take(const StepDifference& difference, const StepInput& input, BodyPair before, BodyPair after);
  /// Further members that it decided and that have not been alike since.
  [[nodiscard]] MemberBits further_members() const { return further_; }

 private:
  MemberBits further_ = 0;
};

/// What was found by trying steps.
struct DifferenceSearch {
  std::optional<StepInput> found;  ///< From here the difference decides a row.
  /// After so many frames of found->dt_s; more than 1 only where there are further members.
  std::int64_t frames = 1;
  std::int64_t steps_tried = 0;
  MemberBits further_members = 0;  ///< That the difference decided in some of these steps.
};

/// Members that no row depends on, in this step or a later one.
[[nodiscard]] MemberBits unrecorded_members(const TracedStep& step);

/// Function by function. REQUIRES: canonical steps of cores with the same names of values and functions.
/// @param names as those of StepPair.
[[nodiscard]] std::vector<ValueDifference> value_differences(const TracedStep& accepted,
                                                             const TracedStep& current,
                                                             const NumberNames& names);

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

  /// Members that no row of either step depends on.
  [[nodiscard]] MemberBits unrecorded() const { return unrecorded_; }

  /// Takes both steps once; `bodies` are theirs, of one row. Marks in `noticed` the differences that decide
  /// the row; of those that are marked already nothing is asked. REQUIRES: a watch a difference.
  void notice(const StepInput& input, std::span<TracedBody> bodies, std::vector<DifferenceWatch>& watches,
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
  MemberBits unrecorded_;
};

}  // namespace hyrax
