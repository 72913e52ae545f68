// `hyrax-sim study bounces`: its tables, figure and verdict.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "sim/result/estimate.h"
#include "sim/study/bounces/bounces.h"
#include "sim/study/methods/many_flings.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

constexpr std::array<std::string_view, 3> kBounceMethodTexts = {"the paper's step", "explicit Euler",
                                                                "exact impacts"};
constexpr double kRounding = 1e-9;  // Of the energy, by exact impacts.

// All throws by one method at one rate.
struct KeptAtRate {
  BounceMethod method;
  double rate_hz;
  Band minute, ten_minutes;
  Share about_kept;  // At least half and at most twice the energy after ten minutes.
};

std::size_t index_of(BounceMethod method) { return static_cast<std::size_t>(method); }

std::vector<KeptAtRate> by_rate(const std::vector<KeptEnergy>& kept) {
  std::vector<KeptAtRate> rates;
  for (auto first = kept.begin(); first != kept.end();) {
    const auto end = std::find_if(first, kept.end(), [&](const KeptEnergy& each) {
      return each.method != first->method || each.rate_hz != first->rate_hz;
    });
    std::vector<double> minutes, ten_minutes;
    Share about_kept;
    for (const KeptEnergy& each : std::span(first, end)) {
      minutes.push_back(each.minute);
      ten_minutes.push_back(each.ten_minutes);
      about_kept.add(each.ten_minutes >= 0.5 && each.ten_minutes <= 2.0);
    }
    rates.push_back({first->method, first->rate_hz, *band_of(minutes), *band_of(ten_minutes), about_kept});
    first = end;
  }
  return rates;
}

template <class Record>
StudyTable<std::vector<Record>> energy_table(const std::string& name, const std::string& long_name,
                                             const std::vector<Record>& records) {
  StudyTable<std::vector<Record>> table(name, long_name, records);
  return table
      .add("method", "", "method", [](const Record& each) { return kBounceMethods[index_of(each.method)]; })
      .add("rate", "Hz", "display rate; 0: without frames", &Record::rate_hz);
}

Table throw_table(const std::vector<KeptEnergy>& kept) {
  return energy_table("throws", "energy of bounces without loss, in parts of that at the start", kept)
      .add("throw", "1", "number of the throw", &KeptEnergy::number)
      .add("speed", "px/s", "speed at the start", &KeptEnergy::speed_px_per_s)
      .add("minute", "1", "after a minute", &KeptEnergy::minute)
      .add("ten_minutes", "1", "after ten minutes", &KeptEnergy::ten_minutes);
}

using OneRate = const KeptAtRate&;

Table rate_table(const std::vector<KeptAtRate>& rates) {
  return energy_table("rates", "the same over all throws", rates)
      .add_band("minute", "1", "after a minute", &KeptAtRate::minute, "minute")
      .add_band("ten_minutes", "1", "after ten minutes", &KeptAtRate::ten_minutes, "ten_minutes")
      .add("about_kept", "1", "throws with half to twice their energy after ten minutes",
           [](OneRate each) { return each.about_kept.count; })
      .add("throws", "1", "played", [](OneRate each) { return each.about_kept.of; })
      .add("seed", "1", "of the throws", [](OneRate) { return kFlingSeed; });
}

Table shown_rates(const std::vector<KeptAtRate>& rates) {
  return StudyTable("rates", "", rates)
      .add("method", "", [](OneRate each) { return kBounceMethodTexts[index_of(each.method)]; })
      .add("rate,_Hz", "",
           [](OneRate each) { return each.rate_hz == 0.0 ? "-" : fmt::format("{:g}", each.rate_hz); })
      .add("after_a_minute", "", [](OneRate each) { return interval_text(each.minute, 3); })
      .add("after_ten_minutes", "", [](OneRate each) { return interval_text(each.ten_minutes, 3); })
      .add("half_to_twice", "",
           [](OneRate each) { return fmt::format("{} of {}", each.about_kept.count, each.about_kept.of); });
}

// Nothing where a method did not play at 60 Hz.
std::vector<KeptEnergy> at_60(const std::vector<KeptEnergy>& kept, BounceMethod method) {
  std::vector<KeptEnergy> throws;
  std::copy_if(kept.begin(), kept.end(), std::back_inserter(throws),
               [&](const KeptEnergy& each) { return each.method == method && each.rate_hz == 60.0; });
  return throws;
}

std::string nearer_text(const std::vector<KeptEnergy>& kept) {
  const std::vector<KeptEnergy> paper = at_60(kept, BounceMethod::paper),
                                euler = at_60(kept, BounceMethod::explicit_euler);
  Share nearer;
  for (std::size_t number = 0; number < paper.size(); ++number)
    nearer.add(std::fabs(paper[number].ten_minutes - 1.0) < std::fabs(euler[number].ten_minutes - 1.0));
  return "At 60 Hz the paper's step ends nearer to the energy at the start than explicit Euler in " +
         share_text(nearer, "throws") + ".";
}

Figure kept_figure(const std::vector<KeptEnergy>& kept) {
  Plot plot{.x = {.label = "speed of the throw, px/s", .low = 0.0},
            .y = {.label = "energy after ten minutes, in parts of that at the start", .is_logarithmic = true},
            .marks = {{.is_vertical = false, .at = 1.0, .text = "exact impacts"}}};
  Figure figure{.title = "Bounces without loss, after ten minutes",
                .subtitle = fmt::format("at 60 Hz, random throws of seed {}", kFlingSeed)};
  for (const auto& [method, tone] : {std::pair(BounceMethod::paper, Tone::vermilion),
                                     std::pair(BounceMethod::explicit_euler, Tone::blue)}) {
    Series series{.name = std::string(kBounceMethodTexts[index_of(method)]),
                  .look = {.form = Form::points, .tone = tone, .marker_size = 0.45}};
    for (const KeptEnergy& each : at_60(kept, method)) {
      series.x.push_back(each.speed_px_per_s);
      series.y.push_back(each.ten_minutes);
    }
    figure.legend.push_back({series.name, series.look});
    if (const std::optional<Band> band = band_of(series.y))
      figure.legend.back().text += fmt::format(", median {:.3f}", band->median);
    plot.series.push_back(std::move(series));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

Verdict verdict_of(const std::vector<KeptEnergy>& kept, const std::vector<KeptAtRate>& rates) {
  Verdict verdict{
      {fmt::format("bounces: what is left of the energy of {} throws that lose nothing to drag, walls "
                   "or friction\nIn parts of the energy at the start, median (10 .. 90 %), seed {}:",
                   rates.front().about_kept.of, kFlingSeed),
       shown_rates(rates), nearer_text(kept)},
      {}};
  for (const KeptEnergy& each : kept) {
    if (each.method != BounceMethod::exact) continue;
    for (const double part : {each.minute, each.ten_minutes})
      if (!(std::fabs(part - 1.0) <= kRounding))
        verdict.broken.push_back(
            fmt::format("exact impacts: throw {} changes its energy by {:.3g} of it, more than {:g}",
                        each.number, part - 1.0, kRounding));
  }
  return verdict;
}

Result run_bounces(const StudyRequest& request) {
  return bounces_result(kept_energies(request.core, request.is_quick ? 100 : 1'000));
}

}  // namespace

Result bounces_result(const std::vector<KeptEnergy>& kept) {
  const std::vector<KeptAtRate> rates = by_rate(kept);
  return {.tables = {throw_table(kept), rate_table(rates)},
          .figures = {kept_figure(kept)},
          .verdict = verdict_of(kept, rates),
          .summary = {rate_table(rates)}};
}

Study bounces_study() {
  return {.name = "bounces",
          .summary = "what a step's order alone does to the energy of ten minutes of bounces",
          .run = run_bounces};
}

}  // namespace hyrax
