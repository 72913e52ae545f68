#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "sim/study/speed_error/speed_error.h"

namespace hyrax {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// An order is fitted over few points, the coarsest of which still feel the next term of the error.
constexpr double kOrderApart = 0.1;

class Rules {
 public:
  explicit Rules(const SpeedError& study) : study_(study) {}

  // Every method plays every problem to its end; an adaptive one may give up instead.
  void errors_are_finite() {
    for (const WorkPoint& point : study_.points) {
      if (point.errors.is_failed) {
        if (study_.methods[point.method].is_adaptive())
          continue;  // No step was small enough: a gap in its line.
        broken_.push_back(fmt::format("the method cannot play the problem to its end ({})", name_of(point)));
        continue;
      }
      for (const double error :
           {point.errors.position_px, point.errors.velocity_px_per_s, point.errors.end_px})
        require("the method has a finite error", name_of(point), error, 0.0,
                std::numeric_limits<double>::max());
    }
  }
  void orders_are_analytic() {
    for (std::size_t problem = 0; problem < study_.problems.size(); ++problem)
      for (std::size_t method = 0; method < study_.methods.size(); ++method) {
        const auto* const convergent = std::get_if<Convergent>(&study_.methods[method].accuracy);
        if (convergent != nullptr && study_.problems[problem].is_free_flight)
          order_is(convergent->order, problem, method);
      }
  }
  // At every rate; those that meet walls exactly in each of the flings of the bands, too.
  void exact_methods_are_exact() {
    for (const WorkPoint& point : study_.points) {
      const auto* const exact = std::get_if<Exact>(&study_.methods[point.method].accuracy);
      if (exact != nullptr && (exact->meets_walls_exactly || study_.problems[point.problem].is_free_flight))
        require("the error of an exact method is within rounding, px", name_of(point),
                point.errors.position_px, 0.0, rounding_px(point.errors));
    }
    for (const MethodBands& bands : study_.bands) {
      const auto* const exact = std::get_if<Exact>(&study_.methods[bands.method].accuracy);
      if (exact != nullptr && exact->meets_walls_exactly)
        require("flings in which the error of an exact method is more than rounding",
                fmt::format("{}, {:.0f} Hz", name_of(bands.problem, bands.method), bands.rate_hz),
                static_cast<double>(bands.beyond_rounding), 0.0, 0.0);
    }
  }
  void paper_does_not_converge() {
    const auto at_60 = std::ranges::find(study_.paper, 60.0, &PaperErrors::rate_hz);
    // With next to no drag the truncation at 60 Hz is still larger than what drag adds at the highest rate.
    constexpr double kSpeedTaken = 0.1;
    if (at_60 != study_.paper.end() && study_.laws.drag_rate_per_s *
                                               (study_.paper.back().rate_hz / 60.0 - 1.0) *
                                               study_.problems.front().duration_s() >
                                           kSpeedTaken)
      require("the paper's step leaves the fixed laws as its frames become shorter, px",
              "at the highest rate", study_.paper.back().model_px, at_60->model_px, kInfinity);
  }
  void paper_agrees_with_the_reference() {
    for (const PaperErrors& paper : study_.paper)
      for (const WorkPoint& point : study_.points)
        if (point.problem == 0 && point.method == 0 && point.rate_hz == paper.rate_hz)
          require("the paper's step is as far from the fixed ODE as the reference finds, as a ratio",
                  name_of(point), point.errors.position_px / paper.model_px, 1.0 - 1e-6, 1.0 + 1e-6);
  }
  void truncation_is_its_closed_form() {
    for (const PaperErrors& paper : study_.paper)
      require("the truncation is its closed form, as a ratio", name_of(0, 0),
              paper.truncation_px / paper.truncation_expected_px, 1.0 - 1e-6, 1.0 + 1e-6);
  }
  void rk8pd_keeps_its_tolerance() {
    for (const WorkPoint& point : study_.points) {
      const MethodKind& kind = study_.methods[point.method];
      const auto* const adaptive = std::get_if<Adaptive>(&kind.accuracy);
      if (adaptive != nullptr && kind.family == "GSL rk8pd" && adaptive->tolerance <= 1e-10)
        require("rk8pd is as accurate as its tolerance asks, px", name_of(point), point.errors.position_px,
                0.0, 1e-6);
    }
  }

  [[nodiscard]] std::vector<std::string> take() { return std::move(broken_); }

 private:
  void require(const std::string& rule, const std::string& where, double value, double low, double high) {
    if (!(value >= low && value <= high))
      broken_.push_back(
          fmt::format("{} ({}): must be {:.6g} .. {:.6g} (found {:.6g})", rule, where, low, high, value));
  }
  // Of an accurate method, or with little gravity, few rates may be left.
  [[nodiscard]] std::ptrdiff_t rates_beyond_rounding(std::size_t problem, std::size_t method) const {
    return std::count_if(study_.points.begin(), study_.points.end(), [&](const WorkPoint& point) {
      return point.problem == problem && point.method == method &&
             point.errors.position_px > rounding_px(point.errors);
    });
  }
  void order_is(int analytic, std::size_t problem, std::size_t method) {
    if (rates_beyond_rounding(problem, method) < 3) return;
    const auto fit = std::find_if(study_.orders.begin(), study_.orders.end(), [&](const OrderFit& each) {
      return each.problem == problem && each.method == method;
    });
    const bool is_fitted = fit != study_.orders.end();
    require("an order is fitted over three rates or more", name_of(problem, method),
            is_fitted ? static_cast<double>(fit->points) : 0.0, 3.0, kInfinity);
    if (is_fitted)
      require("the fitted order is the analytic one", name_of(problem, method), fit->order,
              analytic - kOrderApart, analytic + kOrderApart);
  }
  [[nodiscard]] std::string name_of(std::size_t problem, std::size_t method) const {
    return study_.methods[method].name + ", " + study_.problems[problem].name;
  }
  [[nodiscard]] std::string name_of(const WorkPoint& point) const {
    return fmt::format("{}, {:.0f} Hz", name_of(point.problem, point.method), point.rate_hz);
  }

  const SpeedError& study_;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> broken_rules(const SpeedError& study) {
  Rules rules(study);
  rules.errors_are_finite();
  rules.exact_methods_are_exact();
  rules.paper_agrees_with_the_reference();
  if (study.laws.air_drag < 1.0) {  // Else what they are about is exact, or 0.
    rules.orders_are_analytic();
    rules.paper_does_not_converge();
    rules.truncation_is_its_closed_form();
  }
  rules.rk8pd_keeps_its_tolerance();
  return rules.take();
}

}  // namespace hyrax
