// Contacts of a core whose step is not the paper's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "sim/core/traced_stepper.h"
#include "sim/motion/state.h"
#include "sim/trace/step_program.h"

namespace hyrax {

/// Which walls a step met, as its two rows show it: for a core that has no listing to tell. A row's contact
/// byte: the rest bit is set where the ground was met and vy is 0.
///
/// A step met a wall if its position is on or past the wall's bound, or if its velocity turned from towards
/// the wall to away from it within reach: the bound is no farther from the position before the step than the
/// faster of both velocities goes in dt. The reach tells a bounce from the apex of a flight. At most one wall
/// of each direction; left before right and top before ground, as in the listing.
/// @param before the state after the inputs of the frame.
[[nodiscard]] std::uint8_t contact_of_rows(const Bounds& bounds, const State& before, double dt_s,
                                           const State& after);

/// Plays the rows of another stepper, and tells their contacts. With the core's traced step, that is played
/// once beside each step, from the same state: the walls are those beyond which its comparisons found the
/// position (sim/trace/step_program.h). Of a wall with which it compares none, and without a step, the rows
/// tell: a step whose row is what the paper's step with the core's constants makes of the row before has that
/// one's contacts; of any other see contact_of_rows, and `before` is the velocity before the step,
/// `overshoot` NaN.
class ContactStepper final : public TracedStepper {
 public:
  /// @param step null: contacts follow from the rows, with these constants.
  ContactStepper(std::shared_ptr<const Stepper> rows, const std::shared_ptr<const StepProgram>& step,
                 const std::optional<Constants>& constants)
      : TracedStepper(std::move(rows), {step && step->walls() != 0 ? step : nullptr}),
        walls_(step ? step->walls() : 0),
        constants_(constants) {}

 private:
  void tell(const Stretch& stretch, const State& from, std::span<TracedBody> bodies, std::size_t first_row,
            RowBlock& rows, StretchLog& log) const override;

  std::uint8_t walls_;  // That the step tells.
  std::optional<Constants> constants_;
};

}  // namespace hyrax
