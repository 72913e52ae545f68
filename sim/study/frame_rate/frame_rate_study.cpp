// `hyrax-sim study frame-rate`: its tables, figures and verdict.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "sim/study/display_rates.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/study/study.h"

namespace hyrax {
namespace {

std::string_view clock_name(DisplayClock clock) {
  return kDisplayClockNames[static_cast<std::size_t>(clock)];
}

template <class Record>
Column method_column(const std::vector<Record>& records) {
  return column_of("method", "", "method", records,
                   [](const Record& record) { return kFrameRateMethods[record.method]; });
}
template <class Record>
Column clock_column(const std::vector<Record>& records) {
  return column_of("clock", "", "the display's clock", records,
                   [](const Record& record) { return clock_name(record.clock); });
}
template <class Record>
Column rate_column(const std::vector<Record>& records) {
  return column_of("rate", "Hz", "display rate", records, &Record::rate_hz);
}
Table landing_table(const std::vector<Landing>& landings) {
  return {
      "landings",
      "where and when flings settle, and after which distance",
      {method_column(landings), clock_column(landings), rate_column(landings),
       column_of("fling", "1", "number of the fling; 0 is the one that is drawn", landings, &Landing::fling),
       column_of("x", "px", "where it settles", landings, &Landing::x_px),
       column_of("time", "s", "since when it has been within half a pixel of that place", landings,
                 &Landing::time_s),
       column_of("off", "px", "distance from where the exact fling settles", landings, &Landing::off_px),
       column_of("path", "px", "length of the path, of the drawn fling and near 60 Hz by the paper's step",
                 landings, &Landing::path_px),
       column_of("across", "px", "horizontal part of the path", landings, &Landing::across_px)}};
}

Table path_table(const std::vector<FanPoint>& paths) {
  return {"paths",
          "the drawn fling at some rates",
          {method_column(paths), rate_column(paths), column_of("t", "s", "time", paths, &FanPoint::t_s),
           column_of("x", "px", "position", paths, &FanPoint::x_px),
           column_of("y", "px", "position", paths, &FanPoint::y_px)}};
}

Table score_table(const std::string& name, const std::vector<Independence>& scores) {
  return {name,
          "frame-rate independence",
          {method_column(scores), clock_column(scores),
           column_of("spread", "px", "spread of the places where a fling settles over all rates, mean",
                     scores, &Independence::spread_px),
           column_of("way", "px", "horizontal path of a fling at 60 Hz, mean", scores, &Independence::way_px),
           column_of("score", "1", "100 (1 - spread / way), at least 0", scores, &Independence::score),
           column_of("spread_median", "px", "spread of a fling, median", scores,
                     [](const Independence& score) { return score.spreads_px.median; }),
           column_of("spread_low", "px", "spread of a fling, 10 %", scores,
                     [](const Independence& score) { return score.spreads_px.low; }),
           column_of("spread_high", "px", "spread of a fling, 90 %", scores,
                     [](const Independence& score) { return score.spreads_px.high; }),
           column_of("flings", "1", "played", scores,
                     [](const Independence& score) { return score.spreads_px.samples; }),
           column_of("seed", "1", "of the flings", scores, [](const Independence&) { return kFlingSeed; }),
           column_of("other_contacts", "1",
                     "flings that meet a side wall or the top another number of times at some rate", scores,
                     [](const Independence& score) { return score.other_contacts.count; })}};
}

Table shift_table(const std::vector<DisplayShift>& shifts) {
  using S = const DisplayShift&;
  const auto part_of = [&](Band DisplayShift::*band, const std::string& name, const std::string& what,
                           double Band::*part) {
    return column_of(name, "px", what, shifts, [band, part](S s) { return s.*band.*part; });
  };
  constexpr auto kShift = &DisplayShift::shift_px, kOff = &DisplayShift::off_px;
  return {"shifts",
          "distance from where the same fling settles at 60 Hz, and from where the exact fling does",
          {method_column(shifts), clock_column(shifts), rate_column(shifts),
           part_of(kShift, "shift_median", "from 60 Hz, median", &Band::median),
           part_of(kShift, "shift_low", "from 60 Hz, 10 %", &Band::low),
           part_of(kShift, "shift_high", "from 60 Hz, 90 %", &Band::high),
           part_of(kOff, "off_median", "from the exact fling, median", &Band::median),
           part_of(kOff, "off_low", "from the exact fling, 10 %", &Band::low),
           part_of(kOff, "off_high", "from the exact fling, 90 %", &Band::high),
           column_of("flings", "1", "played", shifts, [](S s) { return s.other_contacts.of; }),
           column_of("other_contacts", "1", "flings that meet a side wall or the top another number of times",
                     shifts, [](S s) { return s.other_contacts.count; }),
           column_of("other_contacts_share_low", "1", "95 % interval of their share", shifts,
                     [](S s) { return s.other_contacts.low(); }),
           column_of("other_contacts_share_high", "1", "95 % interval of their share", shifts,
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
    for (const auto& [what, band] : {std::pair("_off_60_Hz,_px", &DisplayShift::shift_px),
                                     std::pair("_off_exact,_px", &DisplayShift::off_px)})
      table.columns.push_back(column_of(name + what, "", "", steady[method], [band = band](S s) {
        return fmt::format("{:.0f} ({:.0f} .. {:.0f})", (s.*band).median, (s.*band).low, (s.*band).high);
      }));
    table.columns.push_back(column_of(name + "_other_contacts_in", "", "", steady[method], [](S s) {
      return fmt::format("{} of {}", s.other_contacts.count, s.other_contacts.of);
    }));
  }
  return table;
}

Table shown_scores(const std::vector<Independence>& scores) {
  return {"scores",
          "",
          {method_column(scores), clock_column(scores),
           column_of("spread,_px", "", "", scores,
                     [](const Independence& score) {
                       return fmt::format("{:.0f} ({:.0f} .. {:.0f})", score.spreads_px.median,
                                          score.spreads_px.low, score.spreads_px.high);
                     }),
           column_of("path", "px", "", scores, &Independence::way_px),
           column_of("score", "1", "", scores, &Independence::score)}};
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

Verdict verdict_of(const FrameRateStudy& study) {
  const std::vector<Landing> paper = drawn_landings(study, 0, DisplayClock::steady);
  const std::vector<Landing> by_time = drawn_landings(study, 1, DisplayClock::steady);
  Table landings{"displays", "", {rate_column(paper)}};
  for (const auto& [name, records] : {std::pair{"paper", &paper}, std::pair{"by_time", &by_time}}) {
    const std::string prefix = std::string(name) + "_";
    landings.columns.push_back(column_of(prefix + "settles_at", "px", "", *records, &Landing::x_px, 5));
    landings.columns.push_back(column_of(prefix + "after", "s", "", *records, &Landing::time_s, 3));
    landings.columns.push_back(column_of(prefix + "path", "px", "", *records, &Landing::path_px));
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
