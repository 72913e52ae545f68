#include "sim/study/speed_error_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hyrax {
namespace {

class Rules {
 public:
  explicit Rules(const SpeedError& study) : study_(study) {}

  void hold(const std::string& rule, const std::string& where, double value, double low, double high) {
    if (!(value >= low && value <= high)) broken_.push_back({rule, where, value, low, high});
  }

  void results() {
    for (const WorkPoint& point : study_.points)
      for (const double error :
           {point.errors.position_px, point.errors.velocity_px_per_s, point.errors.end_px})
        hold("the method plays the problem to its end with a finite error", where(point),
             point.errors.is_failed ? std::numeric_limits<double>::quiet_NaN() : error, 0.0,
             std::numeric_limits<double>::max());
  }
  void orders() {
    for (std::size_t problem = 0; problem < study_.problems.size(); ++problem)
      for (std::size_t method = 0; method < study_.methods.size(); ++method)
        if (study_.methods[method].convergence.kind == Convergence::Kind::with_order && study_.problems[problem].is_free_flight)
          order(problem, method);
  }
  void order(std::size_t problem, std::size_t method) {
    const auto fit = std::find_if(study_.orders.begin(), study_.orders.end(), [&](const OrderFit& each) {
      return each.problem == problem && each.method == method;
    });
    const bool is_fitted = fit != study_.orders.end();
    hold("an order is fitted over three rates or more", where(problem, method),
         is_fitted ? static_cast<double>(fit->points) : 0.0, 3.0, std::numeric_limits<double>::infinity());
    const double analytic = study_.methods[method].convergence.order;
    if (is_fitted)
      hold("the fitted order is the analytic one", where(problem, method), fit->order, analytic - kOrderApart,
           analytic + kOrderApart);
  }
  void exact_methods() {
    for (const WorkPoint& point : study_.points) {
      const MethodKind& kind = study_.methods[point.method];
      if (kind.convergence != kExact || !study_.problems[point.problem].is_free_flight) continue;
      hold("an exact method is there within rounding, px", where(point), point.errors.position_px, 0.0,
           rounding_px(point.errors));
    }
  }
  void paper_does_not_converge() {
    const PaperErrors* at_60 = nullptr;
    for (const PaperErrors& paper : study_.paper)
      if (paper.rate_hz == 60.0) at_60 = &paper;
    if (at_60 != nullptr && study_.paper.back().rate_hz > 120.0)
      hold("the paper's step leaves the fixed laws as its frames grow short, px", "at the highest rate",
           study_.paper.back().model_px, at_60->model_px, std::numeric_limits<double>::infinity());
  }
  void paper_is_where_the_reference_says() {
    for (const PaperErrors& paper : study_.paper)
      for (const WorkPoint& point : study_.points)
        if (point.problem == 0 && point.method == 0 && point.rate_hz == paper.rate_hz)
          hold("the paper's step is as far from the fixed ODE as the reference finds, as a ratio",
               where(point), point.errors.position_px / paper.model_px, 1.0 - 1e-6, 1.0 + 1e-6);
  }
  void truncation() {
    std::vector<double> dt_s, errors;
    for (const PaperErrors& paper : study_.paper) {
      const std::string where = "paper, " + study_.problems.front().name;
      hold("the truncation of velocity is its closed form, as a ratio", where,
           paper.truncation_px_per_s / paper.truncation_expected_px_per_s, 1.0 - 1e-6, 1.0 + 1e-6);
      if (paper.rate_hz < 60.0) continue;  // Below, the next term of the error shows.
      dt_s.push_back(1.0 / paper.rate_hz);
      errors.push_back(paper.truncation_px);
    }
    if (dt_s.size() >= 2)
      hold("the truncation against the matched ODE is of first order",
           "paper, " + study_.problems.front().name, fitted_order(dt_s, errors), 1.0 - kOrderApart,
           1.0 + kOrderApart);
  }
  void adaptive_method() {
    for (const WorkPoint& point : study_.points) {
      const MethodKind& kind = study_.methods[point.method];
      if (!kind.name.starts_with("gsl-rk8pd") || kind.tolerance > 1e-10) continue;
      hold("rk8pd comes as near as it is asked to, px", where(point), point.errors.position_px, 0.0, 1e-6);
    }
  }

  [[nodiscard]] std::vector<BrokenRule> take() { return std::move(broken_); }

 private:
  [[nodiscard]] std::string where(std::size_t problem, std::size_t method) const {
    return study_.methods[method].name + ", " + study_.problems[problem].name;
  }
  [[nodiscard]] std::string where(const WorkPoint& point) const {
    return where(point.problem, point.method) + ", " + std::to_string(std::lround(point.rate_hz)) + " Hz";
  }

  const SpeedError& study_;
  std::vector<BrokenRule> broken_;
};

}  // namespace

std::vector<BrokenRule> broken_rules(const SpeedError& study) {
  Rules rules(study);
  rules.results();
  rules.orders();
  rules.exact_methods();
  rules.paper_does_not_converge();
  rules.paper_is_where_the_reference_says();
  rules.truncation();
  rules.adaptive_method();
  return rules.take();
}

}  // namespace hyrax
