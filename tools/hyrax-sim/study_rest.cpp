#include "tools/hyrax-sim/study_rest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/study/rest/rest_map.h"
#include "tools/report/rest_figures.h"

namespace hyrax {
namespace {

// The rates of displays that people have.
constexpr std::array<double, 7> kDisplays_hz = {24.0, 30.0, 60.0, 75.0, 120.0, 144.0, 240.0};

struct RestStudy {
  std::vector<RestBoundary> boundaries;
  std::vector<RateEnds> map;
  std::vector<BounceSeen> bounces;
};

// Those, and as many between 20 and 1000 Hz, evenly on a logarithmic scale.
std::vector<double> rates_hz(int count) {
  std::vector<double> rates_hz(kDisplays_hz.begin(), kDisplays_hz.end());
  for (int rate = 0; rate < count; ++rate) rates_hz.push_back(20.0 * std::pow(50.0, rate / (count - 1.0)));
  std::sort(rates_hz.begin(), rates_hz.end());
  return rates_hz;
}

RestStudy study(bool is_quick) {
  RestStudy rest{.boundaries = rest_boundaries(),
                 .map = is_quick ? rest_map(rates_hz(40), 20) : rest_map(rates_hz(160), 100),
                 .bounces = {}};
  for (const double rate_hz : {24.0, 30.0, 60.0, 120.0, 144.0, 240.0, 1000.0})
    for (const BounceSeen& seen : bounces_at(rate_hz, is_quick ? 20 : 100)) rest.bounces.push_back(seen);
  return rest;
}

std::string boundary_line(const RestBoundary& boundary) {
  return fmt::format("  {:<26} {:>12.6f} {:>12}  {}\n", boundary.name, boundary.analytic_hz,
                     boundary.measured_hz ? fmt::format("{:.6f}", *boundary.measured_hz) : "none",
                     boundary.agrees() ? "agrees" : "OFF ITS PLACE");
}

std::string ends_line(const RateEnds& ends) {
  double all = 0.0;
  for (const std::int64_t count : ends.flings) all += static_cast<double>(count);
  const auto part = [&](FinalState state) {
    return 100.0 * static_cast<double>(ends.flings[static_cast<std::size_t>(state)]) / all;
  };
  return fmt::format("  {:>8.0f} Hz  {:>5.0f} %  {:>5.0f} %  {:>5.0f} %   {:>5.2f} s ({:.2f} .. {:.2f})\n",
                     ends.rate_hz, part(FinalState::rest), part(FinalState::cycle), part(FinalState::buzz),
                     ends.time_median_s, ends.time_low_s, ends.time_high_s);
}

std::string restitution_line(const std::vector<BounceSeen>& bounces, double rate_hz) {
  double least = 1e300, most = -1e300, sum = 0.0;
  std::int64_t count = 0;
  for (const BounceSeen& seen : bounces) {
    if (seen.rate_hz != rate_hz) continue;
    least = std::min(least, seen.restitution);
    most = std::max(most, seen.restitution);
    sum += seen.restitution;
    ++count;
  }
  if (count == 0) return "";
  return fmt::format("  {:>8.0f} Hz  {:.4f} on average, {:.4f} .. {:.4f} by the phase of the contact\n",
                     rate_hz, sum / static_cast<double>(count), least, most);
}

std::string verdict_text(const RestStudy& rest) {
  std::string text = fmt::format("rest: how a sprite ends on the floor, {} display rates\n", rest.map.size());
  text += fmt::format("  {:<26} {:>12} {:>12}\n", "boundary", "analytic Hz", "measured Hz");
  for (const RestBoundary& boundary : rest.boundaries) text += boundary_line(boundary);
  text += "  display        rest    cycle     buzz   settles after (first .. last decile)\n";
  for (const RateEnds& ends : rest.map)
    if (std::find(kDisplays_hz.begin(), kDisplays_hz.end(), ends.rate_hz) != kDisplays_hz.end())
      text += ends_line(ends);
  text += "  effective restitution of a bounce\n";
  for (const double rate_hz : {30.0, 60.0, 120.0, 240.0}) text += restitution_line(rest.bounces, rate_hz);
  return text;
}

std::vector<std::string> broken_sentences(const RestStudy& rest) {
  std::vector<std::string> broken;
  for (const RestBoundary& boundary : rest.boundaries)
    if (!boundary.agrees())
      broken.push_back(
          fmt::format("{}: analytic {:.9g} Hz, measured {}", boundary.name, boundary.analytic_hz,
                      boundary.measured_hz ? fmt::format("{:.9g} Hz", *boundary.measured_hz) : "none"));
  for (const RateEnds& ends : rest.map)
    if (ends.unforeseen > 0)
      broken.push_back(fmt::format("{:.6g} Hz: {} flings end in a way that the boundaries do not allow",
                                   ends.rate_hz, ends.unforeseen));
  return broken;
}

Json::Object json_of(const RestStudy& rest) {
  Json::Array boundaries, rates;
  for (const RestBoundary& boundary : rest.boundaries)
    boundaries.push_back(
        Json::Object{{"boundary", boundary.name},
                     {"analytic_hz", boundary.analytic_hz},
                     {"measured_hz", boundary.measured_hz ? Json(*boundary.measured_hz) : Json()},
                     {"agrees", boundary.agrees()}});
  for (const RateEnds& ends : rest.map) {
    Json::Object entry{{"rate_hz", ends.rate_hz}};
    for (std::size_t state = 0; state < kFinalStateNames.size(); ++state)
      entry.push_back({std::string(kFinalStateNames[state]), ends.flings[state]});
    entry.push_back({"time_median_s", ends.time_median_s});
    rates.push_back(std::move(entry));
  }
  return {{"boundaries", std::move(boundaries)}, {"rates", std::move(rates)}};
}

}  // namespace

StudyOutcome make_rest(const StudyRequest& request) {
  const RestStudy rest = study(request.is_quick);
  return {
      .tables = {rest_map_table(rest.map), rest_boundary_table(rest.boundaries), bounce_table(rest.bounces)},
      .figures = {{"", rest_map_script(rest.map, rest.boundaries)},
                  {"-time", rest_time_script(rest.map)},
                  {"-restitution", bounce_script(rest.bounces)}},
      .verdict = verdict_text(rest),
      .broken = broken_sentences(rest),
      .json = json_of(rest)};
}

}  // namespace hyrax
