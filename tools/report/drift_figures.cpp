#include "tools/report/drift_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "tools/files/failure.h"
#include "tools/report/gnuplot.h"
#include "tools/report/plot_frame.h"
#include "tools/report/run_plot.h"

namespace hyrax {
namespace {

constexpr Canvas kCanvas = {960, 460};
constexpr std::string_view kBand = "#eaeef2";
constexpr std::size_t kArcsMarkedMax = 80;

std::string note_of(const DriftPicture& picture) {
  if (picture.arcs.empty()) return "";
  const DriftSummary& summary = picture.summary;
  if (summary.arcs > static_cast<std::int64_t>(picture.arcs.size()))
    return fmt::format("the first {} of {} arcs", picture.arcs.size(), summary.arcs);
  return fmt::format("{} arc{}, {} contact{}", summary.arcs, summary.arcs == 1 ? "" : "s", summary.contacts,
                     summary.contacts == 1 ? "" : "s");
}

// A frame with the name of the run.
PlotFrame drift_frame(const DriftPicture& picture, std::string_view subtitle, std::string_view x_label,
                      std::string_view y_label) {
  PlotFrame frame(picture.scenario.name, subtitle, x_label, y_label, kCanvas);
  frame.note(note_of(picture));
  return frame;
}

// Time from 0 to the end of the last arc; every other arc has a darker band, and a dot at the top for the
// wall that ended it. Neither if there are too many arcs to distinguish.
void mark_arcs(PlotFrame& frame, const DriftPicture& picture) {
  const std::vector<ArcErrors>& arcs = picture.arcs;
  if (picture.rows.empty()) return frame.add("set xrange [0:1]\n");
  const double end_s = picture.rows.back().errors.t_s;
  frame.add(fmt::format("set xrange [0:{:.10g}]\n", end_s > 0.0 ? end_s : 1.0));
  if (arcs.size() > kArcsMarkedMax) return;
  std::array<bool, 4> has_wall{};
  std::size_t row = 0;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    if (row == picture.rows.size()) break;
    const double from_s = picture.rows[row].errors.t_s;
    while (row < picture.rows.size() && picture.rows[row].arc == arc) ++row;
    const double to_s = picture.rows[row - (row > 0)].errors.t_s;
    if (arc % 2 == 1)
      frame.add(
          fmt::format("set object {} rectangle from first {:.10g}, graph 0 to first {:.10g}, graph 1 behind "
                      "fs solid 1 noborder fc rgb '{}'\n",
                      10 + arc, from_s, to_s, kBand));
    const auto wall = wall_of(arcs[arc].ended_by);
    if (!wall) continue;
    has_wall[wall_index(*wall)] = true;
    frame.add(fmt::format("set label '' at first {:.10g}, graph 1.035 point pt 7 ps 0.7 lc rgb '{}'\n", to_s,
                          wall_colour(*wall)));
  }
  if (arcs.size() > 1) frame.explain_area("every other arc", kBand);
  for (const Wall wall : kWalls)
    if (has_wall[wall_index(wall)]) frame.explain_dot(kWallNames[wall_index(wall)], wall_colour(wall));
}

constexpr std::string_view kNoArc = "no flight of two steps or more";

// Lines "t value...", with an empty line between arcs; rows without values are left out.
template <class Write>
std::string lines_of(const DriftPicture& picture, const Write& write) {
  std::string lines;
  std::size_t arc = 0;
  for (const DrawnRow& row : picture.rows) {
    if (row.arc >= picture.arcs.size()) break;
    if (row.arc != arc) lines += "\n";
    arc = row.arc;
    const std::string values = write(row.errors, picture.arcs[arc]);
    if (!values.empty()) lines += fmt::format("{:.9g} {}\n", row.errors.t_s, values);
  }
  return lines;
}

// Zero has no logarithm.
std::string positive(double value_px) { return value_px > 0.0 ? fmt::format("{:.4g}", value_px) : "NaN"; }

struct Range {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

double run_energy(const RowErrors& row) { return row.energy_px2_per_s2 + row.energy_drift_px2_per_s2; }

// Thousands, millions, ... that leave one to three digits before the point.
int exponent_of(const Range& range) {
  const double largest = std::max(std::fabs(range.low), std::fabs(range.high));
  return largest >= 1e3 && std::isfinite(largest) ? 3 * static_cast<int>(std::log10(largest) / 3.0) : 0;
}

// The axis of errors: the decades that the errors cover, with a tic at every other power of ten.
std::string decades(const DriftPicture& picture) {
  Range range;
  const auto add = [&range](double value_px) {
    if (value_px > 0.0) range.add(std::log10(value_px));
  };
  for (const DrawnRow& row : picture.rows) {
    add(row.errors.implementation_px);
    add(row.errors.truncation_px);
    add(row.errors.model_px);
  }
  if (range.low > range.high) range = {-1.0, 1.0};
  const int low = 2 * static_cast<int>(std::floor(range.low / 2.0));
  const int high = 2 * static_cast<int>(std::ceil((range.high + 0.01) / 2.0));
  std::string tics;
  for (int exponent = low; exponent <= high; exponent += 2)
    tics += fmt::format("{}'{}' 1e{}", tics.empty() ? "" : ", ", power_of_ten(exponent), exponent);
  return fmt::format("set logscale y\nset yrange [1e{}:1e{}]\nset ytics ({})\n", low, high, tics);
}

}  // namespace

std::string energy_figure_script(const DriftPicture& picture) {
  Range range;
  for (const DrawnRow& row : picture.rows) {
    range.add(row.errors.energy_px2_per_s2);
    range.add(run_energy(row.errors));
  }
  const int exponent = exponent_of(range);
  const double scale = std::pow(10.0, exponent);
  const std::string unit = exponent == 0 ? "px²/s²" : power_of_ten(exponent) + " px²/s²";
  PlotFrame plot =
      drift_frame(picture, "Energy in flight: the run, and the exact solution from each arc's first state",
                  "time, s", "specific energy, " + unit);
  plot.add_block("energy", lines_of(picture, [scale](const RowErrors& row, const ArcErrors&) {
                   return fmt::format("{:.7g} {:.7g}", row.energy_px2_per_s2 / scale,
                                      run_energy(row) / scale);
                 }));
  plot.explain_line("run", style::kBlue, 3);
  plot.explain_line("exact", style::kInk, 1.5, "(5,4)");
  mark_arcs(plot, picture);
  if (picture.rows.empty()) return plot.script_of_nothing(kNoArc);
  if (range.low >= 0.0) plot.add("set yrange [0:*]\n");
  return plot.script(
      fmt::format("plot $energy using 1:3 title 'run' with lines lw 3 lc rgb '{}', "
                  "$energy using 1:2 title 'exact' with lines lw 1.5 dt (5,4) lc rgb '{}'",
                  style::kBlue, style::kInk));
}

std::string energy_drift_figure_script(const DriftPicture& picture) {
  PlotFrame plot = drift_frame(picture, "Energy drift of each arc: the run minus the exact solution",
                               "time, s", "drift, % of the arc's largest energy");
  plot.add_block("drift", lines_of(picture, [](const RowErrors& row, const ArcErrors& arc) {
                   return fmt::format("{:.5g}",
                                      100.0 * row.energy_drift_px2_per_s2 / arc.energy_scale_px2_per_s2());
                 }));
  plot.explain_line("energy drift", style::kBlue);
  mark_arcs(plot, picture);
  plot.add(fmt::format("set arrow from graph 0, first 0 to graph 1, first 0 nohead lw 1.5 lc rgb '{}' back\n",
                       style::kInk));
  if (picture.rows.empty()) return plot.script_of_nothing(kNoArc);
  return plot.script(
      fmt::format("plot $drift using 1:2 title 'energy drift' with lines lw 2.5 lc rgb '{}'", style::kBlue));
}

std::string errors_figure_script(const DriftPicture& picture) {
  PlotFrame plot = drift_frame(
      picture,
      "Distance from three exact flights: drag as at 60 Hz (model), drag of this dt (truncation), "
      "the step itself",
      "time, s", "distance, px (logarithmic)");
  plot.add_block("errors", lines_of(picture, [](const RowErrors& row, const ArcErrors&) {
                   return positive(row.implementation_px) + " " + positive(row.truncation_px) + " " +
                          positive(row.model_px);
                 }));
  plot.explain_line("model", style::kLavender, 5);
  plot.explain_line("truncation", style::kBlue, 2);
  plot.explain_line("implementation", style::kGreen, 2);
  mark_arcs(plot, picture);
  if (picture.rows.empty()) return plot.script_of_nothing(kNoArc);
  plot.add(decades(picture));
  return plot.script(
      fmt::format("plot $errors using 1:4 title 'model error' with lines lw 5 lc rgb '{}', "
                  "$errors using 1:3 title 'truncation error' with lines lw 2 lc rgb '{}', "
                  "$errors using 1:2 title 'implementation error' with lines lw 2 lc rgb '{}'",
                  style::kLavender, style::kBlue, style::kGreen));
}

std::string restitution_figure_script(const DriftPicture& picture) {
  const Spread& spread = picture.summary.effective_restitution;
  std::string subtitle = "Effective restitution: speed after the contact / speed at the true impact";
  if (spread.count() > 0)
    subtitle += fmt::format("; mean {:.3f}, spread {:.3f}", spread.mean(), spread.standard_deviation());
  PlotFrame plot = drift_frame(picture, subtitle, "contact, in order", "effective restitution");
  std::array<std::string, 4> dots;
  Range range{0.6, 0.6};
  std::size_t count = 0;
  for (const ImpactErrors& contact : picture.contacts) {
    ++count;
    const double value = contact.effective_restitution.value_or(0.0);
    if (!(value > 0.0)) continue;  // None, or zeroed by the rest rule.
    range.add(value);
    dots[wall_index(contact.wall)] += fmt::format("{} {:.5g}\n", count, value);
  }
  const double room = std::max(0.02, 0.1 * (range.high - range.low));
  plot.add(fmt::format("set xrange [0.5:{}]\nset yrange [{:.4g}:{:.4g}]\nset format y '%.2f'\n",
                       static_cast<double>(count) + 0.5, range.low - room, range.high + room));
  if (count <= 20) plot.add("set xtics 1\n");
  plot.add(
      fmt::format("set arrow from graph 0, first 0.6 to graph 1, first 0.6 nohead lw 1.5 dt (5,4) lc rgb "
                  "'{}' back\n",
                  style::kInk));
  plot.explain_line("0.6, the paper's", style::kInk, 1.5, "(5,4)");
  std::string command;
  for (const Wall wall : kWalls) {
    if (dots[wall_index(wall)].empty()) continue;
    const std::string_view name = kWallNames[wall_index(wall)];
    plot.add_block(name, dots[wall_index(wall)]);
    plot.explain_dot(name, wall_colour(wall));
    command += fmt::format("{0} ${1} title 'contacts: {1}' with points pt 7 ps 0.9 lc rgb '{2}'",
                           command.empty() ? "plot" : ",", name, wall_colour(wall));
  }
  return command.empty() ? plot.script_of_nothing("no contact that ends a flight") : plot.script(command);
}

std::vector<std::string> drift_figure_paths(const std::string& folder, const std::string& name) {
  std::vector<std::string> paths;
  for (const char* const what : {"energy", "energy-drift", "errors", "restitution"})
    paths.push_back((std::filesystem::path(folder) / fmt::format("{}-{}.svg", name, what)).string());
  return paths;
}

std::vector<std::string> draw_drift_figures(const std::string& folder, const DriftPicture& picture) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Failure(ExitCode::cannot_access, folder + ": cannot be created: " + error.message());
  std::vector<std::string> paths = drift_figure_paths(folder, picture.scenario.name);
  draw_figure(paths[0], energy_figure_script(picture));
  draw_figure(paths[1], energy_drift_figure_script(picture));
  draw_figure(paths[2], errors_figure_script(picture));
  draw_figure(paths[3], restitution_figure_script(picture));
  return paths;
}

}  // namespace hyrax
