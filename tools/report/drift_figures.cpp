#include "tools/report/drift_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "sim/reference/energy_causes.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "tools/report/look.h"

namespace hyrax {
namespace {

constexpr std::size_t kArcsMarkedMax = 80;
constexpr std::array<std::string_view, 5> kSuffixes = {"-whole", "-energy", "-errors", "-restitution",
                                                       "-drift-causes"};

Tone tone_of(Wall wall) { return kWallTones[wall_index(wall)]; }

std::string note_of(const DriftRun& run) {
  if (run.arcs.empty()) return "";
  const DriftSummary& summary = run.summary;
  if (summary.arcs > static_cast<std::int64_t>(run.arcs.size()))
    return fmt::format("the first {} of {} arcs", run.arcs.size(), summary.arcs);
  return plain_counted(summary.arcs, "arc") + ", " + plain_counted(summary.contacts, "contact");
}

Figure figure_of(const DriftRun& run, std::string_view suffix, std::string subtitle) {
  return {.suffix = std::string(suffix),
          .title = run.scenario.name,
          .subtitle = std::move(subtitle),
          .note = note_of(run),
          .note_tone = Tone::quiet};
}

// The wall's dots, by its name.
LegendEntry wall_entry(Wall wall) {
  return {std::string(name_of(wall)), {.form = Form::points, .tone = tone_of(wall)}};
}

// A line at each input but where a hand leads the sprite, with its name.
void mark_inputs(Plot& plot, const DriftRun& run) {
  constexpr std::size_t kInputsMarkedMax = 12;
  const Scenario& scenario = run.scenario;
  if (scenario.events.empty()) return;
  const std::vector<std::int64_t> frames = schedule_events(scenario, step_count(scenario)).frames;
  for (std::size_t i = 0; i < frames.size() && plot.marks.size() < kInputsMarkedMax; ++i) {
    if (std::holds_alternative<Place>(scenario.events[i].action)) continue;
    const auto row = std::ranges::lower_bound(run.rows, frames[i], {},
                                              [](const DrawnRow& drawn) { return drawn.errors.step; });
    if (row != run.rows.end())
      plot.marks.push_back({.at = row->errors.t_s,
                            .text = std::string(name_of(scenario.events[i].action)),
                            .tone = Tone::quiet});
  }
}

// Every other arc is shaded, and has a dot at the top for the wall that ended it. Neither if there are too
// many arcs to distinguish.
void mark_arcs(Figure& figure, Plot& plot, const DriftRun& run) {
  const std::vector<ArcErrors>& arcs = run.arcs;
  if (arcs.size() > kArcsMarkedMax) return;
  std::size_t row = 0;
  std::array<bool, kWalls.size()> has_wall{};
  for (std::size_t arc = 0; arc < arcs.size() && row < run.rows.size(); ++arc) {
    const double from_s = run.rows[row].errors.t_s;
    while (row < run.rows.size() && run.rows[row].arc == arc) ++row;
    const double to_s = run.rows[row - (row > 0)].errors.t_s;
    if (arc % 2 == 1) plot.spans.push_back({from_s, to_s});
    const auto wall = wall_of(arcs[arc].ended_by);
    if (!wall) continue;
    has_wall[wall_index(*wall)] = true;
    plot.top_dots.push_back({to_s, tone_of(*wall)});
  }
  if (arcs.size() > 1)
    figure.legend.push_back({"every other arc", {.form = Form::band, .tone = Tone::shade}});
  for (const Wall wall : kWalls)
    if (has_wall[wall_index(wall)]) figure.legend.push_back(wall_entry(wall));
}

// A series of one value a row against time, with a gap between arcs. Without a value: NaN.
template <class Value>
Series series_of(const DriftRun& run, std::string name, const Look& look, const Value& value) {
  Series series{.name = std::move(name), .look = look};
  std::size_t arc = 0;
  for (const DrawnRow& row : run.rows) {
    if (row.arc >= run.arcs.size()) break;
    if (row.arc != arc) {
      series.x.push_back(row.errors.t_s);
      series.y.push_back(kNotGiven);
    }
    arc = row.arc;
    series.x.push_back(row.errors.t_s);
    series.y.push_back(value(row.errors, run.arcs[arc]));
  }
  return series;
}

// A plot against time from 0 to the end of the last arc.
Plot plot_over_time(const DriftRun& run, Axis y) {
  const double end_s = run.rows.empty() ? 1.0 : run.rows.back().errors.t_s;
  return {.x = {.label = "time, s", .low = 0.0, .high = end_s > 0.0 ? end_s : 1.0},
          .y = std::move(y),
          .when_empty = "no flight of two steps or more"};
}

// The walls' dots are at the top of the first plot only.
// @param value_text of a series with data, in the legend after its name.
Figure over_time(Figure figure, std::vector<Plot> plots, const DriftRun& run,
                 std::string (*value_text)(const Series&) = nullptr) {
  for (const Plot& plot : plots)
    for (const Series& series : plot.series)
      figure.legend.push_back(
          {series.name + (value_text && !series.y.empty() ? value_text(series) : ""), series.look});
  mark_arcs(figure, plots.front(), run);
  for (Plot& plot : plots) {
    plot.spans = plots.front().spans;
    mark_inputs(plot, run);
  }
  figure.body = std::move(plots);
  return figure;
}

Figure whole_figure(const DriftRun& run) {
  Plot plot = plot_over_time(run, {.label = "distance, px", .low = 0.0});
  plot.x.high = run.simulated_s > 0.0 ? run.simulated_s : 1.0;
  plot.when_empty = "no exact fling";
  std::string subtitle = "The whole run: distance from the exact fling, which has the same inputs";
  Series series{.name = "distance from the exact fling", .look = {.tone = Tone::blue, .width_px = 2}};
  for (const WholeRow& row : run.whole_rows) {
    series.x.push_back(row.t_s);
    series.y.push_back(row.distance_px);
  }
  if (const auto& whole = run.whole.run; whole && !series.x.empty()) {
    series.x.push_back(run.simulated_s);
    series.y.push_back(whole->end_px);
    subtitle += fmt::format("; at the end {} px, {} px of height", rounded(whole->end_px, 3),
                            rounded(whole->energy_end_px, 3));
  } else {
    series = {.name = series.name, .look = series.look};
    plot.when_empty += ": " + run.whole.why_not;
  }
  plot.series = {std::move(series)};
  return over_time(figure_of(run, kSuffixes[0], subtitle), {std::move(plot)}, run);
}

double run_energy(const RowErrors& row) { return row.energy_px2_per_s2 + row.energy_drift_px2_per_s2; }

Figure energy_figure(const DriftRun& run) {
  double least = HUGE_VAL, most = 0.0;
  for (const DrawnRow& row : run.rows)
    for (const double energy : {row.errors.energy_px2_per_s2, run_energy(row.errors)}) {
      least = std::min(least, energy);
      if (std::isfinite(energy)) most = std::max(most, std::fabs(energy));
    }
  // Thousands, millions, ... that leave one to three digits before the point.
  const int exponent = most >= 1e3 ? 3 * static_cast<int>(std::log10(most) / 3.0) : 0;
  const double scale = std::pow(10.0, exponent);
  const std::string unit = exponent == 0 ? "px²/s²" : power_of_ten(exponent) + " px²/s²";
  Axis axis{.label = "specific energy, " + unit};
  axis.is_logarithmic = least > 0.0;  // Or most of a fling would lie on one line.
  Plot energy = plot_over_time(run, axis);
  energy.series = {
      series_of(run, "run", {.tone = Tone::blue, .width_px = 3},
                [scale](const RowErrors& row, const ArcErrors&) { return run_energy(row) / scale; }),
      series_of(run, "exact", {.width_px = 1.5, .dash = Dash::short_dashes},
                [scale](const RowErrors& row, const ArcErrors&) { return row.energy_px2_per_s2 / scale; })};
  Plot drift = plot_over_time(run, {.label = "run minus exact, % of the arc's largest energy"});
  drift.series = {series_of(run, "run minus exact", {.tone = Tone::green},
                            [](const RowErrors& row, const ArcErrors& arc) {
                              return 100.0 * row.energy_drift_px2_per_s2 / arc.energy_scale_px2_per_s2;
                            })};
  drift.marks = {{.is_vertical = false, .at = 0.0}};
  std::string subtitle =
      "Energy in flight: the run, the exact solution from each arc's first state, and the drift between them";
  if (const auto& worst = run.summary.energy_drift_rel_max)
    subtitle += fmt::format(", at most {} %", rounded(100.0 * worst->value, 3));
  return over_time(figure_of(run, kSuffixes[1], subtitle), {std::move(energy), std::move(drift)}, run);
}

// What the step itself adds is rounding, which has a strip of its own.
Axis error_axis(const DriftRun& run) {
  constexpr double kRoundingMax_px = 1e-6;
  double rounding_px = 0.0;
  for (const DrawnRow& row : run.rows) rounding_px = std::max(rounding_px, row.errors.implementation_px);
  Axis axis{.label = "distance, px (logarithmic)", .is_logarithmic = true};
  if (rounding_px > 0.0 && rounding_px < kRoundingMax_px) {
    axis.strip_below = 2.0 * rounding_px;
    axis.strip_name = "rounding";
  }
  return axis;
}

Figure errors_figure(const DriftRun& run) {
  const auto positive = [](double value_px) { return value_px > 0.0 ? value_px : kNotGiven; };
  // With the drag of 60 Hz both are the same.
  const bool are_one = std::ranges::all_of(run.rows, [](const DrawnRow& row) {
    return std::fabs(row.errors.model_px - row.errors.truncation_px) <= 1e-9 * row.errors.model_px;
  });
  Plot plot = plot_over_time(run, error_axis(run));
  plot.series = {
      series_of(run, are_one ? "model and truncation error: the same at this dt" : "truncation error",
                {.tone = Tone::blue, .width_px = 2},
                [&](const RowErrors& row, const ArcErrors&) { return positive(row.truncation_px); })};
  if (!are_one)
    plot.series.push_back(
        series_of(run, "model error", {.tone = Tone::lavender, .width_px = 2, .dash = Dash::long_dashes},
                  [&](const RowErrors& row, const ArcErrors&) { return positive(row.model_px); }));
  plot.series.push_back(
      series_of(run, "implementation error", {.tone = Tone::green, .width_px = 2},
                [&](const RowErrors& row, const ArcErrors&) { return positive(row.implementation_px); }));
  return over_time(figure_of(run, kSuffixes[2],
                             "Distance from three exact flights: drag as at 60 Hz (model), drag of this dt "
                             "(truncation), the step itself"),
                   {std::move(plot)}, run, [](const Series& series) {
                     double most_px = 0.0;  // NaN is a gap.
                     for (const double error_px : series.y) most_px = std::fmax(most_px, error_px);
                     return fmt::format(", at most {} px", rounded(most_px, 3));
                   });
}

Figure restitution_figure(const DriftRun& run) {
  constexpr std::size_t kTicksMax = 20;
  const Spread& spread = run.summary.effective_restitution;
  std::string subtitle = "Effective restitution: speed after the contact / speed at the true impact";
  if (spread.count() > 0)
    subtitle += fmt::format("; median {:.3f}, from {:.3g} to {:.3g}", spread.median(), spread.smallest(),
                            spread.largest());
  Figure figure = figure_of(run, kSuffixes[3], subtitle);
  const Look dashed{.width_px = 1.5, .dash = Dash::long_dashes};
  figure.legend = {{fmt::format("{:g}, of the reference", run.model.restitution), dashed}};

  std::array<Series, kWalls.size()> dots;
  double low = run.model.restitution, high = low;
  const std::size_t count = run.contacts.size();
  for (std::size_t number = 0; number < count; ++number) {
    const double value = run.contacts[number].effective_restitution.value_or(0.0);
    if (!(value > 0.0)) continue;  // None, or zeroed by the rest rule.
    low = std::min(low, value);
    high = std::max(high, value);
    Series& series = dots[wall_index(run.contacts[number].wall)];
    series.x.push_back(static_cast<double>(number + 1));
    series.y.push_back(value);
  }
  const double space = std::max(0.02, 0.1 * (high - low));
  Plot plot{.x = {.label = "contact, in order", .low = 0.5, .high = static_cast<double>(count) + 0.5},
            .y = {.label = "effective restitution", .low = low - space, .high = high + space, .decimals = 2},
            .marks = {{.is_vertical = false, .at = run.model.restitution}},
            .when_empty = "no contact that ends a flight"};
  for (std::size_t number = 1; number <= count && count <= kTicksMax; ++number)
    plot.x.ticks.push_back({static_cast<double>(number), std::to_string(number)});
  for (const Wall wall : kWalls) {
    Series& series = dots[wall_index(wall)];
    if (series.x.empty()) continue;
    const LegendEntry entry = wall_entry(wall);
    series.name = "contacts: " + entry.text;
    series.look = entry.look;
    series.look.marker_size = 0.9;
    figure.legend.push_back(entry);
    plot.series.push_back(std::move(series));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

Figure causes_figure(const DriftRun& run) {
  std::vector<Series> series = {
      {.name = "gravity once a step", .look = {.tone = Tone::blue}},
      {.name = "drag on that path", .look = {.tone = Tone::green}},
      {.name = "lift out of walls", .look = {.tone = Tone::vermilion}},
      {.name = "restitution after the wall", .look = {.tone = Tone::purple}},
      {.name = "all four", .look = {.tone = Tone::ink, .width_px = 1.5, .dash = Dash::short_dashes}}};
  EnergyCauseSum causes(run.model.gravity_px_per_s2);
  const auto add_point = [&](double t_s) {
    const EnergyCauses& now = causes.now();
    const std::array values = {now.gravity, now.drag, now.lift, now.bounce, now.sum()};
    for (std::size_t index = 0; index < values.size(); ++index) {
      series[index].x.push_back(t_s);
      series[index].y.push_back(values[index]);
    }
  };
  const auto add = [&](const auto& part, double begin_s) {
    add_point(begin_s);
    causes.add(part);
    add_point(part.t_s);
  };
  std::size_t next = 0;
  const auto add_before = [&](std::int64_t step) {
    for (; next < run.contacts.size() && run.contacts[next].step < step; ++next)
      add(run.contacts[next], run.contacts[next].t_s);
  };
  for (const ArcErrors& arc : run.arcs) {
    add_before(arc.last_step);
    add(arc, arc.t_s - arc.duration_s);
  }
  add_before(std::numeric_limits<std::int64_t>::max());
  Plot plot = plot_over_time(run, {.label = "energy so far, as px of height"});
  plot.series = std::move(series);
  plot.marks = {{.is_vertical = false, .at = 0.0}};
  return over_time(
      figure_of(run, kSuffixes[4],
                "What the step adds and takes by itself: energy against exact flights and bounces"),
      {std::move(plot)}, run, [](const Series& each) { return fmt::format(" {:+.3g} px", each.y.back()); });
}

}  // namespace

std::vector<Figure> drift_figures(const DriftRun& run) {
  return {whole_figure(run), energy_figure(run), errors_figure(run), restitution_figure(run),
          causes_figure(run)};
}

std::vector<std::string> drift_figure_paths(const std::string& folder, const std::string& name) {
  std::vector<std::string> paths;
  for (const std::string_view suffix : kSuffixes)
    paths.push_back((std::filesystem::path(folder) / fmt::format("{}{}.svg", name, suffix)).string());
  return paths;
}

}  // namespace hyrax
