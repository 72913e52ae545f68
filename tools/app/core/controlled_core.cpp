#include "tools/app/core/controlled_core.h"

#include <fmt/format.h>

#include "tools/app/core/control_bits.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

// @param where of a call that changed the bits: as " in the step that makes row 3".
template <class Call, class Where>
auto look_at(const Call& call, const Where& where) {
  const ControlBits bits;
  auto result = call();
  if (bits.restore()) throw Failure(ExitCode::not_strict_ieee, control_bits_message(where()));
  return result;
}
std::string anywhere() { return ""; }

class ControlledStepper final : public StepperOver {
 public:
  using StepperOver::StepperOver;

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    const CoreBody before = body;
    const RestAnchor rest_before = rest;
    const auto played = [&] { return StepperOver::play(stretch, body, rest, rows, log), 0; };
    look_at(played, [&] {
      return fmt::format(" in the step that makes row {}", row_of(stretch, before, rest_before));
    });
  }
  void apply(const Action& action, Keyframe& now) const override {
    look_at([&] { return StepperOver::apply(action, now), 0; },
            [&] { return fmt::format(" in an event before row {}", now.row.step + 1); });
  }
  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds,
                            std::int64_t steps) const override {
    return look_at([&] { return StepperOver::steps(body, dt_s, bounds, steps); }, anywhere);
  }
  [[nodiscard]] State played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                             int parts) const override {
    return look_at([&] { return StepperOver::played(body, frames_s, bounds, parts); }, anywhere);
  }

 private:
  // The row that the first step makes which changes the bits; the last one where none does again.
  [[nodiscard]] std::int64_t row_of(const Stretch& stretch, CoreBody body, RestAnchor rest) const {
    Stretch frame = stretch;
    frame.frames = 1;
    frame.anchor = nullptr;
    RowBlock rows;
    StretchLog log;
    const ControlBits bits;
    for (; frame.from_step < stretch.from_step + stretch.frames; ++frame.from_step) {
      rows.shrink(0);
      StepperOver::play(frame, body, rest, rows, log);
      if (bits.restore()) return frame.from_step + 1;
      frame.contact_before = rows.row(0).contact;
      if (!frame.is_dt_fixed) ++frame.dt_s;
    }
    return frame.from_step;
  }
};

}  // namespace

Core controlled(Core core) {
  core.stepper = std::make_shared<const ControlledStepper>(std::move(core.stepper));
  return core;
}

}  // namespace hyrax
