// `hyrax-sim study frame-rate`: its tables, figures and verdict.
#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "sim/study/display_rates.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/study/study.h"

namespace hyrax {
namespace {

constexpr std::size_t kClocks = kDisplayClockNames.size();
constexpr std::array<std::string_view, kClocks> kClockTexts = {
    "every frame the same", "frames jittered by 2 ms (normal)", "one frame in twenty missed"};
constexpr std::array<std::string_view, 2> kMethodTexts = {"the paper's step", "drag and friction by time"};
constexpr std::array<Tone, 2> kMethodTones = {Tone::vermilion, Tone::blue};

std::string_view clock_name(DisplayClock clock) {
  return kDisplayClockNames[static_cast<std::size_t>(clock)];
}

template <class Record>
Column method_column(const std::vector<Record>& records) {
  return column_of<std::string>("method", "", "method", records,
                                [](const Record& record) { return kFrameRateMethods[record.method]; });
}
template <class Record>
Column clock_column(const std::vector<Record>& records) {
  return column_of<std::string>("clock", "", "the display's clock", records,
                                [](const Record& record) { return clock_name(record.clock); });
}
template <class Record>
Column rate_column(const std::vector<Record>& records) {
  return column_of<double>("rate", "Hz", "display rate", records, &Record::rate_hz);
}
Table landing_table(const std::vector<Landing>& landings) {
  return {"landings",
          "where and when flings settle, and after which distance",
          {method_column(landings), clock_column(landings), rate_column(landings),
           column_of<std::int64_t>("fling", "1", "number of the fling; 0 is the one that is drawn", landings,
                                   &Landing::fling),
           column_of<double>("x", "px", "where it settles", landings, &Landing::x_px),
           column_of<double>("time", "s", "since when it has been within half a pixel of that place",
                             landings, &Landing::time_s),
           column_of<double>("path", "px",
                             "length of the path, of the drawn fling and near 60 Hz by the paper's step",
                             landings, &Landing::path_px),
           column_of<double>("across", "px", "horizontal part of the path", landings, &Landing::across_px)}};
}

Table path_table(const std::vector<FanPoint>& paths) {
  return {
      "paths",
      "the drawn fling at some rates",
      {method_column(paths), rate_column(paths), column_of<double>("t", "s", "time", paths, &FanPoint::t_s),
       column_of<double>("x", "px", "position", paths, &FanPoint::x_px),
       column_of<double>("y", "px", "position", paths, &FanPoint::y_px)}};
}

Table score_table(const std::string& name, const std::vector<Independence>& scores) {
  return {
      name,
      "frame-rate independence",
      {method_column(scores), clock_column(scores),
       column_of<double>("spread", "px", "spread of the places where a fling settles over all rates, mean",
                         scores, &Independence::spread_px),
       column_of<double>("way", "px", "horizontal path of a fling at 60 Hz, mean", scores,
                         &Independence::way_px),
       column_of<double>("score", "1", "100 (1 - spread / way), at least 0", scores, &Independence::score),
       column_of<double>("spread_median", "px", "spread of a fling, median", scores,
                         [](const Independence& score) { return score.spreads_px.median; }),
       column_of<double>("spread_low", "px", "spread of a fling, 10 %", scores,
                         [](const Independence& score) { return score.spreads_px.low; }),
       column_of<double>("spread_high", "px", "spread of a fling, 90 %", scores,
                         [](const Independence& score) { return score.spreads_px.high; }),
       column_of<std::int64_t>("flings", "1", "played", scores,
                               [](const Independence& score) { return score.spreads_px.samples; }),
       column_of<std::int64_t>("seed", "1", "of the flings", scores,
                               [](const Independence&) { return static_cast<std::int64_t>(kFlingSeed); }),
       column_of<std::int64_t>("other_contacts", "1",
                               "flings that meet a side wall or the top another number of times at some rate",
                               scores,
                               [](const Independence& score) { return score.other_contacts.count; })}};
}

Table shift_table(const std::vector<DisplayShift>& shifts) {
  using S = const DisplayShift&;
  const auto shift = [&](const std::string& name, const std::string& what, double Band::*part) {
    return column_of<double>(name, "px", what, shifts, [part](S s) { return s.shift_px.*part; });
  };
  return {"shifts",
          "distance from where the same fling settles at 60 Hz",
          {method_column(shifts), clock_column(shifts), rate_column(shifts),
           shift("shift_median", "median", &Band::median), shift("shift_low", "10 %", &Band::low),
           shift("shift_high", "90 %", &Band::high),
           column_of<std::int64_t>("flings", "1", "played", shifts, [](S s) { return s.other_contacts.of; }),
           column_of<std::int64_t>("other_contacts", "1",
                                   "flings that meet a side wall or the top another number of times", shifts,
                                   [](S s) { return s.other_contacts.count; }),
           column_of<double>("other_contacts_share_low", "1", "95 % interval of their share", shifts,
                             [](S s) { return s.other_contacts.low(); }),
           column_of<double>("other_contacts_share_high", "1", "95 % interval of their share", shifts,
                             [](S s) { return s.other_contacts.high(); })}};
}

// As printed: by the paper's step and by time, every frame the same.
Table shown_shifts(const FrameRateStudy& study) {
  std::array<std::vector<DisplayShift>, kFrameRateMethods.size()> steady;
  for (const DisplayShift& shift : study.shifts)
    if (shift.clock == DisplayClock::steady) steady[shift.method].push_back(shift);
  Table table{"shifts", "", {rate_column(steady[0])}};
  using S = const DisplayShift&;
  for (std::size_t method = 0; method < steady.size(); ++method) {
    const std::string name = method == 0 ? "paper" : "by_time";
    table.columns.push_back(
        column_of<std::string>(name + "_settles_off,_px", "", "", steady[method], [](S s) {
          return fmt::format("{:.0f} ({:.0f} .. {:.0f})", s.shift_px.median, s.shift_px.low, s.shift_px.high);
        }));
    table.columns.push_back(column_of<std::string>(
        name + "_other_contacts_in", "", "", steady[method],
        [](S s) { return fmt::format("{} of {}", s.other_contacts.count, s.other_contacts.of); }));
  }
  return table;
}

Table shown_scores(const std::vector<Independence>& scores) {
  return {"scores",
          "",
          {method_column(scores), clock_column(scores),
           column_of<std::string>("spread,_px", "", "", scores,
                                  [](const Independence& score) {
                                    return fmt::format("{:.0f} ({:.0f} .. {:.0f})", score.spreads_px.median,
                                                       score.spreads_px.low, score.spreads_px.high);
                                  }),
           column_of<double>("way", "px", "", scores, &Independence::way_px),
           column_of<double>("score", "1", "", scores, &Independence::score)}};
}

// "every frame the same: drag and friction by time spread less in 118 of 121 flings (93 .. 99 %)".
std::string steadier_text(std::size_t clock, const Share& steadier) {
  return fmt::format("{}: drag and friction by time spread less in {} of {} flings ({:.0f} .. {:.0f} %)",
                     kClockTexts[clock], steadier.count, steadier.of, 100.0 * steadier.low(),
                     100.0 * steadier.high());
}

// The members of the JSON document: of the landings, those of the drawn fling.
std::vector<Table> summary_of(const FrameRateStudy& study) {
  std::vector<Landing> drawn;
  std::copy_if(study.landings.begin(), study.landings.end(), std::back_inserter(drawn),
               [](const Landing& landing) { return landing.fling == 0; });
  Table landings = landing_table(drawn);
  std::erase_if(landings.columns,
                [](const Column& column) { return column.name == "fling" || column.name == "across"; });
  return {score_table("scores", study.scores), std::move(landings), shift_table(study.shifts)};
}

// The drawn fling's landings by one method under one clock.
std::vector<Landing> drawn_landings(const FrameRateStudy& study, std::size_t method, DisplayClock clock) {
  std::vector<Landing> chosen;
  for (const Landing& landing : study.landings)
    if (landing.method == method && landing.clock == clock && landing.fling == 0) chosen.push_back(landing);
  return chosen;
}

Figure landing_figure(const FrameRateStudy& study) {
  Plot plot;
  plot.x = display_rate_axis(20, 1100);
  plot.y = {.label = "x where it settles, px"};
  Figure figure{.title = "One fling, many displays",
                .subtitle = fmt::format("Where the same fling settles; frame-rate independence {:.0f} by the "
                                        "paper's step, {:.0f} by time (100: the same place at every rate)",
                                        study.scores[0].score, study.scores[kClocks].score)};
  constexpr std::array<Look, kClocks> kLooks = {
      Look{.form = Form::line_and_points},
      Look{.form = Form::points, .marker = Marker::ring, .marker_size = 0.9},
      Look{.form = Form::points, .marker = Marker::square, .marker_size = 0.9}};
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method) {
    for (std::size_t clock = 0; clock < kClocks; ++clock) {
      Series series{.name = fmt::format("{}, {} frames", kMethodTexts[method], kDisplayClockNames[clock]),
                    .look = kLooks[clock]};
      series.look.tone = kMethodTones[method];
      for (const Landing& landing : drawn_landings(study, method, static_cast<DisplayClock>(clock))) {
        series.x.push_back(landing.rate_hz);
        series.y.push_back(landing.x_px);
      }
      plot.series.push_back(std::move(series));
    }
    figure.legend.push_back({std::string(kMethodTexts[method]), {.tone = kMethodTones[method]}});
  }
  for (std::size_t clock = 1; clock < kClocks; ++clock) {
    figure.legend.push_back({std::string(kClockTexts[clock]), kLooks[clock]});
    figure.legend.back().look.tone = Tone::quiet;
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

// Over all flings, not the drawn one alone.
Figure shift_figure(const FrameRateStudy& study) {
  Plot plot{.x = display_rate_axis(20, 1100),
            .y = {.label = "distance from where it settles at 60 Hz, px", .low = 0}};
  constexpr std::array<Tone, kFrameRateMethods.size()> kBandTones = {Tone::bad, Tone::sky_blue};
  Figure figure{
      .suffix = "-flings",
      .title = "Many flings, many displays",
      .subtitle = fmt::format("{} flings (seed {}), every frame the same; line: median, band: 10 to 90 %",
                              study.steadier_by_time[0].of, kFlingSeed)};
  for (std::size_t method = 0; method < kFrameRateMethods.size(); ++method) {
    Series band{.name = fmt::format("{}, 10 to 90 %", kMethodTexts[method]),
                .look = {.form = Form::band, .tone = kBandTones[method]}};
    Series median{.name = std::string(kMethodTexts[method]), .look = {.tone = kMethodTones[method]}};
    for (const DisplayShift& shift : study.shifts) {
      if (shift.method != method || shift.clock != DisplayClock::steady) continue;
      for (Series* const series : {&band, &median}) series->x.push_back(shift.rate_hz);
      band.y.push_back(shift.shift_px.high);
      band.y_low.push_back(shift.shift_px.low);
      median.y.push_back(shift.shift_px.median);
    }
    figure.legend.push_back({median.name, median.look});
    figure.legend.push_back({band.name, band.look});
    plot.series.insert(plot.series.begin() + static_cast<std::ptrdiff_t>(method), std::move(band));
    plot.series.push_back(std::move(median));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

Figure fan_figure(const FrameRateStudy& study, std::size_t method) {
  constexpr std::array<Tone, 6> kRateTones = {Tone::vermilion, Tone::orange,   Tone::blue,
                                              Tone::purple,    Tone::sky_blue, Tone::green};
  Plot plot{.x = {.label = "x, px", .low = 0, .high = kDrawnBounds.right_px},
            .y = {.label = "y, px, downwards", .is_reversed = true, .low = 0, .high = kDrawnBounds.bottom_px},
            .has_equal_scales = true};
  Figure figure{
      .suffix = method == 0 ? "-fan" : "-fan-by-time",
      .title = method == 0 ? "The fan of one fling" : "The same fling, drag and friction by time",
      .subtitle = fmt::format("The path of its corner, {}, at six display rates", kMethodTexts[method])};
  std::map<double, Series> paths;
  for (const FanPoint& point : study.paths) {
    if (point.method != method) continue;
    paths[point.rate_hz].x.push_back(point.x_px);
    paths[point.rate_hz].y.push_back(point.y_px);
  }
  for (auto& [rate_hz, series] : paths) {
    series.name = fmt::format("{:.0f} Hz", rate_hz);
    series.look = {.tone = kRateTones[plot.series.size() % kRateTones.size()], .width_px = 2};
    figure.legend.push_back({series.name, series.look});
    plot.series.push_back(std::move(series));
  }
  figure.body = std::vector{std::move(plot)};
  return figure;
}

Verdict verdict_of(const FrameRateStudy& study) {
  const std::vector<Landing> paper = drawn_landings(study, 0, DisplayClock::steady);
  const std::vector<Landing> by_time = drawn_landings(study, 1, DisplayClock::steady);
  Table landings{"displays", "", {rate_column(paper)}};
  for (const auto& [name, records] : {std::pair{"paper", &paper}, std::pair{"by_time", &by_time}}) {
    const std::string prefix = std::string(name) + "_";
    landings.columns.push_back(
        column_of<double>(prefix + "settles_at", "px", "", *records, &Landing::x_px, 5));
    landings.columns.push_back(column_of<double>(prefix + "after", "s", "", *records, &Landing::time_s, 3));
    landings.columns.push_back(column_of<double>(prefix + "path", "px", "", *records, &Landing::path_px));
  }
  Verdict verdict{
      {"frame-rate: one fling on every display, by the paper's step and with drag and friction by time",
       std::move(landings),
       fmt::format(
           "The fling and {} random ones (seed {}, jitter seeds {} .. {}): distance from where a fling "
           "settles at 60 Hz, median (10 .. 90 %)",
           study.steadier_by_time[0].of - 1, kFlingSeed, kJitterSeed, kJitterSeed + kJitterSeeds - 1),
       shown_shifts(study),
       "Spread of the places where a fling settles over the displays; frame-rate independence, 100 (1 - mean "
       "spread / mean horizontal path):",
       shown_scores(study.scores)},
      {}};
  for (std::size_t clock = 0; clock < kClocks; ++clock)
    verdict.text.push_back(steadier_text(clock, study.steadier_by_time[clock]) + ".");
  for (const Landing& landing : study.landings)
    if (!landing.is_core) {
      verdict.broken.push_back(
          fmt::format("{:g} Hz, {}: the method called the paper's step differs from the core",
                      landing.rate_hz, clock_name(landing.clock)));
      break;
    }
  for (std::size_t clock = 0; clock < kClocks; ++clock)
    if (!(study.steadier_by_time[clock].low() > 0.5))
      verdict.broken.push_back(steadier_text(clock, study.steadier_by_time[clock]) +
                               ": they are no more independent of the frame rate than the paper's step");
  return verdict;
}

StudyResult run(const StudyRequest& request) {
  const FrameRateStudy study =
      request.is_quick ? study_frame_rate({24.0, 60.0, 144.0, 240.0}, 100)
                       : study_frame_rate({24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 72.0, 75.0, 90.0, 100.0, 120.0,
                                           144.0, 165.0, 200.0, 240.0, 360.0, 500.0, 1000.0},
                                          120);
  return {.tables = {landing_table(study.landings), score_table("independence", study.scores),
                     path_table(study.paths), shift_table(study.shifts)},
          .figures = {landing_figure(study), shift_figure(study), fan_figure(study, 0), fan_figure(study, 1)},
          .verdict = verdict_of(study),
          .summary = summary_of(study)};
}

}  // namespace

Study frame_rate_study() {
  return {.name = "frame-rate", .summary = "one fling on every display, steady or not", .run = run};
}

}  // namespace hyrax
