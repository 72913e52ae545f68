// `hyrax-sim study rest`: its tables, figures and verdict.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sim/study/methods/many_flings.h"
#include "sim/study/rest/rest_map.h"
#include "sim/study/study.h"

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
  const auto flings = [&](FinalState state, const std::string& what) {
    return column_of(std::string(kFinalStateNames[static_cast<std::size_t>(state)]), "1",
                     "flings that " + what, map, [state](const RateEnds& ends) { return ends.count(state); });
  };
  const auto time = [&](const std::string& name, const std::string& what, double Band::*part) {
    return column_of(name, "s", what, map, [part](const RateEnds& ends) {
      return ends.settles_s ? *ends.settles_s.*part : kNotGiven;
    });
  };
  return {"final_states",
          "how random flings end, by display rate",
          {column_of("rate", "Hz", "display rate", map, &RateEnds::rate_hz),
           column_of("gain", "px/s", "speed that one step of gravity adds, after drag", map,
                     &RateEnds::gain_px_per_s),
           flings(FinalState::zero_speed, "end at zero speed: vy exactly 0"),
           flings(FinalState::two_cycle, "end in the two-cycle: vy 0 in every other row"),
           flings(FinalState::residual_speed, "end at the residual speed: vy constant"),
           flings(FinalState::moving, "still move"),
           column_of("unforeseen", "1", "flings in a final state that the boundaries do not allow", map,
                     &RateEnds::unforeseen),
           time("time_low", "time to settle, 10 %", &Band::low),
           time("time_median", "time to settle, median", &Band::median),
           time("time_high", "time to settle, 90 %", &Band::high),
           column_of("seed", "1", "of the flings", map, [](const RateEnds&) { return kFlingSeed; })}};
}

Column analytic_column(const std::vector<RestBoundary>& boundaries) {
  return column_of("analytic", "Hz", "derived from the constants", boundaries, &RestBoundary::analytic_hz, 9);
}
Column measured_column(const std::vector<RestBoundary>& boundaries) {
  const auto measured_hz = [](const RestBoundary& boundary) {
    return boundary.measured_hz.value_or(kNotGiven);
  };
  return column_of("measured", "Hz", "found on the core by bisection", boundaries, measured_hz, 9);
}
Table boundary_table(const std::vector<RestBoundary>& boundaries) {
  return {"boundaries",
          "display rates at which the possible final states change",
          {column_of("boundary", "", "what changes", boundaries, &RestBoundary::name),
           analytic_column(boundaries), measured_column(boundaries)}};
}

Table bounce_table(const std::vector<DropBounce>& bounces) {
  return {"bounces",
          "effective restitution of the first bounce of a drop",
          {column_of("rate", "Hz", "display rate", bounces, &DropBounce::rate_hz),
           column_of("phase", "1", "part of the contact's step below the floor", bounces, &DropBounce::phase),
           column_of("restitution", "1", "speed after the contact over the speed of the exact impact",
                     bounces, &DropBounce::restitution)}};
}

// The members of the JSON document.
std::vector<Table> summary_of(const RestResults& results) {
  Table boundaries = boundary_table(results.boundaries);
  boundaries.columns.push_back(column_of("agrees", "", "", results.boundaries, &RestBoundary::agrees));
  Table rates = map_table(results.map);
  rates.name = "rates";
  std::erase_if(rates.columns, [](const Column& column) {
    return column.name == "gain" || column.name == "unforeseen" || column.name == "time_low" ||
           column.name == "time_high" || column.name == "seed";
  });
  return {std::move(boundaries), std::move(rates)};
}

Table shown_boundaries(const std::vector<RestBoundary>& boundaries) {
  return {"boundaries",
          "",
          {column_of("boundary", "", "", boundaries, &RestBoundary::text), analytic_column(boundaries),
           measured_column(boundaries), column_of("", "", "", boundaries, [](const RestBoundary& boundary) {
             return boundary.agrees() ? "agrees" : "differs";
           })}};
}

Table shown_displays(const std::vector<RateEnds>& map) {
  std::vector<RateEnds> shown;
  std::copy_if(map.begin(), map.end(), std::back_inserter(shown), [](const RateEnds& ends) {
    return std::find(kDisplays_hz.begin(), kDisplays_hz.end(), ends.rate_hz) != kDisplays_hz.end();
  });
  Table table{"displays", "", {column_of("display", "Hz", "", shown, &RateEnds::rate_hz)}};
  for (const FinalState state : {FinalState::zero_speed, FinalState::two_cycle, FinalState::residual_speed})
    table.columns.push_back(
        column_of(std::string(text_of(state)) + ",_%", "", "", shown, [state](const RateEnds& ends) {
          const Share share = ends.share(state);
          return fmt::format("{:.0f} ({:.0f} .. {:.0f})", ends.percent(state), 100.0 * share.low(),
                             100.0 * share.high());
        }));
  table.columns.push_back(column_of("settles_after,_s", "", "", shown, [](const RateEnds& ends) {
    if (!ends.settles_s) return std::string("-");
    return fmt::format("{:.2f} ({:.2f} .. {:.2f})", ends.settles_s->median, ends.settles_s->low,
                       ends.settles_s->high);
  }));
  return table;
}

// The effective restitution at some rates: mean and range over the phases.
Table shown_bounces(const std::vector<DropBounce>& bounces) {
  std::vector<double> rates_hz, means, lows, highs;
  for (const double rate_hz : {30.0, 60.0, 120.0, 240.0}) {
    std::vector<double> values;
    for (const DropBounce& bounce : bounces)
      if (bounce.rate_hz == rate_hz) values.push_back(bounce.restitution);
    if (values.empty()) continue;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double sum = 0.0;
    for (const double value : values) sum += value;
    rates_hz.push_back(rate_hz);
    means.push_back(sum / static_cast<double>(values.size()));
    lows.push_back(*low);
    highs.push_back(*high);
  }
  return {"restitution",
          "",
          {{"display", "Hz", "", std::move(rates_hz)},
           {"effective_restitution", "1", "", std::move(means)},
           {"least", "1", "", std::move(lows)},
           {"most", "1", "", std::move(highs)}}};
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
