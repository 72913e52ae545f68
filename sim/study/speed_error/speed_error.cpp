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

  void measure_costs_of_all(const NanosecondClock& now_ns) {
    const Costs measured = measure_costs(works_, now_ns, options_.cost, options_.report_progress);
    study_.probe = measured.probe;
    study_.repetitions = options_.cost.repetitions;
    for (std::size_t i = 0; i < study_.set_ups.size(); ++i)
      study_.set_ups[i].cost = measured.costs[set_up_works_[i]];
    for (const Timed& timed : timed_) {
      WorkPoint& point = study_.points[timed.point];
      point.cost = difference_of(measured.costs[timed.work], measured.costs[set_up_works_[timed.set_up]],
                                 study_.problems[point.problem].duration_s());
    }
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
  std::vector<std::function<void()>> works_;
  std::vector<Timed> timed_;
  std::vector<std::size_t> set_up_works_;  // As many as SpeedError::set_ups.
};

void fit_orders(SpeedError& study) {
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    for (std::size_t method = 0; method < study.methods.size(); ++method) {
      std::vector<double> dt_s, errors;
      for (const WorkPoint& point : study.points) {
        if (point.problem != problem || point.method != method || point.errors.is_failed) continue;
        if (study.methods[method].is_adaptive() || !(point.errors.position_px > rounding_px(point.errors)))
          continue;
        dt_s.push_back(1.0 / point.rate_hz);
        errors.push_back(point.errors.position_px);
      }
      constexpr std::size_t kPointsMin = 3;
      if (dt_s.size() >= kPointsMin)
        study.orders.push_back({fitted_power(dt_s, errors), problem, method, dt_s.size(), 1.0 / dt_s.front(),
                                1.0 / dt_s.back()});
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
        if (p.problem != problem || !is_ranked(study, p) || !(p.errors.position_px < error_px)) continue;
        below.push_back(point);
        improve(answer.point, point);
        if (p.method == 0) improve(answer.paper_point, point);
      }
      std::copy_if(below.begin(), below.end(), std::back_inserter(answer.as_cheap), [&](std::size_t point) {
        return point != *answer.point && !is_cheaper(cost(*answer.point), cost(point));
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
  const double a = model.air_drag;
  const double frames = std::round(flight.stages.front().duration_s * rate_hz);
  return {rate_hz,
          arc.errors.implementation_px,
          arc.errors.truncation_px,
          arc.errors.model_px,
          arc.errors.truncation_px_per_s,
          model.gravity_px_per_s2 / rate_hz * (1.0 - std::pow(a, frames)) *
              std::fabs(a / (1.0 - a) + 1.0 / std::log(a))};
}

}  // namespace

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

bool is_ranked(const SpeedError& study, const WorkPoint& point) {
  return point.cost.is_measured() && point.rate_hz >= kRowRate_hz &&
         !study.methods[point.method].is_reference();
}

void mark_pareto(SpeedError& study) {
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem) {
    std::vector<std::size_t> at;
    std::vector<Cost> costs;
    std::vector<double> errors;
    for (std::size_t point = 0; point < study.points.size(); ++point) {
      const WorkPoint& p = study.points[point];
      if (p.problem != problem || !is_ranked(study, p)) continue;
      at.push_back(point);
      costs.push_back(p.cost);
      errors.push_back(std::max(p.errors.position_px, rounding_px(p.errors)));  // All exact ones are equal.
    }
    const std::vector<bool> is_front = pareto_front(costs, errors);
    for (std::size_t i = 0; i < at.size(); ++i) study.points[at[i]].is_pareto = is_front[i];
  }
}

std::vector<bool> pareto_front(const std::vector<Cost>& costs, const std::vector<double>& errors) {
  assert(costs.size() == errors.size());
  std::vector<bool> is_front(costs.size(), false);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    bool is_beaten = std::isnan(errors[i]) || !costs[i].is_measured();
    for (std::size_t other = 0; other < costs.size() && !is_beaten; ++other)
      is_beaten = errors[other] <= errors[i] && costs[other].time_ns.median < costs[i].time_ns.median &&
                  is_cheaper(costs[other], costs[i]);
    is_front[i] = !is_beaten;
  }
  return is_front;
}

SpeedError study_speed_error(const Core& core, std::vector<Problem> problems, std::vector<MethodKind> methods,
                             const SpeedErrorOptions& options, const NanosecondClock& now_ns) {
  assert(!problems.empty() && !methods.empty() && methods.front().name == "paper");
  SpeedError study;
  study.laws = FixedLaws(reference_model(core));
  study.problems = std::move(problems);
  study.methods = std::move(methods);
  Measurer measurer(core, study, options);
  measurer.measure_errors_of_all();
  measurer.measure_costs_of_all(now_ns);
  mark_pareto(study);
  fit_orders(study);
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
