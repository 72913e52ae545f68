#include "tools/report/frame_rate_figures.h"

#include <map>

#include <fmt/format.h>

#include "tools/report/plot_frame.h"

namespace hyrax {
namespace {

constexpr std::array<std::string_view, kFrameRateMethods.size()> kMethodWords = {"the paper's step",
                                                                                 "drag and friction by time"};
constexpr std::array<std::string_view, kFrameRateMethods.size()> kMethodColours = {style::kVermilion,
                                                                                   style::kBlue};

// From slow displays to fast, dark to light.
constexpr std::array<std::string_view, 6> kRateColours = {"#440154", "#3e4989", "#26828e",
                                                          "#35b779", "#b5de2b", "#e69f00"};

}  // namespace

std::string resting_places_script(const FrameRateStudy& study) {
  PlotFrame frame(
      "One fling, many displays",
      fmt::format(
          "Where the same fling comes to lie; frame-rate independence {:.0f} by the paper's step, {:.0f} "
          "by time (100: the same place everywhere)",
          study.scores[0].score, study.scores[kDisplayClockNames.size()].score),
      "display rate, Hz (logarithmic)", "resting place x, px");
  frame.use_rate_axis(20, 1100);
  std::string command = "plot";
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method) {
    for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock) {
      std::string lines;
      for (const Landing& landing : study.landings)
        if (landing.method == method && static_cast<std::size_t>(landing.clock) == clock &&
            landing.fling == 0)
          lines += fmt::format("{:.6g} {:.8g}\n", landing.rate_hz, landing.x_px);
      const std::string name = fmt::format("places{}{}", method, clock);
      frame.add_block(name, lines);
      const bool is_steady = clock == static_cast<std::size_t>(DisplayClock::steady);
      command +=
          fmt::format("{} ${} title {} with {} lc rgb '{}'", command == "plot" ? "" : ",", name,
                      quoted(fmt::format("{}, {} frames", kMethodWords[method], kDisplayClockNames[clock])),
                      is_steady    ? "linespoints lw 2.5 pt 7 ps 0.6"
                      : clock == 1 ? "points pt 6 ps 0.9 lw 1.5"
                                   : "points pt 4 ps 0.9 lw 1.5",
                      kMethodColours[method]);
    }
    frame.explain_line(kMethodWords[method], kMethodColours[method]);
  }
  frame.explain_dot("frames jittered by 2 ms", style::kQuietInk, 6);
  frame.explain_dot("one frame in twenty missed", style::kQuietInk, 4);
  return frame.script(command);
}

std::string fan_script(const FrameRateStudy& study, std::size_t method) {
  const double right_px = kDrawnBounds.right_px, bottom_px = kDrawnBounds.bottom_px;
  const double width = 960 - 76 - 28;
  PlotFrame frame(method == 0 ? "The fan of one fling" : "The same fling, drag and friction by time",
                  fmt::format("The path of its corner, {}, at six display rates", kMethodWords[method]),
                  "x, px", "y, px, downwards", {960, 118 + 92 + width * bottom_px / right_px});
  frame.add(fmt::format("set xrange [0:{}]\nset yrange [{}:0]\nset xtics 200\nset ytics 200\n", right_px,
                        bottom_px));
  std::map<double, std::string> lines;
  for (const FanPoint& point : study.paths)
    if (point.method == method)
      lines[point.rate_hz] += fmt::format("{:.6g} {:.6g}\n", point.x_px, point.y_px);
  std::string command;
  std::size_t index = 0;
  for (const auto& [rate_hz, block] : lines) {
    const std::string_view colour = kRateColours[index % kRateColours.size()];
    frame.add_block(fmt::format("path{}", index), block);
    frame.explain_line(fmt::format("{:.0f} Hz", rate_hz), colour);
    command += fmt::format("{} $path{} title '{:.0f} Hz' with lines lw 2 lc rgb '{}'",
                           command.empty() ? "plot" : ",", index, rate_hz, colour);
    ++index;
  }
  return frame.script(command.empty() ? "plot NaN notitle" : command);
}

}  // namespace hyrax
