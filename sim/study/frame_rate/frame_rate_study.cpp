// `hyrax-sim study frame-rate`: its tables, figures and verdict.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "sim/study/display_rates.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/study/study.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

std::string_view clock_name(DisplayClock clock) {
  return kDisplayClockNames[static_cast<std::size_t>(clock)];
}

// With columns of what each record is about: its method and, if it has them, clock and display rate.
template <class Record>
StudyTable<std::vector<Record>> table_by_method(const std::string& name, const std::string& long_name,
                                                const std::vector<Record>& records) {
  StudyTable<std::vector<Record>> table(name, long_name, records);
  table.add("method", "", "method", [](const Record& record) { return kFrameRateMethods[record.method]; });
  if constexpr (requires { &Record::clock; })
    table.add("clock", "", "the display's clock",
              [](const Record& record) { return clock_name(record.clock); });
  if constexpr (requires { &Record::rate_hz; }) table.add("rate", "Hz", "display rate", &Record::rate_hz);
  return table;
}

Table landing_table(const std::vector<Landing>& landings) {
  return table_by_method("landings", "where and when flings settle, and after which distance", landings)
      .add("fling", "1", "number of the fling; 0 is the one that is drawn", &Landing::fling)
      .add("x", "px", "where it settles", [](const Landing& landing) { return landing.end.x_px; })
      .add("time", "s", "since when it has been within half a pixel of that place", &Landing::time_s)
      .add("off", "px", "distance from where the exact fling settles", &Landing::off_px)
      .add("path", "px", "length of the path, of the drawn fling and near 60 Hz by the paper's step",
           &Landing::path_px)
      .add("across", "px", "horizontal part of the path", &Landing::across_px);
}

Table path_table(const std::vector<FanPoint>& paths) {
  return table_by_method("paths", "the drawn fling at some rates", paths)
      .add("t", "s", "time", &FanPoint::t_s)
      .add("x", "px", "position", &FanPoint::x_px)
      .add("y", "px", "position", &FanPoint::y_px);
}

Table score_table(const std::string& name, const std::vector<Independence>& scores) {
  using S = const Independence&;
  return table_by_method(name, "frame-rate independence", scores)
      .add("spread", "px", "spread of the places where a fling settles over all rates, mean",
           &Independence::spread_px)
      .add("way", "px", "horizontal path of a fling at 60 Hz, mean", &Independence::way_px)
      .add("score", "1", "100 (1 - spread / way), at least 0", &Independence::score)
      .add_band("spread", "px", "spread of a fling", &Independence::spreads_px, "spread_median")
      .add("flings", "1", "played", [](S score) { return score.spreads_px.samples; })
      .add("seed", "1", "of the flings", [](S) { return kFlingSeed; })
      .add("other_contacts", "1",
           "flings that meet a side wall or the top another number of times at some rate",
           [](S score) { return score.other_contacts.count; });
}

Table shift_table(const std::vector<DisplayShift>& shifts) {
  using S = const DisplayShift&;
  return table_by_method(
             "shifts",
             "distance from where the same fling settles at 60 Hz, and from where the exact fling does",
             shifts)
      .add_band("shift", "px", "from 60 Hz", &DisplayShift::shift_px, "shift_median")
      .add_band("off", "px", "from the exact fling", &DisplayShift::off_px, "off_median")
      .add("flings", "1", "played", [](S s) { return s.other_contacts.of; })
      .add_share("other_contacts", "flings that meet a side wall or the top another number of times",
                 &DisplayShift::other_contacts);
}

// As printed: by the paper's step and by time, every frame the same.
Table shown_shifts(const FrameRateStudy& study) {
  using S = const DisplayShift&;
  Table table{"shifts", "", {}};
  for (const auto& [method, name] : {std::pair(std::size_t{0}, std::string("paper")), {1, "by_time"}}) {
    std::vector<DisplayShift> steady;
    for (const DisplayShift& shift : study.shifts)
      if (shift.clock == DisplayClock::steady && shift.method == method) steady.push_back(shift);
    if (method == 0)
      table.columns = {column_of("rate", "Hz", "display rate", steady, &DisplayShift::rate_hz)};
    const auto add = [&, name = name](const std::string& what, const auto& text) {
      table.columns.push_back(column_of(name + what, "", "", steady, text));
    };
    add("_off_60_Hz,_px", [](S s) { return interval_text(s.shift_px); });
    add("_off_exact,_px", [](S s) { return interval_text(s.off_px); });
    add("_other_contacts_in",
        [](S s) { return fmt::format("{} of {}", s.other_contacts.count, s.other_contacts.of); });
  }
  return table;
}

Table shown_scores(const std::vector<Independence>& scores) {
  return table_by_method("scores", "", scores)
      .add("spread,_px", "", [](const Independence& score) { return interval_text(score.spreads_px); })
      .add("path", "px", &Independence::way_px)
      .add("score", "1", &Independence::score);
}

// "every frame the same: drag and friction by time spread less in 118 of 121 flings (93 .. 99 %)".
std::string steadier_text(std::size_t clock, const Share& steadier) {
  return fmt::format("{}: drag and friction by time spread less in {}", kClockTexts[clock],
                     share_text(steadier, "flings"));
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

Verdict verdict_of(const FrameRateStudy& study) {
  Table landings{"displays", "", {}};
  for (const auto& [method, name] : {std::pair(std::size_t{0}, std::string("paper")), {1, "by_time"}}) {
    const std::vector<Landing> drawn = drawn_landings(study, method, DisplayClock::steady);
    if (method == 0) landings.columns = {column_of("rate", "Hz", "display rate", drawn, &Landing::rate_hz)};
    landings.columns.push_back(column_of(
        name + "_settles_at", "px", "", drawn, [](const Landing& l) { return l.end.x_px; }, 5));
    landings.columns.push_back(column_of(name + "_after", "s", "", drawn, &Landing::time_s, 3));
    landings.columns.push_back(column_of(name + "_path", "px", "", drawn, &Landing::path_px));
  }
  Verdict verdict{
      {"frame-rate: one fling on every display, by the paper's step and with drag and friction by time",
       std::move(landings),
       fmt::format(
           "The fling and {} random ones (seed {}, jitter seeds {} .. {}): distance from where a fling "
           "settles at 60 Hz, and from where the exact fling does, median (10 .. 90 %)",
           study.steadier_by_time[0].of - 1, kFlingSeed, kJitterSeed, kJitterSeed + kJitterSeeds - 1),
       shown_shifts(study),
       std::string("Spread of the places where a fling settles over the displays; frame-rate independence, "
                   "100 (1 - mean spread / mean horizontal path):"),
       shown_scores(study.scores)},
      {}};
  for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock)
    verdict.text.push_back(steadier_text(clock, study.steadier_by_time[clock]) + ".");
  for (const Landing& landing : study.landings)
    if (!landing.is_core) {
      verdict.broken.push_back(
          fmt::format("{:g} Hz, {}: the method called the paper's step differs from the core",
                      landing.rate_hz, clock_name(landing.clock)));
      break;
    }
  for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock)
    if (!(study.steadier_by_time[clock].low() > 0.5))
      verdict.broken.push_back(steadier_text(clock, study.steadier_by_time[clock]) +
                               ": they are no more independent of the frame rate than the paper's step");
  return verdict;
}

Result run_frame_rate(const StudyRequest& request) {
  constexpr std::int64_t kFlings = 120, kQuickFlings = 100;
  return frame_rate_result(
      request.is_quick
          ? study_frame_rate(request.core, {24.0, 60.0, 144.0, 240.0}, kQuickFlings)
          : study_frame_rate(request.core, {kLandingRates_hz.begin(), kLandingRates_hz.end()}, kFlings));
}

}  // namespace

Result frame_rate_result(const FrameRateStudy& study) {
  return {.tables = {landing_table(study.landings), score_table("independence", study.scores),
                     path_table(study.paths), shift_table(study.shifts)},
          .figures = frame_rate_figures(study),
          .verdict = verdict_of(study),
          .summary = summary_of(study)};
}

Study frame_rate_study() {
  return {
      .name = "frame-rate", .summary = "one fling on every display, steady or not", .run = run_frame_rate};
}

}  // namespace hyrax
