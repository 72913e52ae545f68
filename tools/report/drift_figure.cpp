#include "tools/report/drift_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "sim/reference/drift.h"
#include "sim/result/number_text.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

// Where the picture ends: what comes later is at rest.
double end_s(const DriftRun& run) {
  const DriftSummary& summary = run.summary;
  const double end = summary.is_resting_at_end ? summary.rests.back().from_s : run.simulated_s;
  return end > 0.0 ? end : 1.0;
}

// "loses 10 px of height a second in flight; lifts out of walls give half back".
std::string answer_of(const DriftRun& run) {
  const std::optional<double> slope = run.summary.secular_px_per_s;
  if (!slope) return "has no flight of two steps or more";
  std::string text = fmt::format("{} {} px of height a second in flight", *slope < 0.0 ? "loses" : "gains",
                                 rounded(std::fabs(*slope), 2));
  const EnergyCauses& causes = run.summary.causes;
  const double back = causes.gravity < 0.0 ? causes.lift / -causes.gravity : 0.0;
  if (back >= 1.05)
    text += fmt::format("; lifts out of walls give {} times that back", rounded(back, 2));
  else if (back >= 0.05)
    text += fmt::format("; lifts out of walls give {} back",
                        std::fabs(back - 0.5) < 0.05 ? "half" : rounded(100.0 * back, 2) + " %");
  return text;
}

std::string subtitle_of(const DriftRun& run) {
  if (!run.whole.run) return "There is no exact fling: " + run.whole.why_not;
  const WholeRun& whole = *run.whole.run;
  return fmt::format("Ends {} px from the exact fling, which has the same inputs; {} px at most, in row {}",
                     rounded(whole.end_px, 3), rounded(whole.max_px, 3), whole.max_px_step);
}

Plot plot_over_time(const DriftRun& run, Axis y) {
  return {.x = {.label = "time, s", .low = 0.0, .high = end_s(run)}, .y = std::move(y)};
}

Plot distance_plot(const DriftRun& run) {
  Plot plot = plot_over_time(run, {.label = "distance from the exact fling, px", .low = 0.0});
  plot.when_empty = "no exact fling: " + run.whole.why_not;
  Series series{.name = "distance from the exact fling", .look = {.tone = Tone::blue}};
  for (const WholeRow& row : run.whole_rows) {
    if (row.t_s > end_s(run)) break;
    series.x.push_back(row.t_s);
    series.y.push_back(row.distance_px);
  }
  plot.series = {std::move(series)};
  return plot;
}

// The energy drift, and under it what moved it: at each row of an arc what the arcs and contacts before left,
// and the arc's own.
Plot energy_plot(const DriftRun& run) {
  Plot plot = plot_over_time(run, {.label = "energy drift, px of height"});
  plot.when_empty = "no flight of two steps or more";
  plot.marks = {{.is_vertical = false, .at = 0.0}};
  plot.series = {{.name = "gravity once a step", .look = {.tone = Tone::sky_blue, .width_px = 2}},
                 {.name = "drag on that path", .look = {.tone = Tone::green, .width_px = 2}},
                 {.name = "lift out of walls", .look = {.tone = Tone::vermilion, .width_px = 2}},
                 {.name = "restitution after the wall", .look = {.tone = Tone::purple, .width_px = 2}},
                 {.name = "energy drift", .look = {.tone = Tone::ink}}};
  EnergyCauseSum causes(run.model.gravity_px_per_s2);
  const auto add = [&](std::size_t series, double t_s, double value) {
    plot.series[series].x.push_back(t_s);
    plot.series[series].y.push_back(value);
  };
  const auto add_causes = [&](double t_s) {
    const EnergyCauses& now = causes.now();
    const std::array values = {now.gravity, now.drag, now.lift, now.bounce};
    for (std::size_t series = 0; series < values.size(); ++series) add(series, t_s, values[series]);
  };
  auto row = run.rows.begin();
  auto contact = run.contacts.begin();
  const auto add_contacts_up_to = [&](std::int64_t step) {
    for (; contact != run.contacts.end() && contact->step <= step; ++contact) {
      if (run.summary.is_at_rest(contact->t_s)) continue;
      add_causes(contact->t_s);
      causes.add(*contact);
      add_causes(contact->t_s);
      add(4, contact->t_s, causes.now().sum() + causes.now().flight);
    }
  };
  for (std::size_t arc = 0; arc < run.arcs.size(); ++arc) {
    const ArcErrors& errors = run.arcs[arc];
    add_contacts_up_to(errors.first_step);
    if (run.summary.is_at_rest(errors.t_s)) continue;
    add_causes(errors.t_s - errors.duration_s);
    const double before = causes.now().sum() + causes.now().flight;
    for (; row != run.rows.end() && row->arc <= arc; ++row)
      if (row->arc == arc)
        add(4, row->errors.t_s, before + row->errors.energy_drift_px2_per_s2 / run.model.gravity_px_per_s2);
    causes.add(errors.energy_parts);
    add_causes(errors.t_s);
  }
  add_contacts_up_to(run.steps);
  return plot;
}

// A dot above the first plot for each bounce.
void mark_bounces(Figure& figure, Plot& plot, const DriftRun& run) {
  constexpr std::size_t kMarkedMax = 80;
  std::vector<TopDot> dots;
  std::array<bool, kWalls.size()> has_wall{};
  for (const ImpactErrors& contact : run.contacts) {
    if (contact.wall == Wall::ground && run.summary.is_at_rest(contact.t_s)) continue;
    if (dots.size() == kMarkedMax) return;
    if (contact.t_s > end_s(run)) break;
    has_wall[wall_index(contact.wall)] = true;
    dots.push_back(
        {contact.t_s, kWallTones[wall_index(contact.wall)], kWallMarkers[wall_index(contact.wall)]});
  }
  plot.top_dots = std::move(dots);
  for (const Wall wall : kWalls)
    if (has_wall[wall_index(wall)])
      figure.legend.push_back({"bounce, " + std::string(name_of(wall)),
                               {.form = Form::points,
                                .tone = kWallTones[wall_index(wall)],
                                .marker = kWallMarkers[wall_index(wall)],
                                .marker_size = 0.9}});
}

// Lines at inputs but where a hand leads the sprite; their names below the dots of bounces.
void mark_inputs(std::vector<Plot>& plots, const DriftRun& run) {
  constexpr std::size_t kInputsMarkedMax = 12;
  const Scenario& scenario = run.scenario;
  if (scenario.events.empty()) return;
  const std::vector<std::int64_t> frames = schedule_events(scenario, step_count(scenario)).frames;
  for (std::size_t i = 0; i < frames.size() && plots.front().marks.size() < kInputsMarkedMax; ++i) {
    if (std::holds_alternative<Place>(scenario.events[i].action)) continue;
    const auto row = std::ranges::lower_bound(run.rows, frames[i], {},
                                              [](const DrawnRow& drawn) { return drawn.errors.step; });
    if (row == run.rows.end() || row->errors.t_s > end_s(run)) continue;
    Mark mark{.at = row->errors.t_s, .tone = Tone::quiet};
    plots.front().marks.push_back(mark);
    mark.text = std::string(name_of(scenario.events[i].action));
    plots.back().marks.push_back(std::move(mark));
  }
}

}  // namespace

Figure drift_figure(const DriftRun& run) {
  Figure figure{
      .suffix = "-drift", .title = run.scenario.name + " " + answer_of(run), .subtitle = subtitle_of(run)};
  if (run.summary.is_resting_at_end)
    figure.note = fmt::format("in resting contact from {} s on", rounded(end_s(run), 3));
  figure.note_tone = Tone::quiet;
  std::vector<Plot> plots = {distance_plot(run), energy_plot(run)};
  for (const Series& series : plots.back().series) figure.legend.push_back({series.name, series.look});
  mark_bounces(figure, plots.front(), run);
  mark_inputs(plots, run);
  figure.body = std::move(plots);
  return figure;
}

std::string drift_figure_path(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / (name + "-drift.svg")).generic_string();
}

}  // namespace hyrax
