// Work and precision: what every method costs, and how far it is from the fixed laws, at every rate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/estimate.h"
#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/study/methods/cost.h"
#include "sim/study/methods/method.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/methods/problem.h"

namespace hyrax {

/// The flings of a band, and the seed of their starts.
inline constexpr std::int64_t kBandFlings = 120;
inline constexpr std::uint64_t kBandSeed = 13;
/// How far their starts and speeds are from the problem's. In a frame of 60 Hz a sprite moves some 20 px, so
/// that impacts fall on every phase of a frame.
inline constexpr double kBandStart_px = 20.0;
inline constexpr double kBandSpeed_rel = 0.05;

/// `count` problems like one: the start anywhere within kBandStart_px in x and y, inside the first bounds,
/// each speed within kBandSpeed_rel of itself, jitter of seeds of their own. The first is the problem itself.
[[nodiscard]] std::vector<Problem> problems_like(const Problem& problem, std::int64_t count);

/// Of a histogram: flings whose error is from `low` to less than `high`.
struct ErrorBin {
  double low = 0.0;
  double high = 0.0;
  std::int64_t flings = 0;
};
/// At most some ten bins of equal widths with few digits, from the smallest error to the largest. What is not
/// finite is in none.
[[nodiscard]] std::vector<ErrorBin> histogram_of(std::vector<double> errors);

/// One method at one rate, over problems_like(problem, kBandFlings).
struct MethodBands {
  std::size_t problem = 0;
  std::size_t method = 0;
  double rate_hz = 0.0;
  Band position_px = {};                ///< Largest distance from the exact fling.
  Band end_px = {};                     ///< Distance of the last positions.
  Band energy_rel = {};                 ///< MethodErrors::energy_rel,
  std::vector<ErrorBin> energies = {};  ///< and their histogram.
  Share nearer = {};                 ///< Flings that end nearer to the exact place than by the paper's step.
  Share other_contacts = {};         ///< MethodErrors::has_other_contacts.
  std::int64_t beyond_rounding = 0;  ///< Flings whose distance is more than rounding.
};

/// Of all methods that meet walls, but adaptive ones and the reference; `problem` is left 0.
/// REQUIRES: the first method is the paper's step.
[[nodiscard]] std::vector<MethodBands> method_bands(const Core& core, const Problem& problem,
                                                    const std::vector<MethodKind>& methods,
                                                    const std::vector<double>& rates_hz);

/// "it is nearer", "it is farther", or "not decided by 120 flings" where the 95 % interval of the share has
/// one half in it.
[[nodiscard]] std::string nearness_text(const Share& nearer);

/// One method at one rate, or at one tolerance, on one problem.
struct WorkPoint {
  std::size_t problem = 0;  ///< Index into SpeedError::problems,
  std::size_t method = 0;   ///< and into its methods.
  /// Of the frames; of the reference kRowRate_hz, of an adaptive method that and end_only_hz.
  double rate_hz = 0.0;
  MethodErrors errors;
  Cost cost = {};          ///< Of a simulated second, without the run's set-up; not measured if it failed.
  bool is_pareto = false;  ///< No other ranked point of its problem is as accurate, and ranked cheaper.
};

/// What a run costs before its first frame: the time of a run without frames.
struct SetUp {
  std::size_t problem = 0;
  std::size_t method = 0;
  Cost cost = {};
};

/// log(error) = order * log(dt) + constant, by least squares.
struct PowerFit {
  double order = 0.0;
  double standard_error = kNotGiven;  ///< Of the order; none of two points.
  double least = 0.0;                 ///< Of the orders of neighbouring points,
  double most = 0.0;                  ///< and the largest.
};

/// Over the rates at which the error is more than rounding; none where shorter frames do not always make it
/// smaller. With walls it is the median over flings like the problem, without a standard error,
/// with their 10 and 90 % as `least` and `most`, where the medians of their errors become smaller.
struct OrderFit : PowerFit {
  std::size_t problem = 0;
  std::size_t method = 0;
  std::size_t points = 0;
  double low_hz = 0.0;   ///< The lowest rate that it is fitted to,
  double high_hz = 0.0;  ///< and the highest.
  std::int64_t flings = 1;
};
inline constexpr std::int64_t kOrderFlings = 200;

/// The least error of a method over a problem at any rate from one to another: of a scan, refined around its
/// minimum.
struct LeastError {
  std::size_t problem = 0;
  std::size_t method = 0;
  double rate_hz = 0.0;
  double position_px = kNotGiven;  ///< NaN: the method failed at every rate.
};
/// @param rates_hz the lowest first, the highest last.
[[nodiscard]] LeastError least_error(const Core& core, const Problem& problem, const MethodKind& kind,
                                     const std::vector<double>& rates_hz);

/// The paper's step in the free flight of a problem against three laws, by sim/reference.
struct PaperErrors {
  double rate_hz = 0.0;
  double implementation_px = 0.0;  ///< Against its own closed form: rounding.
  double truncation_px = 0.0;      ///< Against the matched ODE, whose drag rate is that of this frame.
  double model_px = 0.0;           ///< Against the fixed ODE.
  /// The truncation by its closed form, the largest after n frames: with c = a / (1 - a) + 1 / ln a and
  /// f = 1 - a^n, c h f vx in x and c h (g n h + f (vy - g h (a / (1 - a) - 1 / ln a))) in y.
  double truncation_expected_px = 0.0;
};

/// Into SpeedError::points.
using PointIndex = std::optional<std::size_t>;

/// The cheapest ranked point below an error, and the cheapest of the paper's step.
struct CheapestBelow {
  std::size_t problem = 0;
  double error_px = 0.0;
  PointIndex point = {};  ///< None: no method is so accurate.
  /// Others below the error than which `point` is not ranked cheaper, or whose cost is not measured.
  std::vector<std::size_t> as_cheap = {};
  PointIndex paper_point = {};  ///< None: the paper's step is not, at any rate that is ranked.
};

struct SpeedError {
  FixedLaws laws = FixedLaws();  ///< Of the exact fling.
  std::vector<Problem> problems;
  std::vector<MethodKind> methods;
  std::vector<WorkPoint> points;
  std::vector<SetUp> set_ups;
  std::vector<MethodBands> bands;  ///< Over flings like those of the problems that meet walls.
  std::vector<OrderFit> orders;
  std::vector<LeastError> least;  ///< Of all methods but adaptive ones and the reference.
  std::vector<CheapestBelow> cheapest;
  std::vector<PaperErrors> paper;  ///< Of the first problem, if it is free flight.
  ClockProbe probe;
  CostOptions cost = {};               ///< As it was measured.
  std::int64_t comparisons = 0;        ///< Pairs of comparable points of one problem,
  std::int64_t ranked_pairs = 0;       ///< and those of which one is ranked cheaper.
  double low_hz = 0.0, high_hz = 0.0;  ///< The rates.
};

struct SpeedErrorOptions {
  std::vector<double> rates_hz;             ///< Each kRowRate_hz times a power of two, from the lowest.
  std::vector<double> band_rates_hz = {};   ///< Rates of `bands`; empty: there are none.
  std::vector<double> order_rates_hz = {};  ///< To which orders with walls are fitted; empty: there are none.
  std::int64_t order_flings = kOrderFlings;  ///< Like a problem, of which orders with walls are medians.
  CostOptions cost = {};                     ///< Its processes: as many as the comparisons take.
  std::vector<double> errors_asked_px = {100.0, 10.0, 1.0,
                                         0.1,   0.01, 1e-6};  ///< What is cheapest below each?
};

/// Costs are compared like with like: with kRowRate_hz rows a second. A slower rate gives fewer, and the
/// reference method is the limit: neither is compared, nor a method that failed.
[[nodiscard]] bool is_comparable(const SpeedError& study, const WorkPoint& point);
/// Of which the cost is measured, too.
[[nodiscard]] bool is_ranked(const SpeedError& study, const WorkPoint& point);

/// Whether the study ranks the cost of one as cheaper: see is_cheaper. REQUIRES: points of one problem.
[[nodiscard]] bool is_ranked_cheaper(const SpeedError& study, const WorkPoint& a, const WorkPoint& b);
/// Counts SpeedError::comparisons, and once costs are measured ranked_pairs.
void count_pairs(SpeedError& study);

/// The rate at which a free flight is one frame: an adaptive method gives its end, and no other row.
[[nodiscard]] double end_only_hz(const Problem& problem);

/// Methods that know no walls play the problems of free flight only. SpeedError::paper is empty if the first
/// problem is not free flight. REQUIRES: a problem; the paper's step is the first method.
[[nodiscard]] SpeedError study_speed_error(const Core& core, std::vector<Problem> problems,
                                           std::vector<MethodKind> methods, const SpeedErrorOptions& options,
                                           const CostMeter& measure_costs);

/// The rules that do not hold, each a sentence with method, problem and rate; never about a time.
[[nodiscard]] std::vector<std::string> broken_rules(const SpeedError& study);

/// "the paper's step, 60 Hz".
[[nodiscard]] std::string point_text(const SpeedError& study, std::size_t point);

/// The tables points, orders, cheapest, paper, clock, set_up, bands, least.
/// @param machine on which the costs were measured, as below.
[[nodiscard]] std::vector<Table> speed_error_tables(const SpeedError& study, const std::string& machine);

/// One screen: the first problem, and the fling or the last of the scenarios that were given.
[[nodiscard]] Verdict speed_error_verdict(const SpeedError& study, const std::string& machine,
                                          bool has_scenarios);

/// The study's own members of the JSON document.
[[nodiscard]] std::vector<Table> speed_error_summary(const SpeedError& study, const std::string& machine);

/// The work-precision diagram of a problem: error against cost with its interval and the Pareto front, and
/// error against dt; a line a method, with its fitted order in the legend, and a gap where the method failed.
[[nodiscard]] Figure speed_error_figure(const SpeedError& study, std::size_t problem,
                                        const std::string& machine);

/// The largest distances over the flings like a problem, at 60 Hz, a line a method; nothing without bands.
[[nodiscard]] std::optional<Figure> bands_figure(const SpeedError& study, std::size_t problem);
/// The histogram of their energy errors by the paper's step.
[[nodiscard]] std::optional<Figure> energies_figure(const SpeedError& study, std::size_t problem);

/// How drag per frame keeps the paper's step from converging, with the values of this study; empty if
/// SpeedError::paper has no 60 Hz, or there is no drag.
[[nodiscard]] std::vector<std::string> convergence_sentences(const SpeedError& study);

/// Order of errors (> 0) against dt. REQUIRES: two points or more, in the order of dt.
[[nodiscard]] PowerFit fitted_power(const std::vector<double>& dt_s, const std::vector<double>& errors);

/// Sets WorkPoint::is_pareto of all points: ranked ones than which no other that is as accurate, to a
/// thousandth, is ranked cheaper. Errors that are no more than rounding are equal; a NaN is not accurate.
void mark_pareto(SpeedError& study);

}  // namespace hyrax
