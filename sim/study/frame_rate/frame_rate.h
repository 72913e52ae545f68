// One fling at many displays: where, when and how it ends at each frame rate, by the paper's step and by the
// same step with its drag and friction taken by time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/compare/rate_ladder.h"
#include "sim/core/core.h"
#include "sim/motion/state.h"
#include "sim/result/estimate.h"
#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/scenario/scenario.h"
#include "sim/study/methods/many_flings.h"
#include "sim/trace/step_player.h"

namespace hyrax {

enum class DisplayClock : std::uint8_t { steady, jittered, missing };
inline constexpr std::array<std::string_view, 3> kDisplayClockNames = {"steady", "jittered", "missing"};

inline constexpr std::array<std::string_view, 2> kFrameRateMethods = {"paper", "normalised-drag"};

/// For readers.
inline constexpr std::array<std::string_view, 3> kClockTexts = {
    "every frame the same", "frames jittered by 2 ms (normal)", "one frame in twenty missed"};
inline constexpr std::array<std::string_view, 2> kMethodTexts = {"the paper's step",
                                                                 "drag and friction by time"};

/// Of a State.
inline constexpr std::array<std::string_view, 4> kStateNames = {"x", "y", "vx", "vy"};

/// The end of one fling.
struct Landing {
  std::size_t method = 0;  ///< In kFrameRateMethods.
  DisplayClock clock = DisplayClock::steady;
  double rate_hz = 0.0;
  std::int64_t fling = 0;  ///< 0 is the one that is drawn; the others are random (ManyFlings).
  State end = {};          ///< Where it settles.
  double off_px = 0.0;     ///< Distance of that place from the one where the exact fling settles.
  double time_s = 0.0;     ///< Since when it has stayed there within half a pixel; NaN: it has not settled.
  /// Length of its path; NaN where the fling is played by sim/ensemble, which keeps no path: a random one by
  /// the paper's step, at a rate that is not nearest to 60 Hz.
  double path_px = kNotGiven;
  double across_px = kNotGiven;  ///< Horizontal part of the path.
  WallCounts contacts = {};
  /// In the second after its end: the values that still change from row to row, by more than a billionth of
  /// themselves, and the largest distance from the end.
  std::array<bool, kStateNames.size()> changes = {};
  double moves_px = 0.0;
  bool is_core = true;  ///< Of the paper's method: it has the core's bits, step by step and by sim/ensemble.
};

/// The drawn fling by a traced step, beside the same operations in wider arithmetic: sums, products and
/// quotients in double-double, functions in `long double`. Constants are as the header rounds them, ints are
/// never rounded. Both take the paths that their own comparisons decide.
struct Rounding {
  double rate_hz = 0.0;
  double largest_px = 0.0;  ///< The largest distance of both, and the first row that has it.
  std::int64_t largest_row = 0;
  std::int64_t other_path_from = -1;  ///< The first row in which they take different paths; -1: none.
  /// The first row, before that, in which a value has lost half its digits: 26 of 53 bits, 12 of 24 if the
  /// step has a `float`; and the value, as a reader of the header would write it. -1: none.
  std::int64_t lost_row = -1;
  std::string lost = {};
};
[[nodiscard]] Rounding rounding_of(const StepProgram& step, double rate_hz, double duration_s);
/// Whether an operation of the step is that of a `float`.
[[nodiscard]] bool has_float(const StepProgram& step);

/// A point of the drawn fling's path.
struct FanPoint {
  std::size_t method = 0;
  double rate_hz = 0.0;
  double t_s = 0.0;
  double x_px = 0.0;
  double y_px = 0.0;
};

/// Frame-rate independence of a method under a clock: with S the spread of the places where a fling
/// settles over all rates and D its horizontal path at the rate nearest to 60 Hz, each averaged over the
/// flings,
///   score = 100 (1 - S / D), and 0 where S > D.
/// 100: the same place on every display. 0: the display decides where it goes more than the hand.
struct Independence {
  std::size_t method = 0;
  DisplayClock clock = DisplayClock::steady;
  double spread_px = 0.0;
  double way_px = 0.0;
  double score = 0.0;
  Band spreads_px = {};       ///< Of the flings' spreads.
  Share other_contacts = {};  ///< Flings that have other contacts (DisplayShift) at some rate.
};

/// A method on one display against the same flings at the rate nearest to 60 Hz, and against the exact ones.
struct DisplayShift {
  std::size_t method = 0;
  DisplayClock clock = DisplayClock::steady;
  double rate_hz = 0.0;
  Band shift_px = {};  ///< Distance of the places where a fling settles.
  Band off_px = {};    ///< Landing's.
  Share other_contacts =
      {};  ///< Flings with another number of contacts with the left wall, right wall or top.
  Share settled = {};
  std::optional<Band> settles_s = {};                          ///< Landing's, of those that have settled.
  std::array<std::int64_t, kStateNames.size()> changing = {};  ///< Flings of which a value still changes.
  double moves_px = 0.0;                                       ///< The most that a settled one moves.
};

struct FrameRateStudy {
  double until_s = 0.0;  ///< Each fling is played for so long.
  bool is_cut = false;   ///< Some may take longer to settle.
  bool has_drag = true;  ///< Else there is hardly anything to take by time.
  bool has_float = false;
  std::vector<Landing> landings;
  std::vector<Rounding> roundings;   ///< By rate; empty: the step is not complete.
  std::optional<RateLadder> ladder;  ///< The drawn fling's, of a core without constants.
  std::vector<FanPoint> paths;
  std::vector<Independence> scores;  ///< By method, then by clock.
  std::vector<DisplayShift> shifts;  ///< By method, clock and rate.
  /// By clock: flings whose spread is smaller with drag and friction by time.
  std::array<Share, kDisplayClockNames.size()> steadier_by_time;
};
/// Of a core without constants the ladder and the roundings alone. @param flings random ones, beside the one
/// that is drawn. REQUIRES: at least one rate and one fling.
[[nodiscard]] FrameRateStudy study_frame_rate(const Core& core, const std::vector<double>& rates_hz,
                                              std::int64_t flings, const StepProgram* step = nullptr);

/// The drawn fling's landings by one method under one clock.
[[nodiscard]] std::vector<Landing> drawn_landings(const FrameRateStudy& study, std::size_t method,
                                                  DisplayClock clock);

/// The drawn fling, in kDesktop.
inline constexpr State kDrawnFling{100.0, 100.0, 900.0, -1200.0};

/// Where the drawn fling settles against the display rate, how far off many flings settle, the path of the
/// drawn one by either method.
[[nodiscard]] std::vector<Figure> frame_rate_figures(const FrameRateStudy& study);

/// Tables, figures and verdict of the study. Broken: the paper's method is not the core's, flings that have
/// not settled on even frames though they were played for long enough, or drag and friction by time spread
/// less in no more than half of the flings, beyond the interval.
[[nodiscard]] Result frame_rate_result(const FrameRateStudy& study);

/// Plays it at each rate with even frames; events keep their times. At most 60 s. REQUIRES: of the scenario
/// the parameters are the core's.
[[nodiscard]] RateLadder climb(const Core& core, const Scenario& scenario,
                               const std::vector<double>& rates_hz);

}  // namespace hyrax
