// Plays a traced step by interpreting it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "sim/motion/state.h"
#include "sim/trace/traced_step.h"

namespace hyrax {

/// A traced step, made ready to be played: decisions as a tree, operations in the order in which they are
/// needed (step_program.h).
class StepProgram;

/// Null if not playable: something unknown is called, or an outcome of its comparisons leads to no path, or
/// to two. REQUIRES: a step as canonical() or read_step() return it.
[[nodiscard]] std::shared_ptr<const StepProgram> make_step_program(const TracedStep& step);

/// One step: the state after the inputs of its frame, sizes and dt.
struct StepInput {
  World world;
  double dt_s = 0.0;
};

/// A body moved by a traced step; has the interface of class physics, so that StepperOf plays it
/// (sim/core/stepper_of.h). Trivially copyable. REQUIRES: the program outlives it.
class TracedBody {
 public:
  TracedBody(const StepProgram& program, const State& start);

  void update(double dt_s, int window_width_px, int window_height_px, int sprite_width_px,
              int sprite_height_px);
  void update(const StepInput& input);  ///< As its frame does; its state is not taken.
  void setPos(double x_px, double y_px);
  void setVelocity(double vx_px_per_s, double vy_px_per_s);
  void resetVelocity();

  [[nodiscard]] double x() const { return members_[0]; }
  [[nodiscard]] double y() const { return members_[1]; }
  [[nodiscard]] double vx() const { return members_[2]; }
  [[nodiscard]] double vy() const { return members_[3]; }
  /// All members of the step, the further ones too.
  [[nodiscard]] std::span<double> members();
  [[nodiscard]] std::span<double> further_members() { return members().subspan(4); }
  /// Sets those that a row shows; further ones stay as they are.
  void set_row(const State& row);

  /// Index in paths_of(CoreFunction::update) of the last update; kNoIndex: none yet.
  [[nodiscard]] StepIndex path() const { return path_; }
  /// A row's contact byte of the last update, by the step's own comparisons with the walls.
  [[nodiscard]] std::uint8_t contact() const { return contact_; }
  /// What an update from here does at a wall that it meets.
  [[nodiscard]] WallMeeting meeting(Wall wall, double dt_s, const Size& window, const Size& sprite) const;

 private:
  const StepProgram* program_;
  std::array<double, kStepMembersMax> members_{};  // Those of other kinds as the double of their value.
  StepIndex path_ = kNoIndex;
  std::uint8_t contact_ = 0;
};

}  // namespace hyrax
