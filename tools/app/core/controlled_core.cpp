#include "tools/app/core/controlled_core.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <optional>

#include "tools/app/core/control_bits.h"

namespace hyrax {
namespace {

// What a call of the core does that it must not; names the row, if one is given.
struct Fault {
  std::optional<std::string> thrown;  // Else the control bits changed.

  [[nodiscard]] std::string sentence(const std::string& where) const {
    return thrown ? "the core throws" + where + ": " + *thrown : control_bits_message(where);
  }
};

template <class Call>
std::optional<Fault> fault_of(const Call& call) {
  const ControlBits bits;
  std::optional<std::string> thrown;
  try {
    call();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    thrown = error.what();
  } catch (...) {
    thrown = "an exception that is no std::exception";
  }
  if (bits.restore()) return Fault{};
  return thrown ? std::optional(Fault{thrown}) : std::nullopt;
}

// @param where of a call that has a fault: as " in the step that makes row 3".
template <class Call, class Where>
void look_at(const Call& call, const Where& where) {
  if (const auto fault = fault_of(call))
    throw CoreFailure(fault->thrown ? ExitCode::disagreed : ExitCode::not_strict_ieee,
                      fault->sentence(where()), fault->sentence(""));
}
State look_at(const auto& call) {
  State after;
  look_at([&] { after = call(); }, [] { return ""; });
  return after;
}

class ControlledStepper final : public StepperOver {
 public:
  using StepperOver::StepperOver;

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    const CoreBody before = body;
    const RestAnchor rest_before = rest;
    look_at(
        [&] { StepperOver::play(stretch, body, rest, rows, log); },
        [&] { return fmt::format(" in the step that makes row {}", row_of(stretch, before, rest_before)); });
  }
  void apply(const Action& action, Keyframe& now) const override {
    look_at([&] { StepperOver::apply(action, now); },
            [&] { return fmt::format(" in an event before row {}", now.row.step + 1); });
  }
  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds,
                            std::int64_t steps) const override {
    return look_at([&] { return StepperOver::steps(body, dt_s, bounds, steps); });
  }
  [[nodiscard]] State played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                             int parts) const override {
    return look_at([&] { return StepperOver::played(body, frames_s, bounds, parts); });
  }

 private:
  // The row that the first step makes which has a fault; the last one where none has it again.
  [[nodiscard]] std::int64_t row_of(const Stretch& stretch, CoreBody body, RestAnchor rest) const {
    Stretch frame = stretch;
    frame.frames = 1;
    frame.anchor = nullptr;
    RowBlock rows;
    StretchLog log;
    for (; frame.from_step < stretch.from_step + stretch.frames; ++frame.from_step) {
      rows.shrink(0);
      if (fault_of([&] { StepperOver::play(frame, body, rest, rows, log); })) return frame.from_step + 1;
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
