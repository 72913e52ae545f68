#include "sim/study/speed_error/speed_error.h"

namespace hyrax {
namespace {

using PointIndex = std::optional<std::size_t>;

template <class Record>
Column problem_column(const SpeedError& study, const std::vector<Record>& records) {
  return column_of<std::string>("problem", "", "what is played", records,
                                [&](const Record& record) { return study.problems[record.problem].name; });
}
template <class Record>
Column method_column(const SpeedError& study, const std::vector<Record>& records) {
  return column_of<std::string>("method", "", "name of the method", records,
                                [&](const Record& record) { return study.methods[record.method].name; });
}

// As files have it: 0 does not converge, -1 exact, -2 adaptive.
std::int64_t order_code(const Accuracy& accuracy) {
  if (const auto* const convergent = std::get_if<Convergent>(&accuracy)) return convergent->order;
  if (std::holds_alternative<Exact>(accuracy)) return -1;
  return std::holds_alternative<Adaptive>(accuracy) ? -2 : 0;
}

Table points_table(const SpeedError& study) {
  const auto& points = study.points;
  using P = const WorkPoint&;
  const auto error = [](double MethodErrors::*part) {
    return [part](P p) { return p.errors.is_failed ? kNotGiven : p.errors.*part; };
  };
  const auto cost = [](double Cost::*part) {
    return [part](P p) { return p.errors.is_failed ? kNotGiven : p.cost.*part; };
  };
  return {
      "points",
      "each method at each rate or tolerance",
      {problem_column(study, points), method_column(study, points),
       column_of<double>("rate", "Hz", "frames per second", points, &WorkPoint::rate_hz),
       column_of<double>("dt", "s", "one frame", points, [](P p) { return 1.0 / p.rate_hz; }),
       column_of<double>("tolerance", "1", "of an adaptive method; none of one that goes by frames", points,
                         [&](P p) {
                           const auto* const adaptive =
                               std::get_if<Adaptive>(&study.methods[p.method].accuracy);
                           return adaptive != nullptr ? adaptive->tolerance : kNotGiven;
                         }),
       column_of<std::int64_t>("failed", "1", "1: the method gave up", points,
                               [](P p) { return std::int64_t{p.errors.is_failed}; }),
       column_of<double>("position_error", "px", "largest distance from the exact fling", points,
                         error(&MethodErrors::position_px)),
       column_of<double>("velocity_error", "px/s", "largest difference of velocity", points,
                         error(&MethodErrors::velocity_px_per_s)),
       column_of<double>("energy_error", "1", "largest difference of energy / largest energy", points,
                         error(&MethodErrors::energy_rel)),
       column_of<double>("end_error", "px", "distance of the last positions", points,
                         error(&MethodErrors::end_px)),
       column_of<double>("contact_time_error", "s", "largest, of the first three impacts", points,
                         error(&MethodErrors::contact_time_s)),
       column_of<double>("cost", "ns/s", "median time per simulated second", points, cost(&Cost::median_ns)),
       column_of<double>("cost_lower_quartile", "ns/s", "a quarter of the repetitions took less", points,
                         cost(&Cost::lower_quartile_ns)),
       column_of<double>("cost_upper_quartile", "ns/s", "a quarter took more", points,
                         cost(&Cost::upper_quartile_ns)),
       column_of<std::int64_t>("pareto", "1", "1: no other is both cheaper and more accurate", points,
                               [](P p) { return std::int64_t{p.is_pareto}; })}};
}

Table orders_table(const SpeedError& study) {
  const auto& orders = study.orders;
  return {"orders",
          "fitted order of convergence",
          {problem_column(study, orders), method_column(study, orders),
           column_of<double>("order", "1", "slope of log error against log dt", orders, &OrderFit::order),
           column_of<std::int64_t>(
               "analytic_order", "1", "in free flight; 0 does not converge, -1 exact", orders,
               [&](const OrderFit& fit) { return order_code(study.methods[fit.method].accuracy); }),
           column_of<std::int64_t>("points", "1", "rates that it is fitted to", orders, &OrderFit::points)}};
}

Table cheapest_table(const SpeedError& study) {
  const auto& cheapest = study.cheapest;
  const auto rate = [&](PointIndex CheapestBelow::*point) {
    return [&study, point](const CheapestBelow& answer) {
      return answer.*point ? study.points[*(answer.*point)].rate_hz : kNotGiven;
    };
  };
  const auto cost = [&](PointIndex CheapestBelow::*point) {
    return [&study, point](const CheapestBelow& answer) {
      return answer.*point ? study.points[*(answer.*point)].cost.median_ns : kNotGiven;
    };
  };
  const auto method = [&](const CheapestBelow& answer) {
    return answer.point ? study.methods[study.points[*answer.point].method].name : std::string("none");
  };
  return {"cheapest",
          "the cheapest method below an error, and what the paper's step costs for it",
          {problem_column(study, cheapest),
           column_of<double>("error", "px", "to stay below", cheapest, &CheapestBelow::error_px),
           column_of<std::string>("method", "", "the cheapest", cheapest, method),
           column_of<double>("rate", "Hz", "its frames per second", cheapest, rate(&CheapestBelow::point)),
           column_of<double>("cost", "ns/s", "its median cost", cheapest, cost(&CheapestBelow::point)),
           column_of<double>("paper_rate", "Hz", "of the paper's step; none: at no rate", cheapest,
                             rate(&CheapestBelow::paper_point)),
           column_of<double>("paper_cost", "ns/s", "its median cost", cheapest,
                             cost(&CheapestBelow::paper_point))}};
}

Table paper_table(const SpeedError& study) {
  const auto& paper = study.paper;
  return {"paper",
          "the paper's step in free flight (" + study.problems.front().name + ") against three laws",
          {column_of<double>("rate", "Hz", "frames per second", paper, &PaperErrors::rate_hz),
           column_of<double>("implementation", "px", "from its own closed form", paper,
                             &PaperErrors::implementation_px),
           column_of<double>("truncation", "px", "from the ODE with the drag rate of this frame", paper,
                             &PaperErrors::truncation_px),
           column_of<double>("model", "px", "from the ODE with the drag rate of 60 Hz", paper,
                             &PaperErrors::model_px),
           column_of<double>("truncation_speed", "px/s", "velocity, from the ODE of this frame", paper,
                             &PaperErrors::truncation_px_per_s),
           column_of<double>("truncation_speed_expected", "px/s", "the same by its closed form", paper,
                             &PaperErrors::truncation_expected_px_per_s)}};
}

Table clock_table(const SpeedError& study, const std::string& machine) {
  return {
      "clock",
      "where and how the times were measured",
      {{"machine", "", "processor", std::vector{machine}},
       {"repetitions", "1", "of each point, in random order", std::vector<std::int64_t>{study.repetitions}},
       {"probe", "ns", "median time of the same piece of arithmetic", std::vector{study.probe.median_ns}},
       {"probe_drift", "1", "its 95th minus its 5th percentile / median",
        std::vector{study.probe.drift_rel}}}};
}

}  // namespace

std::vector<Table> speed_error_tables(const SpeedError& study, const std::string& machine) {
  return {points_table(study), orders_table(study), cheapest_table(study), paper_table(study),
          clock_table(study, machine)};
}

std::vector<Table> speed_error_summary(const SpeedError& study, const std::string& machine) {
  Table clock{.columns = {{.name = "machine", .values = std::vector{machine}},
                          {.name = "clock_drift_rel", .values = std::vector{study.probe.drift_rel}},
                          {.name = "repetitions", .values = std::vector<std::int64_t>{study.repetitions}}},
              .shape = JsonShape::members};
  const auto point = [&](PointIndex CheapestBelow::*index) {
    return [&study, index](const CheapestBelow& answer) {
      std::vector<WorkPoint> points;
      if (answer.*index) points.push_back(study.points[*(answer.*index)]);
      return Table{.columns = {method_column(study, points),
                               column_of<double>("rate", "Hz", "", points, &WorkPoint::rate_hz),
                               column_of<double>("position_error", "px", "", points,
                                                 [](const WorkPoint& p) { return p.errors.position_px; }),
                               column_of<double>("cost", "ns/s", "", points,
                                                 [](const WorkPoint& p) { return p.cost.median_ns; })},
                   .shape = JsonShape::one};
    };
  };
  const auto& answers = study.cheapest;
  Table cheapest{.name = "cheapest",
                 .columns = {problem_column(study, answers),
                             column_of<double>("error_below", "px", "", answers, &CheapestBelow::error_px),
                             column_of<Table>("cheapest", "", "", answers, point(&CheapestBelow::point)),
                             column_of<Table>("paper", "", "", answers, point(&CheapestBelow::paper_point))}};
  Table paper = paper_table(study);
  paper.columns.resize(4);  // Without velocities.
  return {std::move(clock), orders_table(study), std::move(cheapest), std::move(paper)};
}

}  // namespace hyrax
