#include "sim/search/shrink.h"

#include <algorithm>
#include <set>

#include "sim/scenario/frame_clock.h"
#include "sim/search/scenario_edit.h"

namespace hyrax {
namespace {

constexpr std::int64_t kRecordedMax = 10'000;  // Frames of a jittered clock that are written out.
constexpr std::int64_t kChunksMax = 512;       // So many chunks of frames are tried one by one.

Scenario with_clock(const Scenario& scenario, const Clock& clock) {
  Scenario changed = scenario;
  changed.clock = clock;
  changed.length = step_count(scenario);
  return changed;
}

class Shrinker {
 public:
  Shrinker(const Core& core, const Scenario& start, const std::function<bool(const Scenario&)>& fails,
           const ShrinkOptions& options)
      : core_(core), fails_(fails), options_(options), best_(start), complexity_(complexity_of(start)) {}

  [[nodiscard]] bool starts_failing() { return is_failing(best_); }

  [[nodiscard]] Shrunk run() {
    for (Complexity before; before != complexity_ && !is_exhausted();) {
      before = complexity_;
      leave_out_extras();
      write_out_jitter();
      cut_end();
      start_later();
      leave_out_events();
      leave_out_frames();
      simplify_clock();
      round_numbers();
    }
    return {std::move(best_), trials_, true, !is_exhausted()};
  }

 private:
  [[nodiscard]] bool is_exhausted() const {
    return trials_ >= options_.trials_max || (options_.is_over && options_.is_over());
  }
  [[nodiscard]] std::int64_t steps() const { return complexity_.steps; }

  bool is_failing(const Scenario& scenario) {
    if (options_.report) options_.report(trials_, best_);
    ++trials_;
    return fails_(scenario);
  }

  // Takes the scenario if it is simpler and fails.
  bool accept(Scenario scenario) {
    if (is_exhausted() || !is_valid(scenario)) return false;
    const Complexity complexity = complexity_of(scenario);
    if (!(complexity < complexity_) || !is_failing(scenario)) return false;
    best_ = std::move(scenario);
    complexity_ = complexity;
    return true;
  }

  void leave_out_extras() {
    Scenario scenario = best_;
    scenario.expect.reset();
    accept(std::move(scenario));
    scenario = best_;
    scenario.record_every = 1;
    accept(std::move(scenario));
    for (std::size_t index = best_.parameters.size(); index-- > 0;) {
      scenario = best_;
      scenario.parameters.erase(scenario.parameters.begin() + static_cast<std::ptrdiff_t>(index));
      accept(std::move(scenario));
    }
  }

  // The frames of a recorded clock can be cut anywhere.
  void write_out_jitter() {
    if (best_.clock.jitter && steps() > 0 && steps() <= kRecordedMax) accept(recorded(best_));
  }

  void cut_end() {
    for (std::int64_t cut = steps(); cut > 0; cut /= 2)
      while (cut <= steps() && accept(without_frames(best_, steps() - cut, steps()))) continue;
  }

  void start_later() {
    for (std::int64_t cut = steps(); cut > 0; cut /= 2)
      while (cut <= steps() && !is_exhausted() && accept_later(cut)) continue;
  }

  bool accept_later(std::int64_t cut) {
    std::optional<Scenario> later =
        options_.start_later ? options_.start_later(best_, cut) : after_frames(core_, best_, cut);
    return later && accept(std::move(*later));
  }

  void leave_out_events() {
    for (std::size_t size = best_.events.size(); size > 0; size /= 2)
      for (std::size_t last = best_.events.size(); last > 0;) {
        const std::size_t first = last - std::min(size, last);
        accept(without_events(best_, first, last));
        last = std::min(first, best_.events.size());  // An unpaired grab may have gone with them.
      }
  }

  void leave_out_frames() {
    const std::int64_t smallest = steps() / kChunksMax;
    for (std::int64_t size = steps() / 2; size > smallest; size /= 2)
      for (std::int64_t last = steps(); last > 0 && !is_exhausted();) {
        const std::int64_t first = last - std::min(size, last);
        accept(without_frames(best_, first, last));
        last = first;
      }
  }

  void simplify_clock() {
    if (accept(with_clock(best_, {.base = FixedRate{}, .jitter = {}}))) return;
    if (const auto* const trace = std::get_if<RecordedSteps>(&best_.clock.base)) {
      const std::set<double> lengths_s(trace->dt_s.begin(), trace->dt_s.end());
      for (const double dt_s : lengths_s)
        if (accept(with_clock(best_, {.base = FixedStep{dt_s}, .jitter = {}}))) return;
    } else {
      accept(with_clock(best_, {.base = best_.clock.base, .jitter = {}}));
    }
  }

  void round_numbers() {
    const std::size_t count = numbers_of(best_).size();
    for (std::size_t index = 0; index < count && !is_exhausted(); ++index) round_number(index);
  }

  // A window without a side would only be puzzling.
  void round_number(std::size_t index) {
    const bool is_size = std::holds_alternative<std::int32_t*>(numbers_of(best_)[index].at);
    for (int digits = is_size ? 1 : 0; digits < kDigitsMax; ++digits) {
      Scenario rounder = best_;
      round_to(numbers_of(rounder)[index], digits);
      if (accept(std::move(rounder))) return;
    }
  }

  const Core& core_;
  const std::function<bool(const Scenario&)>& fails_;
  const ShrinkOptions& options_;
  Scenario best_;
  Complexity complexity_;
  std::int64_t trials_ = 0;
};

}  // namespace

Complexity complexity_of(const Scenario& scenario) {
  return {.steps = step_count(scenario),
          .events = static_cast<std::int64_t>(scenario.events.size()),
          .extras = (scenario.expect ? 1 : 0) + (scenario.record_every != 1 ? 1 : 0) +
                    std::ssize(scenario.parameters),
          .clock = scenario.clock.jitter ? 3 : static_cast<std::int64_t>(scenario.clock.base.index()),
          .digits = digits_of(scenario)};
}

Shrunk shrink(const Core& core, const Scenario& failing, const std::function<bool(const Scenario&)>& fails,
              const ShrinkOptions& options) {
  Shrinker shrinker(core, plain(failing), fails, options);
  if (!shrinker.starts_failing()) return {.scenario = failing, .trials = 1};
  return shrinker.run();
}

}  // namespace hyrax
