#include "tools/hyrax-sim/study_frame_rate.h"

#include <fmt/format.h>

#include "sim/study/frame_rate/frame_rate.h"
#include "tools/report/frame_rate_figures.h"

namespace hyrax {
namespace {

constexpr std::size_t kClocks = kDisplayClockNames.size();

FrameRateStudy study(bool is_quick) {
  if (is_quick) return study_frame_rate({24.0, 60.0, 144.0, 240.0}, 6);
  return study_frame_rate({24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 72.0, 75.0, 90.0, 100.0, 120.0, 144.0, 165.0,
                           200.0, 240.0, 360.0, 500.0, 1000.0},
                          40);
}

const Landing& landing_of(const FrameRateStudy& study, std::size_t method, double rate_hz) {
  for (const Landing& landing : study.landings)
    if (landing.method == method && landing.clock == DisplayClock::steady && landing.fling == 0 &&
        landing.rate_hz == rate_hz)
      return landing;
  return study.landings.front();
}

std::string verdict_text(const FrameRateStudy& study) {
  std::string text =
      "frame-rate: one fling on every display, by the paper's step and with drag and friction by time\n";
  text += fmt::format("  {:>10}  {:>30}  {:>30}\n", "", "paper", "by time");
  text += fmt::format("  {:>10} {:>10} {:>8} {:>12} {:>10} {:>8} {:>12}\n", "display", "lies at px",
                      "after s", "path px", "lies at px", "after s", "path px");
  for (const Landing& paper : study.landings) {
    if (paper.method != 0 || paper.clock != DisplayClock::steady || paper.fling != 0) continue;
    const Landing& other = landing_of(study, 1, paper.rate_hz);
    text += fmt::format("  {:>7.0f} Hz {:>10.1f} {:>8.2f} {:>12.0f} {:>10.1f} {:>8.2f} {:>12.0f}\n",
                        paper.rate_hz, paper.x_px, paper.time_s, paper.path_px, other.x_px, other.time_s,
                        other.path_px);
  }
  text += fmt::format(
      "  frame-rate independence, 100 (1 - spread of the resting places / way across), mean of all flings\n");
  for (std::size_t clock = 0; clock < kClocks; ++clock) {
    const Independence& paper = study.scores[clock];
    const Independence& other = study.scores[kClocks + clock];
    text +=
        fmt::format("  {:<34} paper {:>5.1f} (spread {:.0f} px)   by time {:>5.1f} (spread {:.0f} px)\n",
                    kDisplayClockWords[clock], paper.score, paper.spread_px, other.score, other.spread_px);
  }
  return text;
}

std::vector<std::string> broken_sentences(const FrameRateStudy& study) {
  std::vector<std::string> broken;
  for (const Landing& landing : study.landings)
    if (!landing.is_core) {
      broken.push_back(
          fmt::format("{:g} Hz, {}: the method called the paper's step is not the core, bit for bit",
                      landing.rate_hz, kDisplayClockNames[static_cast<std::size_t>(landing.clock)]));
      break;
    }
  for (std::size_t clock = 0; clock < kClocks; ++clock)
    if (study.scores[kClocks + clock].score <= study.scores[clock].score)
      broken.push_back(fmt::format(
          "{}: drag and friction by time ({:.1f}) make it no more independent of the frame rate "
          "than the paper's step ({:.1f})",
          kDisplayClockWords[clock], study.scores[kClocks + clock].score, study.scores[clock].score));
  return broken;
}

Json::Object json_of(const FrameRateStudy& study) {
  Json::Array landings, scores;
  for (const Landing& landing : study.landings)
    if (landing.fling == 0)
      landings.push_back(Json::Object{{"method", kFrameRateMethods[landing.method]},
                                      {"clock", kDisplayClockNames[static_cast<std::size_t>(landing.clock)]},
                                      {"rate_hz", landing.rate_hz},
                                      {"x_px", landing.x_px},
                                      {"time_s", landing.time_s},
                                      {"path_px", landing.path_px}});
  for (const Independence& score : study.scores)
    scores.push_back(Json::Object{{"method", kFrameRateMethods[score.method]},
                                  {"clock", kDisplayClockNames[static_cast<std::size_t>(score.clock)]},
                                  {"spread_px", score.spread_px},
                                  {"way_px", score.way_px},
                                  {"score", score.score}});
  return {{"scores", std::move(scores)}, {"landings", std::move(landings)}};
}

}  // namespace

StudyOutcome make_frame_rate(const StudyRequest& request) {
  const FrameRateStudy frame_rate = study(request.is_quick);
  return {.tables = {landing_table(frame_rate.landings), independence_table(frame_rate.scores),
                     path_table(frame_rate.paths)},
          .figures = {{"", resting_places_script(frame_rate)},
                      {"-fan", fan_script(frame_rate, 0)},
                      {"-fan-by-time", fan_script(frame_rate, 1)}},
          .verdict = verdict_text(frame_rate),
          .broken = broken_sentences(frame_rate),
          .json = json_of(frame_rate)};
}

}  // namespace hyrax
