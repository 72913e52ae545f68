#include "sim/card/compared_core.h"

#include <cfenv>
#include <utility>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "sim/core/core_of.h"
#include "sim/physics/strict_arithmetic.h"
#include "sim/reference/model.h"

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

class GuardedKernel final : public KernelOver {
  template <class Call>
  void guarded(std::int64_t from_step, std::int64_t steps, const Call& call) const {
    watch_.begin_call(from_step, steps);
    try {
      call();
    } catch (...) {
      throw CoreRefused(number_, "throws an exception in " + watch_.where());
    }
    if (arithmetic_mode() != kUsualMode) require_usual_arithmetic(number_, watch_.where());
  }

 public:
  GuardedKernel(std::shared_ptr<const Kernel> kernel, int number, PlayWatch& watch)
      : KernelOver(std::move(kernel)), number_(number), watch_(watch) {}

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    guarded(stretch.from_step, stretch.frames, [&] { KernelOver::play(stretch, body, rest, rows, log); });
  }
  void apply(const Action& action, Keyframe& now) const override {
    guarded(now.row.step, 0, [&] { KernelOver::apply(action, now); });
  }
  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds,
                            std::int64_t steps) const override {
    State end;
    guarded(0, steps, [&] { end = KernelOver::steps(body, dt_s, bounds, steps); });
    return end;
  }
  [[nodiscard]] State played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                             int parts) const override {
    State end;
    guarded(0, std::ssize(frames_s) * parts,
            [&] { end = KernelOver::played(body, frames_s, bounds, parts); });
    return end;
  }

 private:
  int number_;
  PlayWatch& watch_;
};

}  // namespace

ComparedCore compared_core(int number, const LibraryCore& library, const CoreRecord& record,
                           PlayWatch& watch) {
  ComparedCore compared{number, &watch, library.counted, library.timed, library.lacking};
  Core& core = compared.core;
  core.kernel = std::make_shared<const GuardedKernel>(core.kernel, number, watch);
  core.record = record;
  complete_by_step(core);
  if (!core.constants) core.constants = paper_constants();
  return compared;
}

void require_usual_arithmetic(int core, const std::string& where) {
  if (arithmetic_mode() != kUsualMode)
    throw CoreRefused(
        core,
        "changes how the processor computes (rounding mode, subnormals or trapped exceptions): found after " +
            where);
}

}  // namespace hyrax
