// `hyrax-sim study frame-rate`: its tables, figures and verdict.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

#include "sim/core/listing_core.h"
#include "sim/result/number_text.h"
#include "sim/study/frame_rate/frame_rate.h"
#include "sim/study/frame_rate/ladder_result.h"
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

Table rounding_table(const std::vector<Rounding>& roundings) {
  return StudyTable("roundings", "the drawn fling, and the same operations in wider arithmetic", roundings)
      .add("rate", "Hz", "display rate", &Rounding::rate_hz)
      .add("rounding", "px", "largest distance of both", &Rounding::largest_px)
      .add("in_row", "1", "the first row that has it", &Rounding::largest_row)
      .add("other_path_from", "1", "the first row in which rounding decides a comparison; -1: none",
           &Rounding::other_path_from)
      .add("lost_in_row", "1", "the first row in which a value has lost half its digits; -1: none",
           &Rounding::lost_row)
      .add("lost", "", "that value", &Rounding::lost);
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

Table end_table(const std::vector<DisplayShift>& shifts) {
  StudyTable<std::vector<DisplayShift>> table = table_by_method(
      "ends", "when flings settle, and what still changes in the second after the end", shifts);
  table.add_share("settled", "flings that have settled", &DisplayShift::settled);
  for (const auto& [name, what, part] : {std::tuple("time_median", "time to settle, median", &Band::median),
                                         {"time_low", "time to settle, 10 %", &Band::low},
                                         {"time_high", "time to settle, 90 %", &Band::high}})
    table.add(name, "s", what, [part = part](const DisplayShift& shift) {
      return shift.settles_s ? *shift.settles_s.*part : kNotGiven;
    });
  for (std::size_t each = 0; each < kStateNames.size(); ++each)
    table.add(std::string(kStateNames[each]) + "_changes", "1",
              "flings of which it still changes by more than a billionth of itself",
              [each](const DisplayShift& shift) { return shift.changing[each]; });
  return table.add("moves", "px", "the most that a settled sprite moves", &DisplayShift::moves_px);
}

// As printed: by the paper's step, every frame the same.
Table shown_ends(const std::vector<DisplayShift>& shifts) {
  std::vector<DisplayShift> steady;
  std::ranges::copy_if(shifts, std::back_inserter(steady), [](const DisplayShift& shift) {
    return shift.method == 0 && shift.clock == DisplayClock::steady;
  });
  StudyTable table("ends", "", steady);
  table.add("rate", "Hz", &DisplayShift::rate_hz)
      .add("settled", "",
           [](const DisplayShift& shift) {
             return fmt::format("{} of {}", shift.settled.count, shift.settled.of);
           })
      .add("after,_s", "", [](const DisplayShift& shift) {
        return shift.settles_s ? interval_text(*shift.settles_s, 2) : "-";
      });
  for (std::size_t each = 0; each < kStateNames.size(); ++each)
    table.add(std::string(kStateNames[each]) + "_changes_in", "1",
              [each](const DisplayShift& shift) { return shift.changing[each]; });
  return table.add("moves", "px", &DisplayShift::moves_px);
}

// As printed: by the paper's step and by time, every frame the same.
Table shown_shifts(const FrameRateStudy& study) {
  using S = const DisplayShift&;
  std::array<std::vector<DisplayShift>, kFrameRateMethods.size()> steady;
  for (const DisplayShift& shift : study.shifts)
    if (shift.clock == DisplayClock::steady) steady[shift.method].push_back(shift);
  Table table{"shifts", "", {column_of("rate", "Hz", "display rate", steady[0], &DisplayShift::rate_hz)}};
  const auto add = [&](const std::string& what, const auto& text) {
    table.columns.push_back(column_of("paper_" + what, "", "", steady[0], text));
    table.columns.push_back(column_of("by_time_" + what, "", "", steady[1], text));
  };
  add("off_60_Hz,_px", [](S s) { return interval_text(s.shift_px); });
  add("off_exact,_px", [](S s) { return interval_text(s.off_px); });
  add("other_contacts_in",
      [](S s) { return fmt::format("{} of {}", s.other_contacts.count, s.other_contacts.of); });
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
  return {score_table("scores", study.scores), std::move(landings), shift_table(study.shifts),
          end_table(study.shifts), rounding_table(study.roundings)};
}

// "The same fling ends at 1,139 px at 24 Hz and 1,701 px at 240 Hz.": at the slowest display and the fastest
// that people have.
std::string answer_of(const FrameRateStudy& study) {
  constexpr double kFast_hz = 240.0;
  const std::vector<Landing> drawn = drawn_landings(study, 0, DisplayClock::steady);
  const Landing& slow = *std::ranges::min_element(drawn, {}, &Landing::rate_hz);
  const Landing& fast = *std::ranges::min_element(
      drawn, {}, [](const Landing& landing) { return std::fabs(landing.rate_hz - kFast_hz); });
  const bool has_settled = !std::isnan(slow.time_s) && !std::isnan(fast.time_s);
  return fmt::format("The same fling {} at {} px at {:g} Hz and {} px at {:g} Hz.",
                     has_settled ? "ends" : fmt::format("is after {:g} s", study.until_s),
                     with_decimals(slow.end.x_px, 0), slow.rate_hz, with_decimals(fast.end.x_px, 0),
                     fast.rate_hz);
}

// Over all rates, by the paper's step, every frame the same.
std::string ends_text(const FrameRateStudy& study) {
  DisplayShift all;
  for (const DisplayShift& shift : study.shifts) {
    if (shift.method != 0 || shift.clock != DisplayClock::steady) continue;
    all.settled.count += shift.settled.count;
    all.settled.of += shift.settled.of;
    all.moves_px = std::max(all.moves_px, shift.moves_px);
    for (std::size_t each = 0; each < all.changing.size(); ++each) all.changing[each] += shift.changing[each];
  }
  std::string text =
      fmt::format("{} of {} flings have settled within {:g} s, and move by at most {:.3g} px then;",
                  all.settled.count, all.settled.of, study.until_s, all.moves_px);
  for (std::size_t each = 0; each < all.changing.size(); ++each)
    text += fmt::format("{} {}{} in {}", each == 0 ? "" : ",", kStateNames[each],
                        each == 0 ? " still changes" : "", all.changing[each]);
  return text + (study.is_cut ? ". Some may take longer than that to settle." : ".");
}

std::string rounding_text(const FrameRateStudy& study) {
  if (study.roundings.empty()) return "Rounding is not measured: the build cannot trace the whole step.";
  const Rounding& worst = *std::ranges::max_element(study.roundings, {}, &Rounding::largest_px);
  std::string text = fmt::format("Rounding moves the fling by up to {:.2g} px (at {:g} Hz, row {})",
                                 worst.largest_px, worst.rate_hz, worst.largest_row);
  const auto lost =
      std::ranges::find_if(study.roundings, [](const Rounding& each) { return each.lost_row >= 0; });
  text += lost == study.roundings.end() ? "; no value loses half its digits"
                                        : fmt::format("; {} loses half its digits (at {:g} Hz, row {})",
                                                      lost->lost, lost->rate_hz, lost->lost_row);
  const auto other =
      std::ranges::find_if(study.roundings, [](const Rounding& each) { return each.other_path_from >= 0; });
  if (other != study.roundings.end())
    text +=
        fmt::format("; it decides a comparison (at {:g} Hz, row {})", other->rate_hz, other->other_path_from);
  if (study.has_float)
    text += fmt::format(". Does float matter here? {} than half a pixel",
                        worst.largest_px < RestAnchor::kStill_px ? "No: that is less" : "Yes: that is more");
  return text + ".";
}

std::vector<std::string> broken_rules(const FrameRateStudy& study) {
  std::vector<std::string> broken;
  const auto other = std::ranges::find(study.landings, false, &Landing::is_core);
  if (other != study.landings.end())
    broken.push_back(fmt::format("{:g} Hz, {}: the method called the paper's step differs from the core",
                                 other->rate_hz, clock_name(other->clock)));
  for (const DisplayShift& shift : study.shifts)
    if (!study.is_cut && shift.clock == DisplayClock::steady && shift.settled.count < shift.settled.of)
      broken.push_back(fmt::format("{:g} Hz, {}: {} of {} flings have not settled within {:g} s",
                                   shift.rate_hz, kMethodTexts[shift.method],
                                   shift.settled.of - shift.settled.count, shift.settled.of, study.until_s));
  for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock)
    if (study.has_drag && !(study.steadier_by_time[clock].low() > 0.5))
      broken.push_back(steadier_text(clock, study.steadier_by_time[clock]) +
                       ": they are no more independent of the frame rate than the paper's step");
  return broken;
}

Verdict verdict_of(const FrameRateStudy& study) {
  Table landings{"displays", "", {}};
  for (const auto& [method, name] : {std::pair(std::size_t{0}, std::string("paper")), {1, "by_time"}}) {
    const std::vector<Landing> drawn = drawn_landings(study, method, DisplayClock::steady);
    if (method == 0) landings.columns = {column_of("rate", "Hz", "display rate", drawn, &Landing::rate_hz)};
    landings.columns.push_back(column_of(
        name + "_settles_at", "px", "", drawn,
        [](const Landing& l) { return std::isnan(l.time_s) ? kNotGiven : l.end.x_px; }, 5));
    landings.columns.push_back(column_of(name + "_after", "s", "", drawn, &Landing::time_s, 3));
    landings.columns.push_back(column_of(name + "_path", "px", "", drawn, &Landing::path_px));
  }
  Verdict verdict{
      answer_of(study),
      {"One fling on every display, by the paper's step and with drag and friction by time:",
       std::move(landings),
       fmt::format("The fling and {} random ones (seed {}, jitter seeds {} .. {}) by the paper's step: when "
                   "they settle, median (10 .. 90 %), and what still changes a second later:",
                   study.steadier_by_time[0].of - 1, kFlingSeed, kJitterSeed, kJitterSeed + kJitterSeeds - 1),
       shown_ends(study.shifts), ends_text(study),
       "Distance from where a fling settles at 60 Hz, and from where the exact fling does:",
       shown_shifts(study),
       // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one sentence in two literals.
       "Spread of the places where a fling settles over the displays; frame-rate independence, 100 (1 - mean "
       "spread / mean horizontal path):",
       shown_scores(study.scores)},
      broken_rules(study)};
  for (std::size_t clock = 0; clock < kDisplayClockNames.size(); ++clock)
    verdict.text.emplace_back(steadier_text(clock, study.steadier_by_time[clock]) + ".");
  verdict.text.emplace_back(rounding_text(study));
  return verdict;
}

Result study_scenarios(const StudyRequest& request, const std::vector<double>& rates_hz) {
  std::vector<RateLadder> ladders;
  std::vector<std::string> left_out;
  for (const auto& [path, scenario] : request.scenarios) {
    const RateLadder& ladder = ladders.emplace_back(
        climb(with_parameters(request.core, scenario.parameters).value(), scenario, rates_hz));
    if (ladder.until_s == 0.0) {
      left_out.push_back(scenario.name + ": left out, as no time passes in it.");
      ladders.pop_back();
    }
    if (request.report_progress)
      request.report_progress("scenarios", std::ssize(ladders) + std::ssize(left_out),
                              std::ssize(request.scenarios));
  }
  if (ladders.empty()) throw RequestRefused("hyrax-sim study frame-rate: " + left_out.front());
  return ladder_result(ladders, left_out);
}

Result run_frame_rate(const StudyRequest& request) {
  constexpr std::int64_t kFlings = 120, kQuickFlings = 100;
  std::vector<double> rates_hz(kLandingRates_hz.begin(), kLandingRates_hz.end());
  if (request.is_quick) rates_hz = {24.0, 60.0, 144.0, 240.0};
  if (!request.scenarios.empty()) return study_scenarios(request, rates_hz);
  return frame_rate_result(study_frame_rate(request.core, rates_hz, request.is_quick ? kQuickFlings : kFlings,
                                            request.core_step.get()));
}

}  // namespace

Result frame_rate_result(const FrameRateStudy& study) {
  if (study.ladder) {
    Result result = ladder_result({*study.ladder});
    result.verdict.text.emplace_back(rounding_text(study));
    for (std::vector<Table>* const tables : {&result.tables, &result.summary})
      tables->push_back(rounding_table(study.roundings));
    return result;
  }
  Result result{.tables = {landing_table(study.landings), score_table("independence", study.scores),
                           path_table(study.paths), shift_table(study.shifts), end_table(study.shifts),
                           rounding_table(study.roundings)},
                .figures = frame_rate_figures(study),
                .verdict = verdict_of(study),
                .summary = summary_of(study)};
  result.figures.front().title = headline(result.verdict);
  return result;
}

Study frame_rate_study() {
  return {.name = "frame-rate",
          .summary = "where, when and how flings end at every display rate",
          .needs_paper_step = false,
          .run = run_frame_rate};
}

}  // namespace hyrax
