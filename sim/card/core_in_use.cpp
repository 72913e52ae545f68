#include "sim/card/core_in_use.h"

#include <cassert>
#include <cfenv>
#include <utility>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "sim/physics/strict_arithmetic.h"
#include "sim/reference/model.h"
#include "sim/replay/core.h"
#include "sim/replay/core_constants.h"
#include "sim/replay/core_shape.h"

namespace hyrax {
namespace {

// What of the processor's control register decides about results: rounding mode, flush-to-zero,
// denormals-are-zero and trapped exceptions. Which exceptions have occurred does not.
unsigned arithmetic_mode() {
#if defined(__SSE2__)
  return _mm_getcsr() & ~static_cast<unsigned>(_MM_EXCEPT_MASK);
#else
  return static_cast<unsigned>(std::fegetround()) + (arithmetic_fault() ? 1u << 31 : 0u);
#endif
}

const unsigned kUsualMode = arithmetic_mode();  // Before any core is loaded.

PlayWatch unwatched{};
PlayWatch* watch = &unwatched;
const CoreInUse* current = nullptr;

const CoreFunctions& core() {
  assert(current != nullptr);
  return current->core();
}

template <class Call>
auto watched(std::int64_t from_step, std::int64_t steps, const Call& call) {
  watch->begin_call(from_step, steps);
  auto result = [&call] {
    try {
      return call();
    } catch (...) {
      throw CoreRefused(core().number, "throws an exception in " + watch->where());
    }
  }();
  if (arithmetic_mode() != kUsualMode) require_usual_arithmetic(core().number, watch->where());
  return result;
}

class WatchedKernel final : public Kernel {
 public:
  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    watched(stretch.from_step, stretch.frames, [&] {
      core().kernel->play(stretch, body, rest, rows, log);
      return 0;
    });
  }
  [[nodiscard]] std::optional<Constants> constants() const override { return core().kernel->constants(); }
  void apply(const Action& action, Keyframe& now) const override {
    watched(now.row.step, 0, [&] {
      core().kernel->apply(action, now);
      return 0;
    });
  }
};

}  // namespace

CoreInUse::CoreInUse(const CoreFunctions& core, std::string place)
    : core_(core), place_(std::move(place)), before_(current) {
  current = this;
  show();
}
CoreInUse::~CoreInUse() {
  current = before_;
  if (current != nullptr) current->show();
}
void CoreInUse::show() const {
  watch->core = core_.number;
  watch->set_place(place_);
}

void watch_plays_in(PlayWatch& place) { watch = &place; }

void require_usual_arithmetic(int core, const std::string& where) {
  if (arithmetic_mode() != kUsualMode)
    throw CoreRefused(
        core,
        "changes how the processor computes (rounding mode, subnormals or trapped exceptions): found after " +
            where);
}

// All that sim/replay/core.cpp and kernel.cpp define: the linker then takes neither of them.
const Kernel& core_kernel() {
  static const WatchedKernel kernel;
  return kernel;
}
std::string_view core_model() { return core().model(); }
Constants core_constants() {
  if (core().lacking() == nullptr) return core().kernel->constants().value();
  const Model paper;
  return {.gravity_px_per_s2 = paper.gravity_px_per_s2,
          .restitution = paper.restitution,
          .air_drag = paper.air_drag,
          .ground_friction = paper.ground_friction,
          .rest_threshold_px_per_s = paper.rest_threshold_px_per_s};
}
State core_step(const State& body, double dt_s, const Bounds& bounds) {
  return watched(0, 0, [&] { return core().step(body, dt_s, bounds); });
}
State core_steps(State body, double dt_s, const Bounds& bounds, std::int64_t steps) {
  return watched(0, steps, [&] { return core().steps(body, dt_s, bounds, steps); });
}
State core_played(const State& body, std::span<const double> frames_s, const Bounds& bounds, int parts) {
  return watched(0, std::ssize(frames_s) * parts,
                 [&] { return core().played(body, frames_s, bounds, parts); });
}
State core_stopped(const State& body) {
  return watched(0, 0, [&] { return core().stopped(body); });
}
State core_flight(const State& body, double dt_s) {
  return watched(0, 0, [&] { return core().flight(body, dt_s); });
}
// No trace of it: sweeps of any core are played step by step.
const StepShape& core_shape() {
  static const StepShape kUnknown;
  return kUnknown;
}
std::optional<Constants> measured_constants() { return core_constants(); }

}  // namespace hyrax
