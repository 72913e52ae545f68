// The command study of a core that describes itself, and its frame-rate.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/compare/rate_ladder_text.h"
#include "sim/described/described_ladder.h"
#include "sim/result/display_rates.h"
#include "sim/result/number_text.h"
#include "tools/app/study/study_command.h"
#include "tools/described/commands.h"
#include "tools/described/hard_cases.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/files/failure.h"

namespace hyrax {
namespace {

// A run of a ladder, with what the columns need of it.
struct RateRow {
  const RateLadder* of = nullptr;
  const RateRun* run = nullptr;
  [[nodiscard]] double off_px() const { return run->off_px.value_or(kNotGiven); }
};

std::vector<RateRow> rows_of(const std::vector<RateLadder>& ladders) {
  std::vector<RateRow> rows;
  for (const RateLadder& each : ladders)
    for (const RateRun& run : each.runs) rows.push_back({&each, &run});
  return rows;
}

// The scenario that is farthest off at each rate.
std::vector<RateRow> worst_rows(const std::vector<RateLadder>& ladders) {
  std::vector<RateRow> worst;
  for (const RateRow& row : rows_of(ladders)) {
    const auto same =
        std::ranges::find(worst, row.run->rate_hz, [](const RateRow& each) { return each.run->rate_hz; });
    if (same == worst.end())
      worst.push_back(row);
    else if (!(row.off_px() <= same->off_px()))
      *same = row;
  }
  return worst;
}

Table rate_table(const std::vector<RateRow>& rows) {
  const auto of_run = [&rows](const std::string& name, const std::string& unit, const std::string& what,
                              auto get) {
    return column_of(name, unit, what, rows, [get](const RateRow& row) { return get(*row.run); });
  };
  return {"rates",
          fmt::format("distance from the run at {:g} Hz, at equal times", kFinestRate_hz),
          {column_of("scenario", "", "its name", rows, [](const RateRow& row) { return row.of->scenario; }),
           of_run("rate", "Hz", "frame rate", [](const RateRun& run) { return run.rate_hz; }),
           column_of("off", "px", "largest distance", rows, &RateRow::off_px),
           of_run("contacts", "1", "contacts of the run", [](const RateRun& run) { return run.contacts; }),
           of_run("at_rest_since", "s", "when the last movement of half a pixel ended",
                  [](const RateRun& run) { return run.at_rest_since_s.value_or(kNotGiven); })}};
}

std::string px_text(double px) {
  return std::isnan(px) ? "an unknown distance" : fmt::format("up to {:.3g} px", px);
}

std::string answer_of(const std::vector<RateLadder>& ladders) {
  const std::vector<RateRow> worst = worst_rows(ladders);
  const auto at = [&](double rate_hz) -> const RateRow& {
    return *std::ranges::find(worst, rate_hz, [](const RateRow& row) { return row.run->rate_hz; });
  };
  return fmt::format("From {:g} Hz, 60 Hz is {} away, 240 Hz {}.", kFinestRate_hz, px_text(at(60.0).off_px()),
                     px_text(at(240.0).off_px()));
}

Figure figure_of(const std::vector<RateLadder>& ladders) {
  constexpr std::array kTones = {Tone::blue,      Tone::orange, Tone::green,
                                 Tone::vermilion, Tone::purple, Tone::sky_blue};
  Plot plot{.x = display_rate_axis(22.0, 1100.0),
            .y = {.label = "largest distance, px (logarithmic)", .is_logarithmic = true}};
  Figure figure{.subtitle =
                    fmt::format("Largest distance from the run at {:g} Hz, at equal times", kFinestRate_hz)};
  for (std::size_t index = 0; index < std::min(ladders.size(), kTones.size()); ++index) {
    Series series{.name = ladders[index].scenario,
                  .look = {.form = Form::line_and_points, .tone = kTones[index]}};
    for (const RateRun& run : ladders[index].runs) {
      const double px = run.off_px.value_or(kNotGiven);
      series.x.push_back(run.rate_hz);
      series.y.push_back(px > 0.0 ? px : kNotGiven);
    }
    figure.legend.push_back({series.name, series.look});
    plot.series.push_back(std::move(series));
  }
  if (ladders.size() > kTones.size())
    figure.subtitle += fmt::format("; the first {} of {} scenarios", kTones.size(), ladders.size());
  figure.body = std::vector{std::move(plot)};
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

std::vector<DescribedScenario> scenarios_of(const Description& description, const StudyInput& input) {
  if (input.scenarios.empty()) return library_or_defaults(description);
  std::vector<DescribedScenario> scenarios;
  for (const std::string& path : input.scenarios)
    scenarios.push_back(load_described_scenario(description, path));
  return scenarios;
}

Result study_frame_rate(const DescribedCore& core, const StudyInput& input) {
  if (!has_px(core.description))
    refuse_input("hyrax-sim study frame-rate: no value of the core " + core.description.core +
                 " is in px; a name that ends in _px has this unit");
  std::vector<double> rates_hz(kLandingRates_hz.begin(), kLandingRates_hz.end());
  if (input.is_quick) rates_hz = {24.0, 60.0, 144.0, 240.0};
  std::vector<RateLadder> ladders;
  std::vector<std::string> left_out;
  const std::vector<DescribedScenario> scenarios = scenarios_of(core.description, input);
  for (const DescribedScenario& scenario : scenarios) {
    if (const std::string why = why_one_rate(scenario); !why.empty())
      left_out.push_back(scenario.name + ": left out, as " + why + ".");
    else
      ladders.push_back(climb(core, scenario, rates_hz, [&](const DescribedSummary& run) {
        return faults_of_run(core.description, run);
      }));
    input.report_progress("scenarios", std::ssize(ladders) + std::ssize(left_out), std::ssize(scenarios));
  }
  if (ladders.empty()) refuse_input("hyrax-sim study frame-rate: " + left_out.front());
  Verdict verdict{.answer = answer_of(ladders), .broken = broken_rules(ladders)};
  verdict.text = {"The largest distance at each rate, and the scenario that has it:",
                  rate_table(worst_rows(ladders))};
  for (const auto& notes : {notes_of(ladders), left_out})
    for (const std::string& note : notes) verdict.text.emplace_back(note);
  Result result{.tables = {rate_table(rows_of(ladders))},
                .figures = {figure_of(ladders)},
                .verdict = verdict,
                .summary = {rate_table(rows_of(ladders))}};
  result.figures.front().title = headline(verdict);
  return result;
}

}  // namespace

Command described_study_command(const DescribedCore& core) {
  const std::string needs =
      "needs the paper's step; " + core.description.core + " describes itself: use study frame-rate, diff";
  Command command =
      study_command_of({{.name = "frame-rate",
                         .summary = "how far each frame rate is from the finest, and whether it converges",
                         .takes_scenarios = true,
                         .run = [&core](const StudyInput& input) { return study_frame_rate(core, input); }},
                        {.name = "hard-cases",
                         .summary = "what must hold in every run, however hard the scenario",
                         .takes_scenarios = true,
                         .run =
                             [&core](const StudyInput& input) {
                               return study_hard_cases(core, scenarios_of(core.description, input), input);
                             }}},
                       {{"speed-error", needs}, {"needs", needs}});
  command.summary = "compare frame rates, play hard cases";
  command.example = "hyrax-sim study frame-rate --report frame-rate.html";
  return command;
}

}  // namespace hyrax
