// Work and precision: what every method costs, and how far it is from the fixed laws, at every rate.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/result/figure.h"
#include "sim/result/table.h"
#include "sim/study/methods/cost.h"
#include "sim/study/methods/method.h"
#include "sim/study/methods/method_errors.h"
#include "sim/study/methods/problem.h"

namespace hyrax {

/// One method at one rate, or at one tolerance, on one problem.
struct WorkPoint {
  std::size_t problem = 0;  ///< Index into SpeedError::problems,
  std::size_t method = 0;   ///< and into its methods.
  double rate_hz = 0.0;     ///< Of the rows; of an adaptive method kCheckRate_hz.
  MethodErrors errors;
  Cost cost;               ///< Per simulated second; 0 of one that failed.
  bool is_pareto = false;  ///< No other point of its problem is both cheaper and more accurate.
};

/// log(error) = order * log(dt) + constant, by least squares over the rates at which the error is more than
/// rounding.
struct OrderFit {
  std::size_t problem = 0;
  std::size_t method = 0;
  std::size_t points = 0;
  double order = 0.0;
};

/// The paper's step in the free flight of a problem against three laws, by sim/reference.
struct PaperErrors {
  double rate_hz = 0.0;
  double implementation_px = 0.0;    ///< Against its own closed form: rounding.
  double truncation_px = 0.0;        ///< Against the matched ODE, whose drag rate is that of this frame.
  double model_px = 0.0;             ///< Against the fixed ODE.
  double truncation_px_per_s = 0.0;  ///< Largest difference of velocity from the matched ODE.
  /// The same by its closed form, g h (1 - a^n) |a / (1 - a) + 1 / ln a| after n frames.
  double truncation_expected_px_per_s = 0.0;
};

/// The cheapest point below an error, and the cheapest of the paper's step.
struct CheapestBelow {
  std::size_t problem = 0;
  double error_px = 0.0;
  std::optional<std::size_t> point;        ///< Into SpeedError::points; none: no method is so accurate.
  std::optional<std::size_t> paper_point;  ///< None: the paper's step is not, at any rate.
};

struct SpeedError {
  std::vector<Problem> problems;
  std::vector<MethodKind> methods;
  std::vector<WorkPoint> points;
  std::vector<OrderFit> orders;
  std::vector<CheapestBelow> cheapest;
  std::vector<PaperErrors> paper;  ///< Of the first problem, if it is free flight.
  ClockProbe probe;
  int repetitions = 0;
};

struct SpeedErrorOptions {
  std::vector<double> rates_hz;  ///< Each kCheckRate_hz times a power of two.
  CostOptions cost;
  std::vector<double> errors_asked_px = {100.0, 10.0, 1.0,
                                         0.1,   0.01, 1e-6};             ///< What is cheapest below each?
  std::function<void(std::int64_t, std::int64_t)> report_progress = {};  ///< See measure_costs; may be empty.
};

/// Methods that know no walls play the problems of free flight only. SpeedError::paper is empty if the first
/// problem is not free flight. REQUIRES: a problem; the paper's step is the first method.
[[nodiscard]] SpeedError study_speed_error(std::vector<Problem> problems, std::vector<MethodKind> methods,
                                           const SpeedErrorOptions& options, const NanosecondClock& now_ns);

/// The rules that do not hold, each a sentence with method, problem and rate. Never about a time:
/// 0. Every method plays every problem to its end, with finite errors.
/// 1. In free flight every convergent method's order can be fitted over three rates or more, and is the
///    analytic one, +- kOrderApart.
/// 2. The exact methods' errors are rounding, at every rate, and of those that meet walls exactly in flings,
/// too.
/// 3. The paper's step does not converge: its error at the highest rate is above that at 60 Hz.
/// 4. Its distance from the fixed ODE, measured here, is that of sim/reference to 1e-6 of itself.
/// 5. Its truncation against the matched ODE is of first order, and that of its velocity is its closed form.
/// 6. The method of Prince and Dormand (rk8pd) at tolerances of 1e-10 or less is accurate to 1e-6 px.
[[nodiscard]] std::vector<std::string> broken_rules(const SpeedError& study);

/// An order is fitted over few points, the coarsest of which still feel the next term of the error.
inline constexpr double kOrderApart = 0.1;

/// The tables points, orders, cheapest, paper, clock.
/// @param machine on which the costs were measured, as below.
[[nodiscard]] std::vector<Table> speed_error_tables(const SpeedError& study, const std::string& machine);

/// The study's own members of the JSON document.
[[nodiscard]] std::vector<Table> speed_error_summary(const SpeedError& study, const std::string& machine);

/// The work-precision diagram of a problem: error against cost with its quartiles and the Pareto front, and
/// error against dt; a line a method, with its fitted order in the legend, and a gap where the method failed.
[[nodiscard]] Figure speed_error_figure(const SpeedError& study, std::size_t problem,
                                        const std::string& machine);

/// How drag per frame keeps the paper's step from converging, with the values of this study; empty if
/// SpeedError::paper has no 60 Hz.
[[nodiscard]] std::vector<std::string> convergence_sentences(const SpeedError& study);

/// Least-squares order of errors (> 0) against dt. REQUIRES: two points or more.
[[nodiscard]] double fitted_order(const std::vector<double>& dt_s, const std::vector<double>& errors);

/// Errors below this are the rounding of the run: 40 units in the last place of the largest coordinate, for
/// a random walk of so many frames.
[[nodiscard]] double rounding_px(const MethodErrors& errors);

/// The points that no other beats in both cost and error; lower is better. Never a NaN.
/// REQUIRES: as many errors as costs.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<double>& costs,
                                             const std::vector<double>& errors);

}  // namespace hyrax
