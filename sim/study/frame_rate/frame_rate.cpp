#include "sim/study/frame_rate/frame_rate.h"

#include <algorithm>
#include <cmath>

#include "sim/replay/core.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/split_mix64.h"
#include "sim/study/methods/method.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {
namespace {

constexpr double kUntil_s = 16.0;  // Longer than any of the flings takes to lie.
constexpr std::array<double, 6> kPathRates_hz = {24.0, 30.0, 60.0, 120.0, 240.0, 1000.0};

Clock clock_of(DisplayClock kind, double rate_hz) {
  Clock clock;
  clock.base = FixedRate{rate_hz};
  if (kind == DisplayClock::jittered) clock.jitter = Jitter{Jitter::Kind::normal, 0.002, 11};
  if (kind == DisplayClock::missing) clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.05, 11};
  return clock;
}

State fling_of(std::int64_t number) {
  if (number == 0) return kDrawnFling;
  const auto draw = [number](std::uint64_t which, double low, double high) {
    return low + (high - low) * split_mix64_unit(77, 4 * static_cast<std::uint64_t>(number) + which);
  };
  return {draw(0, 0.0, kDrawnBounds.right_px), draw(1, 0.0, kDrawnBounds.bottom_px), draw(2, -2000.0, 2000.0),
          draw(3, -2000.0, 500.0)};
}

const MethodKind& method_named(const std::vector<MethodKind>& kinds, std::string_view name) {
  return *std::find_if(kinds.begin(), kinds.end(),
                       [name](const MethodKind& kind) { return kind.name == name; });
}

// Plays one fling to its end, frame by frame.
class FlingPlayed {
 public:
  FlingPlayed(const MethodKind& kind, std::size_t method, const State& start)
      : runner_(kind.make()),
        start_(start),
        core_{start.x_px, start.y_px, start.vx_px_per_s, start.vy_px_per_s} {
    landing_.method = method;
    runner_->start(start, kDrawnBounds);
  }

  // Points of the path go into `path`, unless it is null.
  Landing play(DisplayClock kind, double rate_hz, std::vector<FanPoint>* path) {
    const Clock clock = clock_of(kind, rate_hz);
    const FrameClock frames(clock);
    landing_.clock = kind;
    landing_.rate_hz = rate_hz;
    State last = start_;
    RestAnchor rest{start_.x_px, start_.y_px, 0.0};
    Timeline time;
    double next_point_s = 0.0;
    for (std::int64_t frame = 0; time.time_s() < kUntil_s; ++frame) {
      const double dt_s = frames.dt_s(frame);
      time.play(dt_s);
      // A steppable method never fails on a finite frame; one that did would lie where it failed.
      if (!runner_->play({&dt_s, 1})) break;
      const State now = runner_->motion();
      landing_.path_px += std::hypot(now.x_px - last.x_px, now.y_px - last.y_px);
      landing_.across_px += std::fabs(now.x_px - last.x_px);
      last = now;
      if (rest.moves_to(now.x_px, now.y_px)) rest.t_s = time.time_s();
      step_core(dt_s);
      if (path != nullptr && time.time_s() >= next_point_s && rest.t_s >= time.time_s() - 0.5) {
        path->push_back({landing_.method, rate_hz, time.time_s(), now.x_px, now.y_px});
        next_point_s = time.time_s() + 1.0 / 61.0;
      }
    }
    landing_.x_px = last.x_px;
    landing_.time_s = rest.t_s;
    landing_.is_core = landing_.method != 0 || same_bits(last, core_);
    return landing_;
  }

 private:
  void step_core(double dt_s) {
    if (landing_.method != 0) return;
    core_ = core_step(core_, dt_s, kDrawnBounds);
  }

  std::unique_ptr<Method> runner_;
  State start_;
  State core_;
  Landing landing_;
};

Independence independence_of(const std::vector<Landing>& landings, std::size_t method, DisplayClock clock,
                             std::int64_t flings) {
  Independence result{.method = method, .clock = clock};
  for (std::int64_t fling = 0; fling < flings; ++fling) {
    double least_px = 1e300, most_px = -1e300, way_px = 0.0, off_hz = 1e300;
    for (const Landing& landing : landings) {
      if (landing.method != method || landing.clock != clock || landing.fling != fling) continue;
      least_px = std::min(least_px, landing.x_px);
      most_px = std::max(most_px, landing.x_px);
      if (std::fabs(landing.rate_hz - 60.0) >= off_hz) continue;
      off_hz = std::fabs(landing.rate_hz - 60.0);
      way_px = landing.across_px;
    }
    result.spread_px += (most_px - least_px) / static_cast<double>(flings);
    result.way_px += way_px / static_cast<double>(flings);
  }
  result.score = 100.0 * std::max(0.0, 1.0 - result.spread_px / result.way_px);
  return result;
}

}  // namespace

FrameRateStudy study_frame_rate(const std::vector<double>& rates_hz, std::int64_t flings) {
  const std::vector<MethodKind> kinds = frame_methods();
  FrameRateStudy study;
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method) {
    const MethodKind& kind = method_named(kinds, kFrameRateMethods[method]);
    for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock) {
      const auto display = static_cast<DisplayClock>(clock);
      for (const double rate_hz : rates_hz)
        for (std::int64_t fling = 0; fling < flings; ++fling) {
          const bool is_drawn =
              fling == 0 && display == DisplayClock::steady &&
              std::find(kPathRates_hz.begin(), kPathRates_hz.end(), rate_hz) != kPathRates_hz.end();
          study.landings.push_back(FlingPlayed(kind, method, fling_of(fling))
                                       .play(display, rate_hz, is_drawn ? &study.paths : nullptr));
          study.landings.back().fling = fling;
        }
      study.scores.push_back(independence_of(study.landings, method, display, flings));
    }
  }
  return study;
}

}  // namespace hyrax
