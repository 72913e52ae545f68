#include "sim/study/speed_error/speed_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>

#include "sim/reference/drift_meter.h"
#include "sim/replay/replay.h"
#include "sim/study/reference_model.h"

namespace hyrax {
namespace {

using Frames = std::vector<std::vector<double>>;

bool suits(const MethodKind& kind, const Problem& problem) {
  return kind.meets_walls || problem.is_free_flight;
}

// All points, their errors measured, and the works that time those that did not fail.
class Measurer {
  // A point, the work that is timed for it, and the set-up that is a part of it.
  struct Timed {
    std::size_t point, work, set_up;
  };

 public:
  Measurer(const Core& core, SpeedError& study, const SpeedErrorOptions& options)
      : core_(core), study_(study), options_(options) {}

  void measure_errors_of_all() {
    for (std::size_t problem = 0; problem < study_.problems.size(); ++problem)
      for (std::size_t method = 0; method < study_.methods.size(); ++method) {
        const MethodKind& kind = study_.methods[method];
        if (!suits(kind, study_.problems[problem])) continue;
        if (kind.is_adaptive()) add_point(problem, method, end_only_hz(study_.problems[problem]));
        if (kind.is_adaptive() || kind.is_reference())
          add_point(problem, method, kRowRate_hz);
        else
          for (const double rate_hz : options_.rates_hz) add_point(problem, method, rate_hz);
        add_set_up(problem, method);
      }
  }

  void measure_costs_of_all(const CostMeter& measure_costs) {
    count_pairs(study_);
    study_.cost = options_.cost;
    study_.cost.processes = std::max(study_.cost.processes, processes_for(study_.comparisons));
    const Costs measured = costs_of(measure_costs(works_, study_.cost));
    study_.probe = measured.probe;
    for (std::size_t i = 0; i < study_.set_ups.size(); ++i)
      study_.set_ups[i].cost = measured.costs[set_up_works_[i]];
    for (const Timed& timed : timed_) {
      WorkPoint& point = study_.points[timed.point];
      point.cost = difference_of(measured.costs[timed.work], measured.costs[set_up_works_[timed.set_up]],
                                 study_.problems[point.problem].duration_s());
    }
    count_pairs(study_);
  }

 private:
  void add_point(std::size_t problem, std::size_t method, double rate_hz) {
    const std::shared_ptr<const Frames>& frames = frames_of(problem, rate_hz);
    const Problem& played = study_.problems[problem];
    const MethodKind& kind = study_.methods[method];
    study_.points.push_back(
        {problem, method, rate_hz, measure_errors(core_, played, kind, *frames, rate_hz), {}});
    if (study_.points.back().errors.is_failed) return;
    timed_.push_back({study_.points.size() - 1, works_.size(), study_.set_ups.size()});
    add_work(problem, method, frames);
  }

  void add_set_up(std::size_t problem, std::size_t method) {
    study_.set_ups.push_back({problem, method});
    set_up_works_.push_back(works_.size());
    add_work(problem, method, std::make_shared<Frames>(study_.problems[problem].stages.size()));
  }

  void add_work(std::size_t problem, std::size_t method, const std::shared_ptr<const Frames>& frames) {
    works_.push_back([&played = study_.problems[problem],
                      runner = std::shared_ptr<Method>(study_.methods[method].make()),
                      frames] { static_cast<void>(play_through(played, *runner, *frames)); });
  }

  const std::shared_ptr<const Frames>& frames_of(std::size_t problem, double rate_hz) {
    auto& frames = frames_[{problem, rate_hz}];
    if (!frames) frames = std::make_shared<Frames>(stage_frames_s(study_.problems[problem], rate_hz));
    return frames;
  }

  const Core& core_;
  SpeedError& study_;
  const SpeedErrorOptions& options_;
  std::map<std::pair<std::size_t, double>, std::shared_ptr<const Frames>> frames_;
  Works works_;
  std::vector<Timed> timed_;
  std::vector<std::size_t> set_up_works_;  // As many as SpeedError::set_ups.
};

// Of a flight by its own errors, with walls over many flings: of one, impacts fall on any part of a frame.
// Nothing where the errors, or their medians, do not become smaller with every shorter frame.
std::optional<OrderFit> fit_order(const Core& core, const std::vector<Problem>& flings,
                                  const MethodKind& kind, const std::vector<double>& rates_hz) {
  constexpr std::size_t kPointsMin = 3;
  std::vector<double> orders;
  std::vector<std::vector<double>> by_rate(rates_hz.size());
  OrderFit fit;
  for (const Problem& fling : flings) {
    std::vector<double> dt_s, errors;
    for (std::size_t rate = 0; rate < rates_hz.size(); ++rate) {
      const MethodErrors at =
          measure_errors(core, fling, kind, stage_frames_s(fling, rates_hz[rate]), rates_hz[rate]);
      if (at.is_failed || !(at.position_px > rounding_px(at))) continue;
      dt_s.push_back(1.0 / rates_hz[rate]);
      errors.push_back(at.position_px);
      by_rate[rate].push_back(at.position_px);
    }
    if (dt_s.size() < kPointsMin) continue;
    static_cast<PowerFit&>(fit) = fitted_power(dt_s, errors);
    fit.points = dt_s.size();
    fit.low_hz = 1.0 / dt_s.front();
    fit.high_hz = 1.0 / dt_s.back();
    orders.push_back(fit.order);
  }
  std::erase_if(by_rate, [](const std::vector<double>& errors) { return errors.empty(); });
  const auto is_no_smaller = [](const std::vector<double>& longer, const std::vector<double>& shorter) {
    return quantile(longer, 0.5) <= quantile(shorter, 0.5);
  };
  if (orders.empty() || std::ranges::adjacent_find(by_rate, is_no_smaller) != by_rate.end())
    return std::nullopt;
  fit.flings = std::ssize(orders);
  if (fit.flings > 1) {
    const Band band = *band_of(orders);
    static_cast<PowerFit&>(fit) = {.order = band.median, .least = band.low, .most = band.high};
  }
  return fit;
}

void fit_orders(const Core& core, SpeedError& study, const SpeedErrorOptions& options) {
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem) {
    const Problem& played = study.problems[problem];
    const std::vector<Problem> flings =
        problems_like(played, played.is_free_flight ? 1 : options.order_flings);
    for (std::size_t method = 0; method < study.methods.size(); ++method) {
      const MethodKind& kind = study.methods[method];
      if (kind.is_adaptive() || kind.is_reference()) continue;
      std::optional<OrderFit> fit =
          fit_order(core, flings, kind, played.is_free_flight ? options.rates_hz : options.order_rates_hz);
      if (!fit) continue;
      fit->problem = problem;
      fit->method = method;
      study.orders.push_back(*fit);
    }
  }
}

void scan_rates(const Core& core, SpeedError& study, const std::vector<double>& rates_hz) {
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    for (std::size_t method = 0; method < study.methods.size(); ++method) {
      const MethodKind& kind = study.methods[method];
      if (kind.is_adaptive() || kind.is_reference()) continue;
      study.least.push_back(least_error(core, study.problems[problem], kind, rates_hz));
      study.least.back().problem = problem;
      study.least.back().method = method;
    }
}

void find_cheapest(SpeedError& study, const std::vector<double>& errors_asked_px) {
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    for (const double error_px : errors_asked_px) {
      CheapestBelow answer{.problem = problem, .error_px = error_px};
      const auto cost = [&](std::size_t point) -> const Cost& { return study.points[point].cost; };
      const auto improve = [&](PointIndex& best, std::size_t point) {
        if (!best || cost(point).time_ns.median < cost(*best).time_ns.median) best = point;
      };
      std::vector<std::size_t> below;
      for (std::size_t point = 0; point < study.points.size(); ++point) {
        const WorkPoint& p = study.points[point];
        if (p.problem != problem || !is_comparable(study, p) || !(p.errors.position_px < error_px)) continue;
        below.push_back(point);
        if (!is_ranked(study, p)) continue;
        improve(answer.point, point);
        if (p.method == 0) improve(answer.paper_point, point);
      }
      std::copy_if(below.begin(), below.end(), std::back_inserter(answer.as_cheap), [&](std::size_t point) {
        return point != answer.point &&
               !(answer.point && is_ranked_cheaper(study, study.points[*answer.point], study.points[point]));
      });
      study.cheapest.push_back(std::move(answer));
    }
}

Scenario scenario_of(const Problem& flight, double rate_hz) {
  const Stage& stage = flight.stages.front();
  const Size window{static_cast<std::int32_t>(stage.bounds.right_px) + 1,
                    static_cast<std::int32_t>(stage.bounds.bottom_px) + 1};
  return scenario_from(flight.start, window, {1, 1}, rate_hz, std::llround(stage.duration_s * rate_hz));
}

struct OneArc final : DriftSink {
  void arc(const ArcErrors& arc) override { errors = arc; }
  ArcErrors errors;
};

PaperErrors paper_errors(const Core& core, const Problem& flight, double rate_hz) {
  const Scenario scenario = scenario_of(flight, rate_hz);
  OneArc arc;
  const Model model = reference_model(core);
  DriftMeter meter(scenario, {}, arc, nullptr, model);
  replay(core, scenario, meter);
  meter.finish();
  PaperErrors paper{rate_hz, arc.errors.implementation_px, arc.errors.truncation_px, arc.errors.model_px};
  const double a = model.air_drag, h = 1.0 / rate_hz, pull = model.gravity_px_per_s2 * h;
  if (!(a < 1.0)) return paper;
  const double sum = a / (1.0 - a), rate = -std::log(a), c = sum - 1.0 / rate;
  double left = 1.0;  // Of the speed, by drag.
  for (double frame = 1.0; frame <= std::round(flight.stages.front().duration_s * rate_hz); ++frame) {
    left *= a;
    const double x_px = (1.0 - left) * flight.start.vx_px_per_s;
    const double y_px = pull * frame + (1.0 - left) * (flight.start.vy_px_per_s - pull * (sum + 1.0 / rate));
    paper.truncation_expected_px =
        std::max(paper.truncation_expected_px, std::fabs(c * h) * std::hypot(x_px, y_px));
  }
  return paper;
}

}  // namespace

LeastError least_error(const Core& core, const Problem& problem, const MethodKind& kind,
                       const std::vector<double>& rates_hz) {
  LeastError least;
  const double low_hz = rates_hz.front(), high_hz = rates_hz.back();
  const auto try_rate = [&](double rate_hz) {
    if (!(rate_hz >= low_hz && rate_hz <= high_hz)) return;
    const MethodErrors at = measure_errors(core, problem, kind, stage_frames_s(problem, rate_hz), rate_hz);
    if (!at.is_failed && !(least.position_px <= at.position_px))
      least = {.rate_hz = rate_hz, .position_px = at.position_px};
  };
  constexpr double kRatio = 1.06, kParts = 8.0;  // A twelfth of an octave, and how much finer it becomes.
  for (double rate_hz = low_hz; rate_hz < high_hz; rate_hz *= kRatio) try_rate(rate_hz);
  for (const double rate_hz : rates_hz) try_rate(rate_hz);
  for (double ratio = kRatio; ratio > 1.0 + 1e-3; ratio = std::pow(ratio, 1.0 / kParts)) {
    const double middle_hz = least.rate_hz;
    for (double part = -kParts; part <= kParts; ++part) try_rate(middle_hz * std::pow(ratio, part / kParts));
  }
  return least;
}

double end_only_hz(const Problem& problem) { return 1.0 / problem.duration_s(); }

PowerFit fitted_power(const std::vector<double>& dt_s, const std::vector<double>& errors) {
  assert(dt_s.size() == errors.size() && dt_s.size() >= 2);
  const auto n = static_cast<double>(dt_s.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < dt_s.size(); ++i) {
    mean_x += std::log(dt_s[i]) / n;
    mean_y += std::log(errors[i]) / n;
  }
  double covariance = 0.0, variance = 0.0;
  PowerFit fit{.least = HUGE_VAL, .most = -HUGE_VAL};
  for (std::size_t i = 0; i < dt_s.size(); ++i) {
    const double x = std::log(dt_s[i]) - mean_x;
    covariance += x * (std::log(errors[i]) - mean_y);
    variance += x * x;
    if (i == 0) continue;
    const double order = std::log(errors[i] / errors[i - 1]) / std::log(dt_s[i] / dt_s[i - 1]);
    fit.least = std::min(fit.least, order);
    fit.most = std::max(fit.most, order);
  }
  fit.order = covariance / variance;
  double squares = 0.0;  // Of what the line leaves.
  for (std::size_t i = 0; i < dt_s.size(); ++i) {
    const double left = std::log(errors[i]) - mean_y - fit.order * (std::log(dt_s[i]) - mean_x);
    squares += left * left;
  }
  if (dt_s.size() > 2) fit.standard_error = std::sqrt(squares / (n - 2.0) / variance);
  return fit;
}

bool is_comparable(const SpeedError& study, const WorkPoint& point) {
  return !point.errors.is_failed && point.rate_hz >= kRowRate_hz &&
         !study.methods[point.method].is_reference();
}

bool is_ranked(const SpeedError& study, const WorkPoint& point) {
  return point.cost.is_measured() && is_comparable(study, point);
}

bool is_ranked_cheaper(const SpeedError& study, const WorkPoint& a, const WorkPoint& b) {
  return is_cheaper(a.cost, b.cost, study.comparisons);
}

void count_pairs(SpeedError& study) {
  study.ranked_pairs = 0;
  std::int64_t pairs = 0;
  for (auto a = study.points.begin(); a != study.points.end(); ++a)
    for (auto b = study.points.begin(); is_comparable(study, *a) && b != a; ++b) {
      if (b->problem != a->problem || !is_comparable(study, *b)) continue;
      ++pairs;
      if (is_ranked_cheaper(study, *a, *b) || is_ranked_cheaper(study, *b, *a)) ++study.ranked_pairs;
    }
  study.comparisons = pairs;
}

void mark_pareto(SpeedError& study) {
  // The largest distance is taken at rows: a smaller difference says where in a frame they fall.
  constexpr double kErrorApart_rel = 1e-3;
  const auto error_px = [](const WorkPoint& point) {
    return std::max(point.errors.position_px, rounding_px(point.errors));  // NaN of a NaN.
  };
  for (WorkPoint& point : study.points)
    point.is_pareto = is_ranked(study, point) && !std::isnan(error_px(point)) &&
                      std::ranges::none_of(study.points, [&](const WorkPoint& other) {
                        return other.problem == point.problem && is_ranked(study, other) &&
                               error_px(other) <= error_px(point) * (1.0 + kErrorApart_rel) &&
                               is_ranked_cheaper(study, other, point);
                      });
}

SpeedError study_speed_error(const Core& core, std::vector<Problem> problems, std::vector<MethodKind> methods,
                             const SpeedErrorOptions& options, const CostMeter& measure_costs) {
  assert(!problems.empty() && !methods.empty() && methods.front().name == "paper");
  SpeedError study;
  study.laws = FixedLaws(reference_model(core));
  study.problems = std::move(problems);
  study.methods = std::move(methods);
  study.low_hz = options.rates_hz.front();
  study.high_hz = options.rates_hz.back();
  Measurer measurer(core, study, options);
  measurer.measure_errors_of_all();
  measurer.measure_costs_of_all(measure_costs);
  if (options.cost.is_only) return study;
  mark_pareto(study);
  fit_orders(core, study, options);
  scan_rates(core, study, options.rates_hz);
  find_cheapest(study, options.errors_asked_px);
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    if (!study.problems[problem].is_free_flight)
      for (MethodBands& bands :
           method_bands(core, study.problems[problem], study.methods, options.band_rates_hz)) {
        bands.problem = problem;
        study.bands.push_back(bands);
      }
  if (!study.problems.front().is_free_flight) return study;
  for (const double rate_hz : options.rates_hz)
    study.paper.push_back(paper_errors(core, study.problems.front(), rate_hz));
  return study;
}

}  // namespace hyrax
