#include "sim/study/frame_rate/frame_rate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/reference/exact_fling.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/reference_model.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {
namespace {

constexpr double kUntilLeast_s = 16.0, kUntilMost_s = 60.0;
constexpr std::array<double, 6> kPathRates_hz = {24.0, 30.0, 60.0, 120.0, 240.0, 1000.0};

Clock clock_of(DisplayClock kind, double rate_hz) {
  Clock clock;
  clock.base = FixedRate{rate_hz};
  if (kind == DisplayClock::jittered) clock.jitter = Jitter{Jitter::Kind::normal, 0.002, kJitterSeed};
  if (kind == DisplayClock::missing) clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.05, kJitterSeed};
  return clock;
}

// How long a fling of ManyFlings may take to settle, at most. It falls with at most v = sqrt(2000^2 + 2 G H);
// a flight up and down takes 2 v / G, and all bounces are a geometric series of the restitution. Where frames
// drag so often that it sinks instead of falling, H / terminal speed comes on top; at last it slides, until
// drag and friction have left less of 2000 px/s than half a pixel a second. Infinite: it may never.
double settling_s(const Constants& core, const std::vector<double>& rates_hz) {
  constexpr double kFastest_px_per_s = 2000.0;
  const auto [slowest_hz, fastest_hz] = std::ranges::minmax(rates_hz);
  const double gravity = core.gravity_px_per_s2;
  const double falling_px_per_s =
      std::sqrt(kFastest_px_per_s * kFastest_px_per_s + 2.0 * gravity * kDesktop.bottom_px);
  const double bounces_s = 2.0 * falling_px_per_s / gravity / (1.0 - core.restitution);
  const double sinks_s = kDesktop.bottom_px * (1.0 - core.air_drag) * fastest_hz / (core.air_drag * gravity);
  const double slides_s =
      std::log(2.0 * kFastest_px_per_s) / -std::log(core.air_drag * core.ground_friction) / slowest_hz;
  return bounces_s + sinks_s + slides_s + RestAnchor::kLeastRest_s;
}

std::array<double, kStateNames.size()> values_of(const State& state) {
  return {state.x_px, state.y_px, state.vx_px_per_s, state.vy_px_per_s};
}

// Plays a fling on from its end, from that frame of its clock on, for a second: `play` plays a frame of that
// dt and returns the row.
template <class Play>
void watch(Landing& landing, const FrameClock& frames, std::int64_t frame, Play play) {
  constexpr double kWatched_s = 1.0;
  State last = landing.end;
  for (Timeline time; time.time_s() < kWatched_s; ++frame) {
    time.play(frames.dt_s(frame));
    const State now = play(frames.dt_s(frame));
    landing.moves_px =
        std::max(landing.moves_px, std::hypot(now.x_px - landing.end.x_px, now.y_px - landing.end.y_px));
    for (std::size_t each = 0; each < landing.changes.size(); ++each)
      landing.changes[each] |= !(std::fabs(values_of(now)[each] - values_of(last)[each]) <=
                                 1e-9 * std::fabs(values_of(last)[each]));
    last = now;
  }
}

// Plays one fling to its end, frame by frame. Points of the path go into `path`, unless it is null.
Landing play_fling(const Core& core, const MethodKind& kind, Landing landing, const State& start,
                   const Clock& clock, std::int64_t frame_count, std::vector<FanPoint>* path = nullptr) {
  const std::unique_ptr<Method> method = kind.make();
  method->start(start, kDesktop, false);
  const FrameClock frames(clock);
  landing.path_px = landing.across_px = 0.0;
  State now = start, by_core = start;
  std::array<bool, kWalls.size()> was_on{};
  RestAnchor rest{start.x_px, start.y_px, 0.0};
  Timeline time;
  double next_point_s = 0.0;
  for (std::int64_t frame = 0; frame < frame_count; ++frame) {
    const double dt_s = frames.dt_s(frame);
    time.play(dt_s);
    // A steppable method never fails on a finite frame; one that did would lie where it failed.
    if (!method->play({&dt_s, 1})) break;
    const State last = std::exchange(now, method->motion());
    landing.path_px += std::hypot(now.x_px - last.x_px, now.y_px - last.y_px);
    landing.across_px += std::fabs(now.x_px - last.x_px);
    const auto is_on = walls_of(now, kDesktop);
    for (const Wall wall : kWalls)
      if (is_on[wall_index(wall)] && !was_on[wall_index(wall)]) ++landing.contacts[wall];
    was_on = is_on;
    if (rest.moves_to(now.x_px, now.y_px)) rest.t_s = time.time_s();
    if (landing.method == 0) by_core = core.step(by_core, dt_s, kDesktop);
    if (path != nullptr && time.time_s() >= next_point_s && rest.t_s >= time.time_s() - 0.5) {
      path->push_back({landing.method, landing.rate_hz, time.time_s(), now.x_px, now.y_px});
      next_point_s = time.time_s() + 1.0 / 61.0;
    }
  }
  landing.end = now;
  landing.time_s = rest.at_rest_since_s(time.time_s()).value_or(kNotGiven);
  watch(landing, frames, frame_count, [&](double dt_s) {
    return method->play({&dt_s, 1}) ? method->motion() : State{kNotGiven, kNotGiven, kNotGiven, kNotGiven};
  });
  landing.is_core = landing.method != 0 || same_bits(now, by_core);
  return landing;
}

// Flings of one method under one clock, on every display.
class DisplayFlings {
 public:
  DisplayFlings(const Core& core, FrameRateStudy& study, const std::vector<double>& rates_hz,
                std::int64_t flings)
      : core_(core), study_(study), rates_hz_(rates_hz), flings_(flings) {
    const auto nearest =
        std::ranges::min_element(rates_hz, {}, [](double rate_hz) { return std::fabs(rate_hz - 60.0); });
    near_60_ = static_cast<std::size_t>(nearest - rates_hz.begin());
    exact_px_.push_back(exact_place_px(kDrawnFling));
    const ManyFlings random({FixedRate{*nearest}, {}}, study_.until_s, flings_);
    for (std::int64_t number = 0; number < flings_; ++number)
      exact_px_.push_back(exact_place_px(random.start(number)));
  }

  /// Returns, by fling, the spread of the places where it settles over all rates.
  std::vector<double> play(const MethodKind& kind, std::size_t method, DisplayClock clock) {
    landings_.clear();
    for (const double rate_hz : rates_hz_)
      play_display(kind, {.method = method, .clock = clock, .rate_hz = rate_hz});
    for (Landing& landing : landings_)
      landing.off_px = std::fabs(landing.end.x_px - exact_px_[static_cast<std::size_t>(landing.fling)]);
    study_.landings.insert(study_.landings.end(), landings_.begin(), landings_.end());
    for (std::size_t rate = 0; rate < rates_hz_.size(); ++rate)
      study_.shifts.push_back(shift(method, clock, rate));
    std::vector<double> spreads = spreads_px();
    study_.scores.push_back(independence(method, clock, spreads));
    return spreads;
  }

 private:
  [[nodiscard]] double exact_place_px(const State& start) const {
    ExactFling exact{FixedLaws(reference_model(core_))};
    exact.start(start, kDesktop);
    return exact.at(study_.until_s).x_px;
  }

  // The drawn fling, then the random ones.
  void play_display(const MethodKind& kind, Landing landing) {
    const ManyFlings flings(clock_of(landing.clock, landing.rate_hz), study_.until_s, flings_);
    const bool has_path = landing.clock == DisplayClock::steady &&
                          std::ranges::find(kPathRates_hz, landing.rate_hz) != kPathRates_hz.end();
    landings_.push_back(play_fling(core_, kind, landing, kDrawnFling, flings.clock(0), flings.frames(),
                                   has_path ? &study_.paths : nullptr));
    const bool is_paper = landing.method == 0;
    const std::vector<MemberResult> by_core = is_paper ? flings.play(core_) : std::vector<MemberResult>();
    for (std::int64_t number = 0; number < flings_; ++number) {
      landing.fling = number + 1;
      Landing& played = landings_.emplace_back(landing);
      // The core's at the rate nearest to 60 Hz, too: for its path, and to see that both agree.
      const bool is_stepped = !is_paper || landing.rate_hz == rates_hz_[near_60_];
      if (is_stepped)
        played =
            play_fling(core_, kind, landing, flings.start(number), flings.clock(number), flings.frames());
      if (!is_paper) continue;
      const MemberResult& member = by_core[static_cast<std::size_t>(number)];
      if (is_stepped) played.is_core &= same_bits(played.end, member.final);
      played.end = member.final;
      played.time_s = member.at_rest_since_s;
      played.contacts = member.contacts;
      if (is_stepped) continue;
      const Clock clock = flings.clock(number);
      watch(played, FrameClock(clock), flings.frames(), [this, row = member.final](double dt_s) mutable {
        return row = core_.step(row, dt_s, kDesktop);
      });
    }
  }

  [[nodiscard]] std::vector<double> spreads_px() const {
    std::vector<double> spreads_px;
    for (std::int64_t fling = 0; fling <= flings_; ++fling) {
      double least_px = HUGE_VAL, most_px = -HUGE_VAL;
      for (std::size_t rate = 0; rate < rates_hz_.size(); ++rate) {
        least_px = std::min(least_px, at(rate, fling).end.x_px);
        most_px = std::max(most_px, at(rate, fling).end.x_px);
      }
      spreads_px.push_back(most_px - least_px);
    }
    return spreads_px;
  }

  [[nodiscard]] const Landing& at(std::size_t rate, std::int64_t fling) const {
    return landings_[rate * static_cast<std::size_t>(flings_ + 1) + static_cast<std::size_t>(fling)];
  }
  [[nodiscard]] const Landing& near_60(std::int64_t fling) const { return at(near_60_, fling); }
  [[nodiscard]] bool has_other_contacts(std::size_t rate, std::int64_t fling) const {
    WallCounts here = at(rate, fling).contacts;
    WallCounts there = near_60(fling).contacts;
    here.ground = there.ground = 0;
    return here != there;
  }

  [[nodiscard]] Independence independence(std::size_t method, DisplayClock clock,
                                          const std::vector<double>& spreads) const {
    Independence result{.method = method, .clock = clock};
    const auto count = static_cast<double>(spreads.size());
    for (std::int64_t fling = 0; fling <= flings_; ++fling) {
      result.spread_px += spreads[static_cast<std::size_t>(fling)] / count;
      result.way_px += near_60(fling).across_px / count;
      bool is_other = false;
      for (std::size_t rate = 0; rate < rates_hz_.size(); ++rate) is_other |= has_other_contacts(rate, fling);
      result.other_contacts.add(is_other);
    }
    result.score = 100.0 * std::max(0.0, 1.0 - result.spread_px / result.way_px);
    result.spreads_px = *band_of(spreads);
    return result;
  }

  [[nodiscard]] DisplayShift shift(std::size_t method, DisplayClock clock, std::size_t rate) const {
    DisplayShift result{.method = method, .clock = clock, .rate_hz = rates_hz_[rate]};
    std::vector<double> shifts_px, offs_px, times_s;
    for (std::int64_t fling = 0; fling <= flings_; ++fling) {
      shifts_px.push_back(std::fabs(at(rate, fling).end.x_px - near_60(fling).end.x_px));
      offs_px.push_back(at(rate, fling).off_px);
      result.other_contacts.add(has_other_contacts(rate, fling));
      const Landing& landing = at(rate, fling);
      const bool has_settled = !std::isnan(landing.time_s);
      result.settled.add(has_settled);
      if (has_settled) times_s.push_back(landing.time_s);
      if (has_settled) result.moves_px = std::max(result.moves_px, landing.moves_px);
      for (std::size_t each = 0; each < landing.changes.size(); ++each)
        result.changing[each] += landing.changes[each] ? 1 : 0;
    }
    result.settles_s = band_of(times_s);
    result.shift_px = *band_of(shifts_px);
    result.off_px = *band_of(offs_px);
    return result;
  }

  const Core& core_;
  FrameRateStudy& study_;
  const std::vector<double>& rates_hz_;
  std::int64_t flings_;
  std::size_t near_60_ = 0;        // The rate nearest to 60 Hz.
  std::vector<double> exact_px_;   // By fling: where the exact one settles.
  std::vector<Landing> landings_;  // By rate, then by fling; the drawn one first.
};

Scenario drawn_scenario(double duration_s) {
  Scenario scenario;
  scenario.name = "the fling";
  scenario.window = {1920, 1080};
  scenario.sprite = {128, 128};
  scenario.clock = {FixedRate{60.0}, {}};
  scenario.length = duration_s;
  scenario.start = {kDrawnFling.x_px, kDrawnFling.y_px};
  scenario.start_velocity = velocity_of(kDrawnFling);
  return scenario;
}

}  // namespace

FrameRateStudy study_frame_rate(const Core& core, const std::vector<double>& rates_hz, std::int64_t flings,
                                const StepProgram* step) {
  FrameRateStudy study;
  study.until_s = kUntilLeast_s;
  study.has_float = step != nullptr && has_float(*step);
  if (core.constants) {
    const double settling = settling_s(*core.constants, rates_hz);
    study.has_drag = core.constants->air_drag < 1.0;
    study.is_cut = !(settling <= kUntilMost_s);
    study.until_s = study.is_cut ? kUntilMost_s : std::max(std::ceil(settling), kUntilLeast_s);
  }
  if (step != nullptr)
    for (const double rate_hz : rates_hz)
      study.roundings.push_back(rounding_of(*step, rate_hz, study.until_s));
  if (!core.constants) {
    study.ladder = climb(core, drawn_scenario(study.until_s), rates_hz);
    return study;
  }
  const std::vector<MethodKind> kinds = frame_methods(core);
  DisplayFlings displays(core, study, rates_hz, flings);
  std::array<std::vector<double>, kDisplayClockNames.size()> spreads_by_paper_px;
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method)
    for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock) {
      const MethodKind& kind = *std::ranges::find(kinds, kFrameRateMethods[method], &MethodKind::name);
      const std::vector<double> spreads_px = displays.play(kind, method, static_cast<DisplayClock>(clock));
      if (method == 0)
        spreads_by_paper_px[clock] = spreads_px;
      else
        for (std::size_t fling = 0; fling < spreads_px.size(); ++fling)
          study.steadier_by_time[clock].add(spreads_px[fling] < spreads_by_paper_px[clock][fling]);
    }
  return study;
}

std::vector<Landing> drawn_landings(const FrameRateStudy& study, std::size_t method, DisplayClock clock) {
  std::vector<Landing> chosen;
  for (const Landing& landing : study.landings)
    if (landing.method == method && landing.clock == clock && landing.fling == 0) chosen.push_back(landing);
  return chosen;
}

}  // namespace hyrax
