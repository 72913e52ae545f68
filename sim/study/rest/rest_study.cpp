// `hyrax-sim study rest`: its tables, figures and verdict.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "sim/study/methods/many_flings.h"
#include "sim/study/rest/rest_map.h"
#include "sim/study/study.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

// The rates of displays that people have.
constexpr std::array<double, 7> kDisplays_hz = {24.0, 30.0, 60.0, 75.0, 120.0, 144.0, 240.0};

// The displays' rates, and `count` more from 20 to 1000 Hz, evenly on a logarithmic scale.
std::vector<double> rates_hz(int count) {
  std::vector<double> rates_hz(kDisplays_hz.begin(), kDisplays_hz.end());
  for (int rate = 0; rate < count; ++rate) rates_hz.push_back(20.0 * std::pow(50.0, rate / (count - 1.0)));
  std::sort(rates_hz.begin(), rates_hz.end());
  return rates_hz;
}

RestResults measure(const Core& core, bool is_quick) {
  RestResults results{.boundaries = rest_boundaries(core),
                      .map = rest_map(core, rates_hz(is_quick ? 25 : 160), is_quick ? 100 : 200),
                      .bounces = {}};
  for (const double rate_hz : {24.0, 30.0, 60.0, 120.0, 144.0, 240.0, 1000.0})
    for (const DropBounce& bounce : bounces_at(core, rate_hz, is_quick ? 20 : 100))
      results.bounces.push_back(bounce);
  return results;
}

Table map_table(const std::vector<RateEnds>& map) {
  StudyTable table("final_states", "how random flings end, by display rate", map);
  table.add("rate", "Hz", "display rate", &RateEnds::rate_hz)
      .add("gain", "px/s", "speed that one step of gravity adds, after drag", &RateEnds::gain_px_per_s);
  for (const auto& [state, what] :
       {std::pair(FinalState::zero_speed, "flings that end at zero speed: vy exactly 0"),
        {FinalState::two_cycle, "flings that end in the two-cycle: vy 0 in every other row"},
        {FinalState::residual_speed, "flings that end at the residual speed: vy constant"},
        {FinalState::moving, "flings that still move"}})
    table.add(std::string(kFinalStateNames[static_cast<std::size_t>(state)]), "1", what,
              [state = state](const RateEnds& ends) { return ends.count(state); });
  table.add("unforeseen", "1", "flings in a final state that the boundaries do not allow",
            &RateEnds::unforeseen);
  for (const auto& [name, what, part] : {std::tuple("time_low", "time to settle, 10 %", &Band::low),
                                         {"time_median", "time to settle, median", &Band::median},
                                         {"time_high", "time to settle, 90 %", &Band::high}})
    table.add(name, "s", what, [part = part](const RateEnds& ends) {
      return ends.settles_s ? *ends.settles_s.*part : kNotGiven;
    });
  return table.add("seed", "1", "of the flings", [](const RateEnds&) { return kFlingSeed; });
}

using BoundaryTable = StudyTable<std::vector<RestBoundary>>;

BoundaryTable& add_rates(BoundaryTable& table) {
  return table.add("analytic", "Hz", "derived from the constants", &RestBoundary::analytic_hz, 9)
      .add(
          "measured", "Hz", "found on the core by bisection",
          [](const RestBoundary& boundary) { return boundary.measured_hz.value_or(kNotGiven); }, 9);
}

BoundaryTable boundary_table(const std::vector<RestBoundary>& boundaries) {
  BoundaryTable table("boundaries", "display rates at which the possible final states change", boundaries);
  return add_rates(table.add("boundary", "", "what changes", &RestBoundary::name));
}

Table bounce_table(const std::vector<DropBounce>& bounces) {
  return StudyTable("bounces", "effective restitution of the first bounce of a drop", bounces)
      .add("rate", "Hz", "display rate", &DropBounce::rate_hz)
      .add("phase", "1", "part of the contact's step below the floor", &DropBounce::phase)
      .add("restitution", "1", "speed after the contact over the speed of the exact impact",
           &DropBounce::restitution);
}

// The members of the JSON document.
std::vector<Table> summary_of(const RestResults& results) {
  Table rates = map_table(results.map);
  rates.name = "rates";
  std::erase_if(rates.columns, [](const Column& column) {
    return column.name == "gain" || column.name == "unforeseen" || column.name == "time_low" ||
           column.name == "time_high" || column.name == "seed";
  });
  return {boundary_table(results.boundaries).add("agrees", "", &RestBoundary::agrees), std::move(rates)};
}

Table shown_boundaries(const std::vector<RestBoundary>& boundaries) {
  BoundaryTable table("boundaries", "", boundaries);
  return add_rates(table.add("boundary", "", &RestBoundary::text)).add("", "", [](const RestBoundary& each) {
    return each.agrees() ? "agrees" : "differs";
  });
}

Table shown_displays(const std::vector<RateEnds>& map) {
  std::vector<RateEnds> shown;
  std::copy_if(map.begin(), map.end(), std::back_inserter(shown), [](const RateEnds& ends) {
    return std::find(kDisplays_hz.begin(), kDisplays_hz.end(), ends.rate_hz) != kDisplays_hz.end();
  });
  StudyTable table("displays", "", shown);
  table.add("display", "Hz", &RateEnds::rate_hz);
  for (const FinalState state : {FinalState::zero_speed, FinalState::two_cycle, FinalState::residual_speed})
    table.add(std::string(text_of(state)) + ",_%", "", [state](const RateEnds& ends) {
      const Share share = ends.share(state);
      return interval_text(ends.percent(state), 100.0 * share.low(), 100.0 * share.high());
    });
  return table.add("settles_after,_s", "", [](const RateEnds& ends) {
    return ends.settles_s ? interval_text(*ends.settles_s, 2) : "-";
  });
}

// The effective restitution at some rates: mean and range over the phases.
Table shown_bounces(const std::vector<DropBounce>& bounces) {
  struct AtRate {
    double rate_hz, mean, least, most;
  };
  std::vector<AtRate> rates;
  for (const double rate_hz : {30.0, 60.0, 120.0, 240.0}) {
    std::vector<double> values;
    for (const DropBounce& bounce : bounces)
      if (bounce.rate_hz == rate_hz) values.push_back(bounce.restitution);
    if (values.empty()) continue;
    const auto [least, most] = std::ranges::minmax(values);
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    rates.push_back({rate_hz, sum / static_cast<double>(values.size()), least, most});
  }
  return StudyTable("restitution", "", rates)
      .add("display", "Hz", &AtRate::rate_hz)
      .add("effective_restitution", "1", &AtRate::mean)
      .add("least", "1", &AtRate::least)
      .add("most", "1", &AtRate::most);
}

std::string stillness_text(const std::vector<RateEnds>& map) {
  std::int64_t all = 0, moving = 0;
  for (const RateEnds& ends : map) {
    all += ends.total();
    moving += ends.count(FinalState::moving);
  }
  if (moving > 0) return fmt::format("{} of {} flings still move after {:g} s.", moving, all, kRestPlayed_s);
  return fmt::format(
      "The position stands still in the end of all {} flings; only vy differs.\nSo judge rest by position, "
      "never by vy.",
      all);
}

Result run_rest(const StudyRequest& request) {
  const RestResults results = measure(request.core, request.is_quick);
  return {
      .tables = {map_table(results.map), boundary_table(results.boundaries), bounce_table(results.bounces)},
      .figures = rest_figures(request.core, results),
      .verdict = rest_verdict(results),
      .summary = summary_of(results)};
}

}  // namespace

Verdict rest_verdict(const RestResults& results) {
  Verdict verdict{
      {fmt::format("rest: how a fling ends on the floor, at {} display rates", results.map.size()),
       stillness_text(results.map), shown_boundaries(results.boundaries),
       fmt::format(
           "{} random flings at each rate, seed {}: share with its 95 % interval; time, median (10 .. 90 %)",
           results.map.empty() ? 0 : results.map.front().total(), kFlingSeed),
       shown_displays(results.map),
       "First bounce of a drop, over the phases of its contact:", shown_bounces(results.bounces)},
      {}};
  for (const RestBoundary& boundary : results.boundaries)
    if (!boundary.agrees())
      verdict.broken.push_back(
          fmt::format("{}: analytic {:.9g} Hz, measured {}", boundary.text, boundary.analytic_hz,
                      boundary.measured_hz ? fmt::format("{:.9g} Hz", *boundary.measured_hz) : "none"));
  for (const RateEnds& ends : results.map) {
    if (const std::int64_t moving = ends.count(FinalState::moving); moving > 0)
      verdict.broken.push_back(
          fmt::format("{:.6g} Hz: {} flings still move after {:g} s", ends.rate_hz, moving, kRestPlayed_s));
    if (ends.unforeseen > 0)
      verdict.broken.push_back(
          fmt::format("{:.6g} Hz: {} flings end in a way that the boundaries do not allow", ends.rate_hz,
                      ends.unforeseen));
  }
  return verdict;
}

Study rest_study() {
  return {
      .name = "rest", .summary = "how a sprite ends on the floor, at every display rate", .run = run_rest};
}

}  // namespace hyrax
