// A traced step made ready to be played.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/motion/state.h"
#include "sim/trace/decision_tree.h"
#include "sim/trace/step_player.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// Arguments of a function, as in kArgumentNames.
using StepArguments = std::array<double, kStepArgumentsMax>;

/// Those of update.
[[nodiscard]] inline StepArguments update_arguments(double dt_s, const Size& window, const Size& sprite) {
  return {dt_s, static_cast<double>(window.width_px), static_cast<double>(window.height_px),
          static_cast<double>(sprite.width_px), static_cast<double>(sprite.height_px)};
}

/// What an operation does to values of its kind. Values of every kind are doubles: a `float` and an `int` are
/// exact in one. As the program that a build makes of the header, with what C++ leaves undefined defined: an
/// int wraps around, its quotient by 0 is 0, and what fits no int becomes the least, as on x86. Null: a
/// function that is not known.
using OperationFunction = double (*)(double, double, double);
[[nodiscard]] OperationFunction operation_of(const Expression& expression);

[[nodiscard]] inline bool holds(Relation relation, double left, double right) {
  return relation == Relation::less            ? left < right
         : relation == Relation::less_or_equal ? left <= right
                                               : left == right;
}

/// One operation on the values of expressions.
struct StepInstruction {
  OperationFunction function = nullptr;  ///< Null: one of the four that are done in place, by `op`.
  Operator op = Operator::add;
  StepIndex result = 0;
  std::array<StepIndex, 3> operands = {};  ///< 0 where it has none.
};

/// The expressions of a velocity; kNoIndex: it cannot be told.
struct VelocityIndices {
  StepIndex vx = kNoIndex;
  StepIndex vy = kNoIndex;
};

/// A comparison of a position with a wall's bound that decided "beyond".
struct PathContact {
  Wall wall = Wall::left;
  StepIndex position = kNoIndex;  ///< Expressions.
  StepIndex bound = kNoIndex;
  /// How much both differ for each pixel; NaN: not known, of a wall that two positions of the path are
  /// beyond.
  double scale = 1.0;
  VelocityIndices before = {};  ///< At the comparison.
  VelocityIndices after = {};   ///< At the next wall of the path, or at its end.
};

/// For each path of update its contacts, in the order in which it has them: each wall at most once. A bound
/// is the constant 0, or an expression of the sizes. A position is x or y and what is added to it, perhaps
/// times a constant; the comparison is solved for it.
[[nodiscard]] std::vector<std::vector<PathContact>> find_path_contacts(const TracedStep& step);

class StepProgram {
 public:
  /// Calls a function: `members` become what its path makes of them. Returns the index of that path.
  StepIndex run(CoreFunction function, std::span<double> members, const StepArguments& arguments) const;

  /// Calculates every expression that update may need, by index; the others are 0 or of no meaning.
  void evaluate(std::span<const double> members, const StepArguments& arguments,
                std::vector<double>& values) const;

  [[nodiscard]] const TracedStep& step() const { return step_; }
  /// Those that any path meets, as a contact byte: of others no comparison tells.
  [[nodiscard]] std::uint8_t walls() const { return walls_; }
  /// The walls that a path of update meets, in the order in which it does.
  [[nodiscard]] const std::vector<PathContact>& contacts(StepIndex path) const { return contacts_[path]; }

 private:
  // Of an argument or a member: where its value comes from.
  struct Load {
    StepIndex result = 0;
    StepIndex source = 0;  // Below kStepMembersMax a member, else an argument.
  };
  struct Node {
    std::size_t begin = 0;  // Instructions done before it asks or ends.
    std::size_t end = 0;
    DecisionNode decision;
    StepComparison comparison;
  };
  struct Function {
    std::vector<Load> loads;
    std::vector<Node> nodes;
    std::vector<StepInstruction> instructions;
  };

  friend std::shared_ptr<const StepProgram> make_step_program(const TracedStep& step);
  explicit StepProgram(const TracedStep& step) : step_(step) {}
  bool add_function(CoreFunction function);
  // The operations that these expressions need and that are not done yet, operands first.
  [[nodiscard]] bool emit(std::vector<StepIndex> open, std::vector<bool>& is_known,
                          std::vector<StepIndex>& added, Function& program) const;
  void load(const Function& program, std::span<const double> members, const StepArguments& arguments,
            double* values) const;

  TracedStep step_;
  std::vector<double> leaves_;  // By index; 0 for arguments.
  std::array<Function, kCoreFunctions> functions_;
  std::vector<StepInstruction> all_;  // Of update, by index.
  std::vector<std::vector<PathContact>> contacts_;
  std::uint8_t walls_ = 0;
};

}  // namespace hyrax
