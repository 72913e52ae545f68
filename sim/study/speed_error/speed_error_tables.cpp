#include <tuple>

#include <fmt/format.h>

#include "sim/study/speed_error/speed_error.h"

namespace hyrax {

std::string point_text(const SpeedError& study, std::size_t index) {
  const WorkPoint& point = study.points[index];
  const MethodKind& kind = study.methods[point.method];
  return kind.is_adaptive() ? kind.label : fmt::format("{}, {:.0f} Hz", kind.label, point.rate_hz);
}

namespace {

// Of records with a cost; NaN: not measured.
template <class Record>
Column cost_column(const std::string& name, const std::string& unit, const std::string& long_name,
                   const std::vector<Record>& records, double MedianEstimate::*part) {
  return column_of(name, unit, long_name, records,
                   [part](const Record& record) { return record.cost.time_ns.*part; });
}

template <class Record>
Column problem_column(const SpeedError& study, const std::vector<Record>& records) {
  return column_of("problem", "", "what is played", records,
                   [&](const Record& record) { return study.problems[record.problem].name; });
}
template <class Record>
Column method_column(const SpeedError& study, const std::vector<Record>& records) {
  return column_of("method", "", "name of the method", records,
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
  return {
      "points",
      "each method at each rate or tolerance",
      {problem_column(study, points), method_column(study, points),
       column_of("rate", "Hz", "frames per second", points, &WorkPoint::rate_hz),
       column_of("dt", "s", "one frame", points, [](P p) { return 1.0 / p.rate_hz; }),
       column_of("tolerance", "1", "of an adaptive method; none of one that goes by frames", points,
                 [&](P p) {
                   const auto* const adaptive = std::get_if<Adaptive>(&study.methods[p.method].accuracy);
                   return adaptive != nullptr ? adaptive->tolerance : kNotGiven;
                 }),
       column_of("failed", "1", "1: the method gave up", points,
                 [](P p) { return std::int64_t{p.errors.is_failed}; }),
       column_of("position_error", "px", "largest distance from the exact fling", points,
                 error(&MethodErrors::position_px)),
       column_of("velocity_error", "px/s", "largest difference of velocity", points,
                 error(&MethodErrors::velocity_px_per_s)),
       column_of("energy_error", "1",
                 "largest difference of energy / largest kinetic energy of the exact fling", points,
                 error(&MethodErrors::energy_rel)),
       column_of("end_error", "px", "distance of the last positions", points, error(&MethodErrors::end_px)),
       column_of("contact_time_error", "s", "largest, of the first three impacts", points,
                 error(&MethodErrors::contact_time_s)),
       cost_column("cost", "ns/s", "time per simulated second without set-up, median", points,
                   &MedianEstimate::median),
       cost_column("cost_low", "ns/s", "95 % interval of the median, low end", points, &MedianEstimate::low),
       cost_column("cost_high", "ns/s", "95 % interval of the median, high end", points,
                   &MedianEstimate::high),
       column_of("ranked", "1", "1: gives 60 rows a second, and is not the truth itself", points,
                 [&](P p) { return std::int64_t{is_ranked(study, p)}; }),
       column_of("pareto", "1", "1: none as accurate is cheaper beyond the noise", points,
                 [](P p) { return std::int64_t{p.is_pareto}; })}};
}

Table set_up_table(const SpeedError& study) {
  const auto& set_ups = study.set_ups;
  return {
      "set_up",
      "time of a run before its first frame",
      {problem_column(study, set_ups), method_column(study, set_ups),
       cost_column("time", "ns", "median", set_ups, &MedianEstimate::median),
       cost_column("time_low", "ns", "95 % interval of the median, low end", set_ups, &MedianEstimate::low),
       cost_column("time_high", "ns", "95 % interval of the median, high end", set_ups,
                   &MedianEstimate::high)}};
}

Table bands_table(const SpeedError& study) {
  const auto& bands = study.bands;
  using B = const MethodBands&;
  Table table{"bands",
              "each method over many flings like the problem, their starts drawn from the seed",
              {problem_column(study, bands), method_column(study, bands),
               column_of("rate", "Hz", "frames per second", bands, &MethodBands::rate_hz),
               column_of("flings", "1", "played", bands, [](B b) { return b.position_px.samples; }),
               column_of("seed", "1", "of their starts", bands, [](B) { return kBandSeed; })}};
  const auto add_band = [&](const std::string& name, const std::string& what, Band MethodBands::*band) {
    for (const auto& [suffix, text, part] :
         {std::tuple{"_median", "median", &Band::median}, std::tuple{"_low", "10 %", &Band::low},
          std::tuple{"_high", "90 %", &Band::high}})
      table.columns.push_back(column_of(name + suffix, "px", what + ", " + text, bands,
                                        [band, part = part](B b) { return b.*band.*part; }));
  };
  const auto add_share = [&](const std::string& name, const std::string& what, Share MethodBands::*share) {
    table.columns.push_back(
        column_of(name, "1", "flings that " + what, bands, [share](B b) { return (b.*share).count; }));
    table.columns.push_back(column_of(name + "_share_low", "1", "95 % interval of their share", bands,
                                      [share](B b) { return (b.*share).low(); }));
    table.columns.push_back(column_of(name + "_share_high", "1", "95 % interval of their share", bands,
                                      [share](B b) { return (b.*share).high(); }));
  };
  add_band("position_error", "largest distance from the exact fling", &MethodBands::position_px);
  add_band("end_error", "distance of the last positions", &MethodBands::end_px);
  add_share("nearer", "end nearer to the exact place than by the paper's step", &MethodBands::nearer);
  add_share("other_contacts", "meet a side wall or the top another number of times",
            &MethodBands::other_contacts);
  return table;
}

Table orders_table(const SpeedError& study) {
  const auto& orders = study.orders;
  return {"orders",
          "fitted order of convergence",
          {problem_column(study, orders), method_column(study, orders),
           column_of("order", "1", "slope of log error against log dt", orders, &OrderFit::order),
           column_of("standard_error", "1", "of the slope", orders, &OrderFit::standard_error),
           column_of("least", "1", "order between neighbouring rates, smallest", orders, &OrderFit::least),
           column_of("most", "1", "order between neighbouring rates, largest", orders, &OrderFit::most),
           column_of("from", "Hz", "lowest rate that it is fitted to", orders, &OrderFit::low_hz),
           column_of("to", "Hz", "highest rate that it is fitted to", orders, &OrderFit::high_hz),
           column_of("analytic_order", "1", "in free flight; 0 does not converge, -1 exact", orders,
                     [&](const OrderFit& fit) { return order_code(study.methods[fit.method].accuracy); }),
           column_of("points", "1", "rates that it is fitted to", orders, &OrderFit::points)}};
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
      return answer.*point ? study.points[*(answer.*point)].cost.time_ns.median : kNotGiven;
    };
  };
  const auto method = [&](const CheapestBelow& answer) {
    return answer.point ? study.methods[study.points[*answer.point].method].name : std::string("none");
  };
  return {"cheapest",
          "the cheapest method below an error, and what the paper's step costs for it",
          {problem_column(study, cheapest),
           column_of("error", "px", "to stay below", cheapest, &CheapestBelow::error_px),
           column_of("method", "", "the cheapest", cheapest, method),
           column_of("rate", "Hz", "its frames per second", cheapest, rate(&CheapestBelow::point)),
           column_of("cost", "ns/s", "its median cost", cheapest, cost(&CheapestBelow::point)),
           column_of("as_cheap", "", "others than which it is not cheaper beyond the noise", cheapest,
                     [&](const CheapestBelow& answer) {
                       std::string names;
                       for (const std::size_t point : answer.as_cheap)
                         names += (names.empty() ? "" : "; ") + point_text(study, point);
                       return names;
                     }),
           column_of("paper_rate", "Hz", "of the paper's step; none: at no rate", cheapest,
                     rate(&CheapestBelow::paper_point)),
           column_of("paper_cost", "ns/s", "its median cost", cheapest, cost(&CheapestBelow::paper_point))}};
}

Table paper_table(const SpeedError& study) {
  const auto& paper = study.paper;
  return {
      "paper",
      "the paper's step in free flight (" + study.problems.front().name + ") against three laws",
      {column_of("rate", "Hz", "frames per second", paper, &PaperErrors::rate_hz),
       column_of("implementation", "px", "from its own closed form", paper, &PaperErrors::implementation_px),
       column_of("truncation", "px", "from the ODE with the drag rate of this frame", paper,
                 &PaperErrors::truncation_px),
       column_of("model", "px", "from the ODE with the drag rate of 60 Hz", paper, &PaperErrors::model_px),
       column_of("truncation_speed", "px/s", "velocity, from the ODE of this frame", paper,
                 &PaperErrors::truncation_px_per_s),
       column_of("truncation_speed_expected", "px/s", "the same by its closed form", paper,
                 &PaperErrors::truncation_expected_px_per_s)}};
}

Table clock_table(const SpeedError& study, const std::string& machine) {
  return {
      "clock",
      "where and how the times were measured",
      {{"machine", "", "processor", std::vector{machine}},
       {"repetitions", "1", "of each point, in random order", std::vector<std::int64_t>{study.repetitions}},
       {"probe", "ns", "median time of the same piece of arithmetic", std::vector{study.probe.median_ns}},
       {"probe_drift", "1", "its 95th minus its 5th percentile / median", std::vector{study.probe.drift_rel}},
       {"steady", "1", "1: steady enough for costs; 0: they are not measured",
        std::vector<std::int64_t>{study.probe.is_steady()}}}};
}

}  // namespace

std::vector<Table> speed_error_tables(const SpeedError& study, const std::string& machine) {
  return {points_table(study),         orders_table(study), cheapest_table(study), paper_table(study),
          clock_table(study, machine), set_up_table(study), bands_table(study)};
}

std::vector<Table> speed_error_summary(const SpeedError& study, const std::string& machine) {
  Table clock{.columns = {{.name = "machine", .values = std::vector{machine}},
                          {.name = "clock_drift_rel", .values = std::vector{study.probe.drift_rel}},
                          {.name = "clock_steady", .values = std::vector{study.probe.is_steady()}},
                          {.name = "repetitions", .values = std::vector<std::int64_t>{study.repetitions}}},
              .shape = JsonShape::members};
  const auto point = [&](PointIndex CheapestBelow::*index) {
    return [&study, index](const CheapestBelow& answer) {
      std::vector<WorkPoint> points;
      if (answer.*index) points.push_back(study.points[*(answer.*index)]);
      return Table{
          .columns = {method_column(study, points), column_of("rate", "Hz", "", points, &WorkPoint::rate_hz),
                      column_of("position_error", "px", "", points,
                                [](const WorkPoint& p) { return p.errors.position_px; }),
                      column_of("cost", "ns/s", "", points,
                                [](const WorkPoint& p) { return p.cost.time_ns.median; })},
          .shape = JsonShape::one};
    };
  };
  const auto& answers = study.cheapest;
  Table cheapest{.name = "cheapest",
                 .columns = {problem_column(study, answers),
                             column_of("error_below", "px", "", answers, &CheapestBelow::error_px),
                             column_of("cheapest", "", "", answers, point(&CheapestBelow::point)),
                             column_of("paper", "", "", answers, point(&CheapestBelow::paper_point))}};
  Table paper = paper_table(study);
  paper.columns.resize(4);  // Without velocities.
  return {std::move(clock), orders_table(study), std::move(cheapest),
          std::move(paper), bands_table(study),  set_up_table(study)};
}

}  // namespace hyrax
