#include "tools/report/rest_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "tools/report/plot_frame.h"

namespace hyrax {
namespace {

// Where the picture steps from what was measured at one rate to what was at the next: at the boundary
// between them, or half way on the logarithmic axis.
double change_between(double low_hz, double high_hz, const std::vector<RestBoundary>& boundaries) {
  for (const RestBoundary& boundary : boundaries)
    if (boundary.analytic_hz > low_hz && boundary.analytic_hz < high_hz) return boundary.analytic_hz;
  return std::sqrt(low_hz * high_hz);
}

}  // namespace

std::string rest_map_script(const std::vector<RateEnds>& map, const std::vector<RestBoundary>& boundaries) {
  PlotFrame frame("How it ends on the floor",
                  "Parts of random flings that end at rest, in a two-step cycle or in a buzz",
                  "display rate, Hz (logarithmic)", "flings, %; dashed: analytic boundaries, Hz");
  frame.use_rate_axis(20, 1000);
  std::string lines;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const RateEnds& ends = map[i];
    const double from_hz =
        i == 0 ? ends.rate_hz : change_between(map[i - 1].rate_hz, ends.rate_hz, boundaries);
    const double to_hz =
        i + 1 == map.size() ? ends.rate_hz : change_between(ends.rate_hz, map[i + 1].rate_hz, boundaries);
    double all = 0.0;
    for (const std::int64_t count : ends.flings) all += static_cast<double>(count);
    const auto part = [&](FinalState state) {
      return 100.0 * static_cast<double>(ends.flings[static_cast<std::size_t>(state)]) / all;
    };
    const double buzz = part(FinalState::buzz), cycle = part(FinalState::cycle),
                 rest = part(FinalState::rest);
    for (const double rate_hz : {from_hz, to_hz})
      lines += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", rate_hz, buzz, buzz + cycle, buzz + cycle + rest);
  }
  frame.add_block("ends", lines);
  frame.add("set yrange [0:100]\n");
  for (const RestBoundary& boundary : boundaries)
    frame.mark(boundary.analytic_hz, fmt::format("{:.2f}", boundary.analytic_hz));
  frame.explain_area("buzz: a fixed speed for ever", style::kVermilion);
  frame.explain_area("cycle: every other step at 0", style::kOrange);
  frame.explain_area("rest: speed 0", style::kGreen);
  return frame.script(
      fmt::format("plot $ends using 1:4 title 'rest' with filledcurves y1=0 fs solid 1 lc rgb '{}', "
                  "$ends using 1:3 title 'cycle' with filledcurves y1=0 fs solid 1 lc rgb '{}', "
                  "$ends using 1:2 title 'buzz' with filledcurves y1=0 fs solid 1 lc rgb '{}'",
                  style::kGreen, style::kOrange, style::kVermilion));
}

std::string rest_time_script(const std::vector<RateEnds>& map) {
  PlotFrame frame("How long it takes to lie",
                  "Time until a random fling stays on the floor within half a pixel",
                  "display rate, Hz (logarithmic)", "time, s");
  frame.use_rate_axis(20, 1000);
  std::string lines;
  double high_s = 0.0;
  for (const RateEnds& ends : map) {
    lines += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", ends.rate_hz, ends.time_low_s, ends.time_median_s,
                         ends.time_high_s);
    high_s = std::max(high_s, ends.time_high_s);
  }
  frame.add_block("times", lines);
  frame.add(fmt::format("set yrange [0:{:.3g}]\n", 1.1 * high_s + 0.1));
  frame.explain_line("median", style::kBlue);
  frame.explain_area("eight of ten flings", style::kHairline);
  return frame.script(fmt::format(
      "plot $times using 1:2:4 title 'eight of ten flings' with filledcurves fs solid 1 lc rgb '{}', "
      "$times using 1:3 title 'median' with lines lw 2.5 lc rgb '{}'",
      style::kHairline, style::kBlue));
}

std::string bounce_script(const std::vector<BounceSeen>& bounces) {
  PlotFrame frame(
      "What a bounce keeps",
      "Speed after the first bounce of a drop over the speed at which the exact flight meets the floor",
      "part of the contact's step that lies past the floor", "effective restitution; dashed: the core's");
  std::map<double, std::string> lines;
  double least = core_constants().restitution, most = least;
  for (const BounceSeen& seen : bounces) {
    lines[seen.rate_hz] += fmt::format("{:.6g} {:.8g}\n", seen.phase, seen.restitution);
    least = std::min(least, seen.restitution);
    most = std::max(most, seen.restitution);
  }
  const double space = 0.1 * (most - least) + 1e-6;
  frame.add(fmt::format("set xrange [0:1]\nset yrange [{:.6g}:{:.6g}]\nset format y '%.3f'\n", least - space,
                        most + space));
  frame.add(
      fmt::format("set arrow from graph 0, first {0:.8g} to graph 1, first {0:.8g} nohead front lw 1.5 dt "
                  "(6,4) lc rgb '{1}'\n",
                  core_constants().restitution, style::kInk));
  constexpr std::array<std::string_view, 7> kColours = {style::kVermilion, style::kOrange,  style::kBlue,
                                                        style::kPurple,    style::kSkyBlue, style::kGreen,
                                                        style::kInk};
  std::string command;
  std::size_t index = 0;
  for (const auto& [rate_hz, block] : lines) {
    const std::string_view colour = kColours[index % kColours.size()];
    frame.add_block(fmt::format("rate{}", index), block);
    frame.explain_line(fmt::format("{:.0f} Hz", rate_hz), colour);
    command +=
        fmt::format("{} $rate{} using 1:2 smooth unique title '{:.0f} Hz' with lines lw 2.5 lc rgb '{}'",
                    command.empty() ? "plot" : ",", index, rate_hz, colour);
    ++index;
  }
  return frame.script(command.empty() ? "plot NaN notitle" : command);
}

}  // namespace hyrax
