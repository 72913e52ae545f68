#include "sim/study/speed_error_tables.h"

#include <limits>

#include "sim/study/column_of.h"

namespace hyrax {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

StudyTable points_table(const SpeedError& study) {
  const auto& points = study.points;
  using P = const WorkPoint&;
  const auto unless_failed = [](double MethodErrors::*error) {
    return [error](P p) { return p.errors.is_failed ? kNone : p.errors.*error; };
  };
  const auto cost = [](double Cost::*part) {
    return [part](P p) { return p.errors.is_failed ? kNone : p.cost.*part; };
  };
  return {
      "points",
      "each method at each rate or tolerance",
      {column_of<std::string>("problem", "", "what is played", points,
                              [&](P p) { return study.problems[p.problem].name; }),
       column_of<std::string>("method", "", "how", points, [&](P p) { return study.methods[p.method].name; }),
       column_of<double>("rate", "Hz", "frames per second", points, [](P p) { return p.rate_hz; }),
       column_of<double>("dt", "s", "one frame", points, [](P p) { return 1.0 / p.rate_hz; }),
       column_of<double>("tolerance", "1", "of an adaptive method; none of one that goes by frames", points,
                         [&](P p) {
                           const double tolerance = study.methods[p.method].tolerance;
                           return tolerance > 0.0 ? tolerance : kNone;
                         }),
       column_of<std::int64_t>("failed", "1", "1: the method gave up", points,
                               [](P p) { return std::int64_t{p.errors.is_failed}; }),
       column_of<double>("position_error", "px", "largest distance from the exact fling", points,
                         unless_failed(&MethodErrors::position_px)),
       column_of<double>("velocity_error", "px/s", "largest difference of velocity", points,
                         unless_failed(&MethodErrors::velocity_px_per_s)),
       column_of<double>("energy_error", "1", "largest difference of energy / largest energy", points,
                         unless_failed(&MethodErrors::energy_rel)),
       column_of<double>("end_error", "px", "distance of the last places", points,
                         unless_failed(&MethodErrors::end_px)),
       column_of<double>("contact_time_error", "s", "largest, of the first three impacts", points,
                         unless_failed(&MethodErrors::contact_time_s)),
       column_of<double>("cost", "ns/s", "median time per simulated second", points, cost(&Cost::median_ns)),
       column_of<double>("cost_lower_quartile", "ns/s", "a quarter of the repetitions took less", points,
                         cost(&Cost::lower_quartile_ns)),
       column_of<double>("cost_upper_quartile", "ns/s", "a quarter took more", points,
                         cost(&Cost::upper_quartile_ns)),
       column_of<std::int64_t>("pareto", "1", "1: no other is as cheap and as near", points,
                               [](P p) { return std::int64_t{p.is_pareto}; })}};
}

StudyTable orders_table(const SpeedError& study) {
  using F = const OrderFit&;
  const auto& orders = study.orders;
  return {
      "orders",
      "fitted order of convergence",
      {column_of<std::string>("problem", "", "what is played", orders,
                              [&](F f) { return study.problems[f.problem].name; }),
       column_of<std::string>("method", "", "how", orders, [&](F f) { return study.methods[f.method].name; }),
       column_of<double>("order", "1", "slope of log error against log dt", orders,
                         [](F f) { return f.order; }),
       column_of<std::int64_t>("analytic_order", "1", "in free flight; 0 does not converge, -1 exact", orders,
                               [&](F f) { return std::int64_t{study.methods[f.method].convergence.code()}; }),
       column_of<std::int64_t>("points", "1", "rates that it is fitted to", orders,
                               [](F f) { return static_cast<std::int64_t>(f.points); })}};
}

StudyTable cheapest_table(const SpeedError& study) {
  using C = const CheapestBelow&;
  const auto& cheapest = study.cheapest;
  const auto method = [&](C c) {
    return c.point ? study.methods[study.points[*c.point].method].name : std::string("none");
  };
  const auto rate = [&](const std::optional<std::size_t>& p) { return p ? study.points[*p].rate_hz : kNone; };
  const auto cost = [&](const std::optional<std::size_t>& p) {
    return p ? study.points[*p].cost.median_ns : kNone;
  };
  return {
      "cheapest",
      "for an error below so much: what is cheapest, and what does the paper's step cost for it",
      {column_of<std::string>("problem", "", "what is played", cheapest,
                              [&](C c) { return study.problems[c.problem].name; }),
       column_of<double>("error", "px", "to stay below", cheapest, [](C c) { return c.error_px; }),
       column_of<std::string>("method", "", "the cheapest", cheapest, method),
       column_of<double>("rate", "Hz", "its frames per second", cheapest, [&](C c) { return rate(c.point); }),
       column_of<double>("cost", "ns/s", "its median cost", cheapest, [&](C c) { return cost(c.point); }),
       column_of<double>("paper_rate", "Hz", "of the paper's step; none: at no rate", cheapest,
                         [&](C c) { return rate(c.paper_point); }),
       column_of<double>("paper_cost", "ns/s", "its median cost", cheapest,
                         [&](C c) { return cost(c.paper_point); })}};
}

StudyTable paper_table(const SpeedError& study) {
  using P = const PaperErrors&;
  const auto& paper = study.paper;
  return {"paper",
          "the paper's step in free flight (" + study.problems.front().name + ") against three laws",
          {column_of<double>("rate", "Hz", "frames per second", paper, [](P p) { return p.rate_hz; }),
           column_of<double>("implementation", "px", "from its own closed form", paper,
                             [](P p) { return p.implementation_px; }),
           column_of<double>("truncation", "px", "from the ODE with the drag rate of this frame", paper,
                             [](P p) { return p.truncation_px; }),
           column_of<double>("model", "px", "from the ODE with the drag rate of 60 Hz", paper,
                             [](P p) { return p.model_px; }),
           column_of<double>("truncation_speed", "px/s", "velocity, from the ODE of this frame", paper,
                             [](P p) { return p.truncation_px_per_s; }),
           column_of<double>("truncation_speed_expected", "px/s", "the same by its closed form", paper,
                             [](P p) { return p.truncation_expected_px_per_s; })}};
}

}  // namespace

std::vector<StudyTable> tables_of(const SpeedError& study, const std::string& machine) {
  StudyTable clock{
      "clock",
      "where and how the times were taken",
      {{"machine", "", "processor", std::vector<std::string>{machine}},
       {"repetitions", "1", "of each point, in random order", std::vector<std::int64_t>{study.repetitions}},
       {"probe", "ns", "median time of the same piece of arithmetic",
        std::vector<double>{study.probe.median_ns}},
       {"probe_drift", "1", "its 95th minus its 5th percentile / median",
        std::vector<double>{study.probe.drift_rel}}}};
  return {points_table(study), orders_table(study), cheapest_table(study), paper_table(study),
          std::move(clock)};
}

}  // namespace hyrax
