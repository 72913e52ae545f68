#include "sim/result/table.h"
#include "sim/study/frame_rate/frame_rate.h"

namespace hyrax {
namespace {

template <class Records>
Column method_column(const Records& records) {
  return column_of<std::string>("method", "", "method", records, [](const auto& record) {
    return std::string(kFrameRateMethods[record.method]);
  });
}
template <class Records>
Column clock_column(const Records& records) {
  return column_of<std::string>("clock", "", "the display's clock", records, [](const auto& record) {
    return std::string(kDisplayClockNames[static_cast<std::size_t>(record.clock)]);
  });
}
template <class Records>
Column rate_column(const Records& records) {
  return column_of<double>("rate", "Hz", "display rate", records,
                           [](const auto& record) { return record.rate_hz; });
}

}  // namespace

Table landing_table(const std::vector<Landing>& landings) {
  return {"landings",
          "where, when and after which way flings come to lie",
          {method_column(landings), clock_column(landings), rate_column(landings),
           column_of<std::int64_t>("fling", "1", "number of the fling; 0 is the one that is drawn", landings,
                                   [](const Landing& landing) { return landing.fling; }),
           column_of<double>("x", "px", "resting place", landings,
                             [](const Landing& landing) { return landing.x_px; }),
           column_of<double>("time", "s", "since when it lies there within half a pixel", landings,
                             [](const Landing& landing) { return landing.time_s; }),
           column_of<double>("path", "px", "length of the way", landings,
                             [](const Landing& landing) { return landing.path_px; }),
           column_of<double>("across", "px", "of it what was horizontal", landings,
                             [](const Landing& landing) { return landing.across_px; })}};
}

Table path_table(const std::vector<FanPoint>& paths) {
  return {
      "paths",
      "the drawn fling at some rates",
      {method_column(paths), rate_column(paths),
       column_of<double>("t", "s", "time", paths, [](const FanPoint& point) { return point.t_s; }),
       column_of<double>("x", "px", "position", paths, [](const FanPoint& point) { return point.x_px; }),
       column_of<double>("y", "px", "position", paths, [](const FanPoint& point) { return point.y_px; })}};
}

Table independence_table(const std::vector<Independence>& scores) {
  return {"independence",
          "frame-rate independence",
          {method_column(scores), clock_column(scores),
           column_of<double>("spread", "px", "spread of a fling's resting places over all rates, mean",
                             scores, [](const Independence& score) { return score.spread_px; }),
           column_of<double>("way", "px", "horizontal way of a fling at 60 Hz, mean", scores,
                             [](const Independence& score) { return score.way_px; }),
           column_of<double>("score", "1", "100 (1 - spread / way), at least 0", scores,
                             [](const Independence& score) { return score.score; })}};
}

}  // namespace hyrax
