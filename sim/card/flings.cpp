#include "sim/card/card.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sim/compare/overlay.h"
#include "sim/reference/drift_meter.h"
#include "sim/reference/exact_fling.h"
#include "sim/reference/flight.h"
#include "sim/reference/model.h"
#include "sim/scenario/split_mix64.h"
#include "sim/study/display_rates.h"
#include "sim/study/methods/many_flings.h"

namespace hyrax {
namespace {

// Those of kDesktop.
constexpr Size kWindow{1920, 1080};
constexpr Size kSprite{128, 128};
constexpr int kRate_hz = 60;
constexpr std::int64_t kDuration_s = 20;  // Longer than any fling of the shipped core takes to settle.
constexpr int kExactSeconds = 5;

std::string place_of(std::uint64_t seed, std::int64_t number) {
  return "random fling " + std::to_string(number) + " of seed " + std::to_string(seed);
}

// Sums the energy drift of flight arcs.
struct ArcDriftSum final : DriftSink {
  void arc(const ArcErrors& arc) override { px2_per_s2 += arc.energy_drift_end_px2_per_s2; }
  double px2_per_s2 = 0.0;
};

// REQUIRES: the rows have their contacts.
double energy_drift_px2_per_s2(const Scenario& scenario, const CoreRun& run) {
  ArcDriftSum sum;
  DriftMeter meter(scenario, {}, sum);
  Columns batch;
  batch.reserve(run.rows.size());
  for (const Row& row : run.rows) batch.append(row);
  meter.rows(batch);
  meter.finish();
  return sum.px2_per_s2;
}

Figure both_paths(const std::string& place, const CoreRun& base, const CoreRun& candidate) {
  Overlay overlay;
  for (std::size_t row = 0; row < std::min(base.rows.size(), candidate.rows.size()); ++row)
    overlay.add(base.rows[row], candidate.rows[row]);
  Figure figure = overlay.figure({.title = "The fling that lands farthest away",
                                  .subtitle = "Both cores at 60 Hz, " + place,
                                  .a = "base",
                                  .b = "candidate",
                                  .bounds = kDesktop});
  figure.suffix = "-farthest";
  return figure;
}

double half_square_difference(double a, double b) { return 0.5 * (a - b) * (a + b); }

using EnergyByCause = std::array<double, kEnergyCauseCount>;

// REQUIRES: the rows have their contacts; no inputs.
EnergyByCause energy_by_cause(const Scenario& scenario, const CoreRun& run) {
  const Model model;
  const double rate_per_s = -std::log(model.air_drag) * model.model_rate_hz;
  double lift = 0.0, bounce = 0.0, friction = 0.0;
  for (std::size_t index = 1; index < run.rows.size(); ++index) {
    const Row& row = run.rows[index];
    if (run.at_rest_since_s && row.t_s > *run.at_rest_since_s) break;
    if (row.contact == 0) continue;
    const auto touches_either = [&row](Wall a, Wall b) {
      return touches(row.contact, a) || touches(row.contact, b);
    };
    const Row& from = run.rows[index - 1];
    const AxisMotion x = fly(from.vx_px_per_s, 0.0, rate_per_s, row.dt_s);
    const AxisMotion y = fly(from.vy_px_per_s, model.gravity_px_per_s2, rate_per_s, row.dt_s);
    (touches_either(Wall::left, Wall::right) ? bounce : friction) +=
        half_square_difference(row.vx_px_per_s, x.speed_px_per_s);
    (touches_either(Wall::top, Wall::ground) ? bounce : friction) +=
        half_square_difference(row.vy_px_per_s, y.speed_px_per_s);
    lift += model.gravity_px_per_s2 * (y.displacement_px - (row.y_px - from.y_px));
  }
  return {energy_drift_px2_per_s2(scenario, run), lift, bounce, friction};
}

// Samples of one core, gathered fling by fling.
struct FlingSamples {
  std::array<std::vector<double>, kEnergyCauseCount> energy_px2_per_s2;
  std::array<std::vector<double>, kExactSeconds> exact_px;  // Distance after 1, 2, ... s.

  void add(const Scenario& scenario, CoreRun& run) {
    const EnergyByCause energy = energy_by_cause(scenario, run);
    for (std::size_t cause = 0; cause < energy.size(); ++cause)
      energy_px2_per_s2[cause].push_back(energy[cause]);
    run.extend(std::max<std::size_t>(run.rows.size(), kExactSeconds * kRate_hz + 1));
    ExactFling exact;
    exact.start(start_state(scenario), bounds_of(scenario.window, scenario.sprite));
    for (std::size_t second = 1; second <= exact_px.size(); ++second)
      exact_px[second - 1].push_back(
          distance_px(exact.at(static_cast<double>(second)), state_of(run.rows[second * kRate_hz])));
  }
};

// Its four numbers are draws 4 number .. 4 number + 3 of the seed.
State random_fling(std::uint64_t seed, std::int64_t number) {
  const auto draw = [&](std::uint64_t which, double low, double high) {
    return low + (high - low) * split_mix64_unit(seed, 4 * static_cast<std::uint64_t>(number) + which);
  };
  return {draw(0, 0.0, kDesktop.right_px), draw(1, 0.0, kDesktop.bottom_px), draw(2, -2000.0, 2000.0),
          draw(3, -2000.0, 500.0)};
}

}  // namespace

void measure_flings(const ComparedCores& cores, Card& card) {
  FlingLine& line = card.random;
  line.changed_contacts.of = card.flings;
  std::vector<double> shift_px, distances_px;
  FlingSamples before, after;
  for (std::int64_t number = 0; number < card.flings; ++number) {
    const Scenario scenario =
        scenario_from(random_fling(card.seed, number), kWindow, kSprite, kRate_hz, kRate_hz * kDuration_s);
    const std::string place = place_of(card.seed, number);
    const auto played = [&](const ComparedCore& core) { return play_by(core.at(place), scenario); };
    auto [from, to] = of_both(cores, played);
    if (played(cores.after).hash != to.hash)
      throw CoreRefused(cores.after.number, "does not repeat: " + place + " played twice differs");
    const RunChange change = compare_runs(scenario, from, to);
    line.classes.add(change);
    if (!change.contacts.is_none()) ++line.changed_contacts.count;
    if (from.at_rest_since_s) ++line.settled.before;
    if (to.at_rest_since_s) ++line.settled.after;
    if (from.at_rest_since_s && !to.at_rest_since_s) ++line.no_longer_settle;
    if (from.at_rest_since_s && to.at_rest_since_s) {
      shift_px.push_back(to.final.x_px - from.final.x_px);
      distances_px.push_back(change.end_shift_px);
      if (change.end_shift_px > line.distance_max_px) line.farthest = both_paths(place, from, to);
      line.distance_max_px = std::max(line.distance_max_px, change.end_shift_px);
    }
    if (!from.is_finite || !to.is_finite) continue;
    before.add(scenario, from);
    after.add(scenario, to);
  }
  line.shift_px = band_of(shift_px);
  line.distance_px = band_of(distances_px);
  line.distances_px = std::move(distances_px);
  for (std::size_t cause = 0; cause < kEnergyCauseCount; ++cause)
    card.energy_px2_per_s2[cause] = {band_of(before.energy_px2_per_s2[cause]),
                                     band_of(after.energy_px2_per_s2[cause])};
  for (std::size_t second = 0; second < before.exact_px.size(); ++second)
    card.exact_px.push_back({band_of(before.exact_px[second]), band_of(after.exact_px[second])});
}

namespace {

// Where a fling is after kDuration_s, if it moved less than half a pixel in the last second.
std::optional<double> landing_x_px(const Core& core, const State& start, double rate_hz) {
  const auto seconds = [&](const State& from, double duration_s) {
    return core.steps(from, 1.0 / rate_hz, kDesktop, static_cast<std::int64_t>(duration_s * rate_hz));
  };
  const State earlier = seconds(start, static_cast<double>(kDuration_s - 1));
  const State end = seconds(earlier, 1.0);
  if (!(distance_px(earlier, end) <= RestAnchor::kStill_px)) return std::nullopt;
  return end.x_px;
}

// On each display.
using Landings = std::array<std::optional<double>, kLandingRates_hz.size()>;
Landings landings_of(const Core& core, const State& start) {
  Landings landings_px;
  std::transform(kLandingRates_hz.begin(), kLandingRates_hz.end(), landings_px.begin(),
                 [&](double rate_hz) { return landing_x_px(core, start, rate_hz); });
  return landings_px;
}

// Nothing if the fling does not settle on every display.
std::optional<double> spread_of(const Landings& landings_px) {
  const auto [least, most] = std::minmax_element(landings_px.begin(), landings_px.end());
  return *least ? std::optional(**most - **least) : std::nullopt;  // No value is less than any.
}

}  // namespace

DisplayLine measure_displays(const ComparedCores& cores, std::uint64_t seed, std::int64_t flings) {
  DisplayLine line{.flings = std::min(flings, kDisplayFlings)};
  for (std::int64_t number = 0; number < line.flings; ++number) {
    const auto [from, to] = of_both(cores, [&](const ComparedCore& core) {
      return landings_of(core.at(place_of(seed, number) + " on displays of 24 to 1000 Hz"),
                         random_fling(seed, number));
    });
    for (std::size_t display = 0; display < from.size(); ++display)
      if (from[display] && to[display])
        line.distance_max_px = std::max(line.distance_max_px, std::fabs(*to[display] - *from[display]));
    const std::optional<double> before_px = spread_of(from);
    const std::optional<double> after_px = spread_of(to);
    if (!before_px || !after_px) continue;
    line.spreads_px.before.push_back(*before_px);
    line.spreads_px.after.push_back(*after_px);
  }
  line.spread_px = {band_of(line.spreads_px.before), band_of(line.spreads_px.after)};
  return line;
}

RestLine measure_rest(const ComparedCores& cores) {
  constexpr double kHeight_px = 100.0;
  const auto moved_px = [](const Core& core, double rate_hz) {
    const auto second = static_cast<std::int64_t>(rate_hz);
    State body{0.5 * kDesktop.right_px, kDesktop.bottom_px - kHeight_px, 0.0, 0.0};
    body = core.steps(body, 1.0 / rate_hz, kDesktop, (kDuration_s - 1) * second);
    double low_px = body.y_px, high_px = body.y_px;
    for (std::int64_t step = 0; step < second; ++step) {
      body = core.step(body, 1.0 / rate_hz, kDesktop);
      low_px = std::min(low_px, body.y_px);
      high_px = std::max(high_px, body.y_px);
    }
    return high_px - low_px;
  };
  return {of_both(cores, [&](const ComparedCore& core) {
    std::vector<double> all_px;
    all_px.reserve(kLandingRates_hz.size());
    for (const double rate_hz : kLandingRates_hz)
      all_px.push_back(moved_px(core.at(fmt::format("a drop at {:.0f} Hz", rate_hz)), rate_hz));
    return all_px;
  })};
}

CostLine measure_cost(const ComparedCores& cores, std::uint64_t seed, const NanosecondClock& now_ns) {
  constexpr int kPairs = 40;
  constexpr int kFlings = 50;
  constexpr std::int64_t kSteps = 600;  // 10 s: flight, bounces and rest.
  volatile double used = 0.0;           // So that no step is left out.
  const auto sample_ns = [&](const ComparedCore& core) {
    const std::int64_t from_ns = now_ns();
    for (int number = 0; number < kFlings; ++number)
      used = core.timed.steps(random_fling(seed, number), 1.0 / kRate_hz, kDesktop, kSteps).x_px;
    return static_cast<double>(now_ns() - from_ns) / static_cast<double>(kFlings * kSteps);
  };
  std::vector<double> before_ns, after_ns, ratios;
  for (const ComparedCore* const core : {&cores.before, &cores.after}) {
    for (int number = 0; number < kFlings; ++number)  // Counted: the fling is named if the core ends.
      used = core->at(place_of(seed, number))
                 .steps(random_fling(seed, number), 1.0 / kRate_hz, kDesktop, kSteps)
                 .x_px;
    sample_ns(*core);
  }
  for (int pair = 0; pair < kPairs; ++pair) {
    const bool is_base_first = pair % 2 == 0;
    const double first_ns = sample_ns(is_base_first ? cores.before : cores.after);
    const double second_ns = sample_ns(is_base_first ? cores.after : cores.before);
    before_ns.push_back(is_base_first ? first_ns : second_ns);
    after_ns.push_back(is_base_first ? second_ns : first_ns);
    ratios.push_back(after_ns.back() / before_ns.back());
  }
  return {{*band_of(before_ns), *band_of(after_ns)}, *band_of(ratios)};
}

}  // namespace hyrax
