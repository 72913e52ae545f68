// Work-precision diagrams: what every method costs, how far it is from the fixed laws, at every rate.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
  bool is_pareto = false;  ///< No other point of its problem is as cheap and as near.
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

/// What is cheapest below an error, and what the paper's step costs for it.
struct CheapestBelow {
  std::size_t problem = 0;
  double error_px = 0.0;
  std::optional<std::size_t> point;        ///< Into SpeedError::points; none: nothing comes so near.
  std::optional<std::size_t> paper_point;  ///< None: the paper's step does not, at any rate.
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
                                         0.1,   0.01, 1e-6};  ///< What is cheapest below each?
  std::function<void(std::int64_t, std::int64_t)> tell = {};  ///< See measure_costs; may be empty.
};

/// Adaptive methods fly the problems of free flight alone. SpeedError::paper is empty where the first problem
/// is none of these. REQUIRES: a problem; the paper's step is the first method.
[[nodiscard]] SpeedError study_speed_error(std::vector<Problem> problems, std::vector<MethodKind> methods,
                                           const SpeedErrorOptions& options, const NanosecondClock& now_ns);

/// Least-squares order of errors (> 0) against dt; needs two points.
[[nodiscard]] double fitted_order(const std::vector<double>& dt_s, const std::vector<double>& errors);

/// Errors below this are the rounding of the run: 40 units in the last place of the largest coordinate, for
/// a random walk of so many frames.
[[nodiscard]] double rounding_px(const MethodErrors& errors);

/// Which points none of the others beats; lower is better in both. NaN never is among them.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<double>& costs,
                                             const std::vector<double>& errors);

}  // namespace hyrax
