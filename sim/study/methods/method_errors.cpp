#include "sim/study/methods/method_errors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/reference/largest.h"
#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

constexpr std::size_t kImpactsCompared = 3;

State with_inputs(const Stage& stage, const State& motion) {
  World world{.state = motion, .window = {}, .sprite = {}};
  for (const Action& input : stage.inputs) apply(input, world);
  return world.state;
}

// Impacts of a method that goes by frames: rows on a wall on which the row before was not.
class ContactWatch {
 public:
  ContactWatch(const State& start, const Bounds& bounds)
      : bounds_(bounds), was_on_(walls_of(start, bounds)) {}
  void add_row(const State& motion, double t_s) {
    const auto is_on = walls_of(motion, bounds_);
    for (std::size_t wall = 0; wall < is_on.size(); ++wall)
      if (is_on[wall] && !was_on_[wall]) impacts_.push_back({t_s, kWalls[wall]});
    was_on_ = is_on;
  }
  [[nodiscard]] const std::vector<ExactImpact>& impacts() const { return impacts_; }

 private:
  Bounds bounds_;
  std::array<bool, kWalls.size()> was_on_;
  std::vector<ExactImpact> impacts_;
};

WallCounts contacts_off_ground(const std::vector<ExactImpact>& impacts) {
  WallCounts counts;
  for (const ExactImpact& impact : impacts) ++counts[impact.wall];
  counts.ground = 0;
  return counts;
}

// By how many impacts one of two runs is ahead of the other at each wall.
class Lead {
 public:
  [[nodiscard]] bool is_none(const std::vector<ExactImpact>& run, const std::vector<ExactImpact>& exact) {
    for (; of_run_ < run.size(); ++of_run_) ++ahead_[run[of_run_].wall];
    for (; of_exact_ < exact.size(); ++of_exact_) --ahead_[exact[of_exact_].wall];
    return ahead_ == WallCounts{};
  }

 private:
  WallCounts ahead_;
  std::size_t of_run_ = 0, of_exact_ = 0;
};

// Keeps the largest differences.
class ErrorMeter {
 public:
  explicit ErrorMeter(const FixedLaws& laws) : gravity_px_per_s2_(laws.gravity_px_per_s2) {}

  /// A state of the exact fling, of a row or before the first.
  void add_exact(const State& exact) {
    kinetic_largest_ = std::max(kinetic_largest_, 0.5 * (exact.vx_px_per_s * exact.vx_px_per_s +
                                                         exact.vy_px_per_s * exact.vy_px_per_s));
    errors_.coordinate_largest_px =
        std::max({errors_.coordinate_largest_px, std::fabs(exact.x_px), std::fabs(exact.y_px)});
  }

  /// @param is_aligned both have met each wall equally often.
  void add_row(const State& run, const State& exact, bool is_aligned) {
    errors_.end_px = std::hypot(run.x_px - exact.x_px, run.y_px - exact.y_px);
    errors_.position_px = larger(errors_.position_px, errors_.end_px);
    errors_.velocity_px_per_s =
        larger(errors_.velocity_px_per_s,
               std::hypot(run.vx_px_per_s - exact.vx_px_per_s, run.vy_px_per_s - exact.vy_px_per_s));
    if (is_aligned)
      energy_difference_ = larger(energy_difference_, std::fabs(energy_gain(exact, run, gravity_px_per_s2_)));
    add_exact(exact);
  }

  void add_impacts(const std::vector<ExactImpact>& run, const std::vector<ExactImpact>& exact) {
    if (contacts_off_ground(run) != contacts_off_ground(exact)) errors_.has_other_contacts = true;
    for (std::size_t i = 0; i < std::min({run.size(), exact.size(), kImpactsCompared}); ++i) {
      if (run[i].wall != exact[i].wall) return;
      const double apart_s = std::fabs(run[i].t_s - exact[i].t_s);
      errors_.contact_time_s =
          std::isnan(errors_.contact_time_s) ? apart_s : std::max(errors_.contact_time_s, apart_s);
    }
  }

  [[nodiscard]] MethodErrors finish(std::size_t frames) {
    errors_.frames = frames;
    errors_.energy_rel = kinetic_largest_ > 0.0 ? energy_difference_ / kinetic_largest_ : kNotGiven;
    if (!std::isfinite(errors_.position_px)) return {.is_failed = true};
    return errors_;
  }

 private:
  double gravity_px_per_s2_;
  double energy_difference_ = 0.0;
  double kinetic_largest_ = 0.0;
  MethodErrors errors_{};
};

// One stage: rows at least `stride` frames apart, each frame where the method's contacts show in its rows.
// Sets `reference` to the exact state at its end.
bool measure_stage(const Stage& stage, const std::vector<double>& frames_s, std::size_t stride,
                   bool watches_contacts, Method& method, ExactFling& exact, State& reference,
                   ErrorMeter& meter) {
  ContactWatch watch(method.motion(), stage.bounds);
  const std::vector<ExactImpact>& impacts = method.impacts() != nullptr ? *method.impacts() : watch.impacts();
  Lead lead;
  Timeline time;
  for (std::size_t frame = 0; frame < frames_s.size();) {
    const std::size_t row_end = std::min(frames_s.size(), (frame / stride + 1) * stride);
    while (frame < row_end) {
      const std::size_t end = watches_contacts ? frame + 1 : row_end;
      if (!method.play({frames_s.data() + frame, end - frame})) return false;
      for (; frame < end; ++frame) time.play(frames_s[frame]);
      if (watches_contacts) watch.add_row(method.motion(), time.time_s());
    }
    reference = exact.at(time.time_s());
    if (!exact.is_sound()) throw std::logic_error("the exact fling is outside its bounds");
    meter.add_row(method.motion(), reference, lead.is_none(impacts, exact.impacts()));
  }
  meter.add_impacts(impacts, exact.impacts());
  return true;
}

}  // namespace

MethodErrors measure_errors(const Core& core, const Problem& problem, const MethodKind& kind,
                            const std::vector<std::vector<double>>& stage_frames_s, double rate_hz) {
  const std::unique_ptr<Method> method = kind.make();
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(rate_hz / kRowRate_hz)));
  const FixedLaws laws(reference_model(core));
  ExactFling exact(laws);
  ErrorMeter meter(laws);
  State run = problem.start;
  State reference = problem.start;
  std::size_t frames = 0;
  for (std::size_t index = 0; index < problem.stages.size(); ++index) {
    const Stage& stage = problem.stages[index];
    run = with_inputs(stage, run);
    reference = with_inputs(stage, reference);
    method->start(run, stage.bounds, index > 0);
    exact.start(reference, stage.bounds, index > 0 && exact.slides());
    if (stage.is_held) continue;
    meter.add_exact(reference);
    const std::vector<double>& frames_s = stage_frames_s[index];
    frames += frames_s.size();
    const bool watches = !problem.is_free_flight && method->impacts() == nullptr;
    if (!measure_stage(stage, frames_s, stride, watches, *method, exact, reference, meter))
      return {.is_failed = true};
    run = method->motion();
  }
  return meter.finish(frames);
}

double rounding_px(const MethodErrors& errors) {
  constexpr double kUnit = 0x1p-52;
  return 40.0 * kUnit * errors.coordinate_largest_px * std::sqrt(static_cast<double>(errors.frames));
}

bool play_through(const Problem& problem, Method& method,
                  const std::vector<std::vector<double>>& stage_frames_s) {
  State run = problem.start;
  for (std::size_t index = 0; index < problem.stages.size(); ++index) {
    run = with_inputs(problem.stages[index], run);
    method.start(run, problem.stages[index].bounds, index > 0);
    if (problem.stages[index].is_held) continue;
    if (!method.play(stage_frames_s[index])) return false;
    run = method.motion();
  }
  return true;
}

}  // namespace hyrax
