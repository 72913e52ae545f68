#include "sim/study/frame_rate/ladder_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/result/number_text.h"

namespace hyrax {
namespace {

// A run of a ladder, with what the columns need of it.
struct RateRow {
  const RateLadder* of = nullptr;
  const RateRun* run = nullptr;
  [[nodiscard]] double own_px() const { return run->own_px.value_or(kNotGiven); }
  [[nodiscard]] double off_px() const { return run->off_px.value_or(kNotGiven); }
};
using Distance = double (RateRow::*)() const;

std::vector<RateRow> rows_of(const std::vector<RateLadder>& ladders) {
  std::vector<RateRow> rows;
  for (const RateLadder& each : ladders)
    for (const RateRun& run : each.runs) rows.push_back({&each, &run});
  return rows;
}

// "first converges: from 125 to 250 Hz it changes by up to 8.1 px, from 1000 to 2000 Hz by up to 1 px; each
// ..."
std::string convergence_text(const RateLadder& ladder) {
  const std::vector<double>& px = ladder.doubling_px;
  if (!std::ranges::all_of(px, [](double each) { return std::isfinite(each); }))
    return ladder.scenario + ": whether it converges is not known, as a run ends early.";
  if (px.front() == 0.0 && px.back() == 0.0)
    return ladder.scenario + " is the same at every rate from 125 Hz on.";
  std::string text = fmt::format(
      "{} {}: from {:g} to {:g} Hz it changes by up to {} px, from {:g} to {:g} Hz by up to {} px",
      ladder.scenario,
      ladder.converges()      ? "converges"
      : ladder.is_undecided() ? "may converge, which these rates do not decide"
                              : "does not converge",
      kDoubledRates_hz.front(), 2.0 * kDoubledRates_hz.front(), rounded(px.front(), 3),
      kDoubledRates_hz.back(), kFinestRate_hz, rounded(px.back(), 3));
  const double gain = ladder.gain();
  if (ladder.converges() && std::isfinite(gain))
    text += fmt::format("; each doubling of the rate {:.2g} times less than the one before", gain);
  return text + ".";
}

// The scenario that is farthest off at each rate.
std::vector<RateRow> worst_rows(const std::vector<RateLadder>& ladders, Distance distance_px) {
  std::vector<RateRow> worst;
  for (const RateRow& row : rows_of(ladders)) {
    const auto same =
        std::ranges::find(worst, row.run->rate_hz, [](const RateRow& each) { return each.run->rate_hz; });
    if (same == worst.end())
      worst.push_back(row);
    else if (!((row.*distance_px)() <= ((*same).*distance_px)()))
      *same = row;
  }
  return worst;
}

Table rate_table(const std::vector<RateRow>& rows) {
  const auto of_run = [&rows](const std::string& name, const std::string& unit, const std::string& what,
                              auto get) {
    return column_of(name, unit, what, rows, [get](const RateRow& row) { return get(*row.run); });
  };
  return {
      "rates",
      fmt::format("distances at equal times from the scenario's own run and from the run at {:g} Hz",
                  kFinestRate_hz),
      {column_of("scenario", "", "its name", rows, [](const RateRow& row) { return row.of->scenario; }),
       of_run("rate", "Hz", "frame rate", [](const RateRun& run) { return run.rate_hz; }),
       column_of("from_own", "px", "largest distance from the run by its own clock", rows, &RateRow::own_px),
       column_of("off", "px", fmt::format("largest distance from the run at {:g} Hz", kFinestRate_hz), rows,
                 &RateRow::off_px),
       of_run("contacts", "1", "contacts of the run", [](const RateRun& run) { return run.contacts; }),
       of_run("at_rest_since", "s", "when the last movement of half a pixel ended",
              [](const RateRun& run) { return run.at_rest_since_s.value_or(kNotGiven); })}};
}

std::string px_text(double px) {
  return std::isnan(px) ? "an unknown distance" : "up to " + rounded(px, 3) + " px";
}

// "A, 60 Hz is up to 3 px away, 240 Hz up to 1 px."
std::string distances_text(const std::string& from, const std::vector<RateLadder>& ladders,
                           Distance distance_px, double slow_hz) {
  const std::vector<RateRow> worst = worst_rows(ladders, distance_px);
  const auto at = [&](double rate_hz) {
    const auto row = std::ranges::find(worst, rate_hz, [](const RateRow& each) { return each.run->rate_hz; });
    return px_text(((*row).*distance_px)());
  };
  return fmt::format("From {}, {:g} Hz is {} away, 240 Hz {}.", from, slow_hz, at(slow_hz), at(240.0));
}

Figure figure_of(const std::vector<RateLadder>& ladders) {
  constexpr std::array kTones = {Tone::blue,      Tone::orange, Tone::green,
                                 Tone::vermilion, Tone::purple, Tone::sky_blue};
  const std::size_t shown = std::min(ladders.size(), kTones.size());
  Figure figure{.subtitle = "Largest distances at equal times"};
  if (shown < ladders.size())
    figure.subtitle += fmt::format("; the first {} of {} scenarios", shown, ladders.size());
  std::vector<Plot> plots;
  bool has_gap = false;
  for (const auto& [from, px_of] : {std::pair(std::string("its own clock"), &RateRun::own_px),
                                    {fmt::format("{:g} Hz", kFinestRate_hz), &RateRun::off_px}}) {
    Plot plot{.x = display_rate_axis(22.0, 1100.0),
              .y = {.label = "px from the run at " + from + " (logarithmic)", .is_logarithmic = true}};
    for (std::size_t index = 0; index < shown; ++index) {
      Series series{.name = ladders[index].scenario,
                    .look = {.form = Form::line_and_points, .tone = kTones[index]}};
      for (const RateRun& run : ladders[index].runs) {
        if (run.rate_hz == kFinestRate_hz) continue;
        const double px = (run.*px_of).value_or(kNotGiven);
        has_gap = has_gap || !(px > 0.0);
        series.x.push_back(run.rate_hz);
        series.y.push_back(px > 0.0 ? px : kNotGiven);
      }
      if (plots.empty()) figure.legend.push_back({series.name, series.look});
      plot.series.push_back(std::move(series));
    }
    plots.push_back(std::move(plot));
  }
  if (has_gap) figure.remarks.emplace_back("At a gap the distance is 0, or not known.");
  figure.body = std::move(plots);
  return figure;
}

std::vector<std::string> broken_rules(const std::vector<RateLadder>& ladders) {
  std::vector<std::string> broken;
  for (const RateRow& row : rows_of(ladders))
    for (const std::string& fault : row.run->faults)
      broken.push_back(fmt::format("{} at {:g} Hz: {}", row.of->scenario, row.run->rate_hz, fault));
  return broken;
}

std::vector<std::string> notes_of(const std::vector<RateLadder>& ladders) {
  std::vector<std::string> notes;
  for (const RateLadder& each : ladders) {
    notes.push_back(convergence_text(each));
    if (each.is_cut)
      notes.push_back(fmt::format("{}: its first {:.3g} s only.", each.scenario, each.until_s));
    if (each.has_hitches)
      notes.push_back(each.scenario + ": without its hitches, which belong to its own frames.");
  }
  return notes;
}

}  // namespace

Result ladder_result(const std::vector<RateLadder>& ladders, const std::vector<std::string>& left_out) {
  const std::string own = ladders.size() == 1 ? "the run at its own clock" : "runs at their own clocks";
  Verdict verdict{.answer = distances_text(own, ladders, &RateRow::own_px, 144.0),
                  .broken = broken_rules(ladders)};
  verdict.text = {"The largest distance at each rate, and the scenario that has it:",
                  rate_table(worst_rows(ladders, &RateRow::own_px)),
                  distances_text(fmt::format("{:g} Hz", kFinestRate_hz), ladders, &RateRow::off_px, 60.0)};
  for (const auto& notes : {notes_of(ladders), left_out})
    for (const std::string& note : notes) verdict.text.emplace_back(note);
  Result result{.tables = {rate_table(rows_of(ladders))},
                .figures = {figure_of(ladders)},
                .verdict = verdict,
                .summary = {rate_table(rows_of(ladders))}};
  result.figures.front().title = headline(verdict);
  return result;
}

}  // namespace hyrax
