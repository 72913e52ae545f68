#include <fmt/format.h>

#include "sim/study/speed_error/speed_error.h"
#include "sim/study/study_table.h"

namespace hyrax {

std::string point_text(const SpeedError& study, std::size_t index) {
  const WorkPoint& point = study.points[index];
  const MethodKind& kind = study.methods[point.method];
  return kind.is_adaptive() ? kind.label : fmt::format("{}, {:.0f} Hz", kind.label, point.rate_hz);
}

namespace {

// With columns of what each record is about: its problem and, if it has one, its method.
template <class Record>
StudyTable<std::vector<Record>> table_by_problem(const SpeedError& study, const std::string& name,
                                                 const std::string& long_name,
                                                 const std::vector<Record>& records) {
  StudyTable table(name, long_name, records);
  table.add("problem", "", "what is played",
            [&](const Record& record) { return study.problems[record.problem].name; });
  if constexpr (requires { &Record::method; })
    table.add("method", "", "name of the method",
              [&](const Record& record) { return study.methods[record.method].name; });
  return table;
}

// As files have it: 0 does not converge, -1 exact, -2 adaptive.
std::int64_t order_code(const Accuracy& accuracy) {
  if (const auto* const convergent = std::get_if<Convergent>(&accuracy)) return convergent->order;
  if (std::holds_alternative<Exact>(accuracy)) return -1;
  return std::holds_alternative<Adaptive>(accuracy) ? -2 : 0;
}

// "12 40": the ranked points of its problem that are not ranked against it.
std::string as_cheap_text(const SpeedError& study, const WorkPoint& point) {
  std::string rows;
  for (const WorkPoint& other : study.points)
    if (&other != &point && other.problem == point.problem && is_ranked(study, other) &&
        is_ranked(study, point) && !is_ranked_cheaper(study, point, other) &&
        !is_ranked_cheaper(study, other, point))
      rows += fmt::format("{}{}", rows.empty() ? "" : " ", &other - study.points.data());
  return rows;
}

Table points_table(const SpeedError& study) {
  using P = const WorkPoint&;
  const auto error = [](double MethodErrors::*part) {
    return [part](P p) { return p.errors.is_failed ? kNotGiven : p.errors.*part; };
  };
  return table_by_problem(study, "points", "each method at each rate or tolerance", study.points)
      .add("rate", "Hz", "frames per second", &WorkPoint::rate_hz)
      .add("dt", "s", "one frame", [](P p) { return 1.0 / p.rate_hz; })
      .add("tolerance", "1", "of an adaptive method; none of one that goes by frames",
           [&](P p) {
             const auto* const adaptive = std::get_if<Adaptive>(&study.methods[p.method].accuracy);
             return adaptive != nullptr ? adaptive->tolerance : kNotGiven;
           })
      .add("failed", "1", "1: the method gave up", [](P p) { return std::int64_t{p.errors.is_failed}; })
      .add("position_error", "px", "largest distance from the exact fling", error(&MethodErrors::position_px))
      .add("velocity_error", "px/s", "largest difference of velocity",
           error(&MethodErrors::velocity_px_per_s))
      .add(
          "energy_error", "1",
          "largest difference of energy while both have met each wall equally often / largest kinetic energy "
          "of the exact fling",
          error(&MethodErrors::energy_rel))
      .add("end_error", "px", "distance of the last positions", error(&MethodErrors::end_px))
      .add("contact_time_error", "s", "largest, of the first three impacts",
           error(&MethodErrors::contact_time_s))
      .add_estimate("cost", "ns/s", "time per simulated second without set-up, median",
                    [](P p) { return p.cost.time_ns; })
      .add("ranked", "1", "1: gives 60 rows a second, is not the truth itself, and its cost is measured",
           [&](P p) { return std::int64_t{is_ranked(study, p)}; })
      .add("as_cheap", "", "ranked rows, from 0, of the problem than which it is neither cheaper nor dearer",
           [&](P p) { return as_cheap_text(study, p); })
      .add("pareto", "1", "1: none as accurate is ranked cheaper",
           [](P p) { return std::int64_t{p.is_pareto}; });
}

Table set_up_table(const SpeedError& study) {
  return table_by_problem(study, "set_up", "time of a run before its first frame", study.set_ups)
      .add_estimate("time", "ns", "median", [](const SetUp& set_up) { return set_up.cost.time_ns; });
}

Table bands_table(const SpeedError& study) {
  return table_by_problem(study, "bands",
                          "each method over many flings like the problem, their starts drawn from the seed",
                          study.bands)
      .add("rate", "Hz", "frames per second", &MethodBands::rate_hz)
      .add("flings", "1", "played", [](const MethodBands& b) { return b.position_px.samples; })
      .add("seed", "1", "of their starts", [](const MethodBands&) { return kBandSeed; })
      .add_band("position_error", "px", "largest distance from the exact fling", &MethodBands::position_px,
                "position_error_median")
      .add_band("end_error", "px", "distance of the last positions", &MethodBands::end_px, "end_error_median")
      .add_band("energy_error", "1", "as energy_error of points", &MethodBands::energy_rel,
                "energy_error_median")
      .add_share("nearer", "flings that end nearer to the exact place than by the paper's step",
                 &MethodBands::nearer)
      .add_share("other_contacts", "flings that meet a side wall or the top another number of times",
                 &MethodBands::other_contacts);
}

// A bin of a method's histogram.
struct EnergyBin : ErrorBin {
  std::size_t problem = 0;
  std::size_t method = 0;
  double rate_hz = 0.0;
};
Table energies_table(const SpeedError& study) {
  std::vector<EnergyBin> bins;
  for (const MethodBands& bands : study.bands)
    for (const ErrorBin& bin : bands.energies)
      bins.push_back({bin, bands.problem, bands.method, bands.rate_hz});
  return table_by_problem(study, "energies", "histogram of energy_error over the flings of bands", bins)
      .add("rate", "Hz", "frames per second", &EnergyBin::rate_hz)
      .add("low", "1", "where the bin begins", &EnergyBin::low)
      .add("high", "1", "where it ends", &EnergyBin::high)
      .add("flings", "1", "whose error is in the bin", &EnergyBin::flings);
}

Table orders_table(const SpeedError& study) {
  return table_by_problem(study, "orders", "fitted order of convergence", study.orders)
      .add("order", "1", "slope of log error against log dt", &OrderFit::order)
      .add("standard_error", "1", "of the slope, of one fling", &OrderFit::standard_error)
      .add("least", "1", "order between neighbouring rates, smallest; of many flings their 10 %",
           &OrderFit::least)
      .add("most", "1", "order between neighbouring rates, largest; of many flings their 90 %",
           &OrderFit::most)
      .add("flings", "1", "of whose orders it is the median", &OrderFit::flings)
      .add("from", "Hz", "lowest rate that it is fitted to", &OrderFit::low_hz)
      .add("to", "Hz", "highest rate that it is fitted to", &OrderFit::high_hz)
      .add("analytic_order", "1", "in free flight; 0 does not converge, -1 exact",
           [&](const OrderFit& fit) { return order_code(study.methods[fit.method].accuracy); })
      .add("points", "1", "rates that it is fitted to", &OrderFit::points);
}

Table least_table(const SpeedError& study) {
  return table_by_problem(study, "least", "the least error of all rates, by a scan", study.least)
      .add("rate", "Hz", "frames per second", &LeastError::rate_hz)
      .add("position_error", "px", "largest distance from the exact fling", &LeastError::position_px);
}

Table cheapest_table(const SpeedError& study) {
  using A = const CheapestBelow&;
  const auto rate = [&](PointIndex CheapestBelow::*point) {
    return [&study, point](A a) { return a.*point ? study.points[*(a.*point)].rate_hz : kNotGiven; };
  };
  const auto cost = [&](PointIndex CheapestBelow::*point) {
    return
        [&study, point](A a) { return a.*point ? study.points[*(a.*point)].cost.time_ns.median : kNotGiven; };
  };
  return table_by_problem(study, "cheapest",
                          "the cheapest method below an error, and what the paper's step costs for it",
                          study.cheapest)
      .add("error", "px", "to stay below", &CheapestBelow::error_px)
      .add("method", "", "the cheapest",
           [&](A a) { return a.point ? study.methods[study.points[*a.point].method].name : "none"; })
      .add("rate", "Hz", "its frames per second", rate(&CheapestBelow::point))
      .add("cost", "ns/s", "its median cost", cost(&CheapestBelow::point))
      .add("as_cheap", "", "others than which it is not ranked cheaper, or whose cost is not measured",
           [&](A a) {
             std::string names;
             for (const std::size_t point : a.as_cheap)
               names += (names.empty() ? "" : "; ") + point_text(study, point);
             return names;
           })
      .add("paper_rate", "Hz", "of the paper's step; none: at no rate that is ranked",
           rate(&CheapestBelow::paper_point))
      .add("paper_cost", "ns/s", "its median cost", cost(&CheapestBelow::paper_point));
}

Table paper_table(const SpeedError& study) {
  return StudyTable(
             "paper",
             "the paper's step in free flight (" + study.problems.front().name + ") against three laws",
             study.paper)
      .add("rate", "Hz", "frames per second", &PaperErrors::rate_hz)
      .add("implementation", "px", "from its own closed form", &PaperErrors::implementation_px)
      .add("truncation", "px", "from the ODE with the drag rate of this frame", &PaperErrors::truncation_px)
      .add("model", "px", "from the ODE with the drag rate of 60 Hz", &PaperErrors::model_px)
      .add("truncation_expected", "px", "the truncation by its closed form",
           &PaperErrors::truncation_expected_px);
}

Table clock_table(const SpeedError& study, const std::string& machine) {
  return {
      "clock",
      "where and how the times were measured",
      {{"machine", "", "processor", std::vector{machine}},
       {"processes", "1", "each with a layout in memory of its own",
        std::vector<std::int64_t>{study.cost.processes}},
       {"rounds", "1", "of each process, each work once a round, in random order",
        std::vector<std::int64_t>{study.cost.rounds}},
       {"order_seed", "1", "of the random orders", std::vector{static_cast<std::int64_t>(kOrderSeed)}},
       {"pairs", "1", "of points of one problem that can be ranked", std::vector{study.comparisons}},
       {"ranked_pairs", "1", "of which one is cheaper in every process", std::vector{study.ranked_pairs}},
       {"probe", "ns", "median time of the same piece of arithmetic", std::vector{study.probe.median_ns}},
       {"probe_drift", "1", "its 95th minus its 5th percentile / median", std::vector{study.probe.drift_rel}},
       {"steady", "1", "1: steady enough for costs; 0: they are not measured",
        std::vector<std::int64_t>{study.probe.is_steady()}}}};
}

}  // namespace

std::vector<Table> speed_error_tables(const SpeedError& study, const std::string& machine) {
  return {points_table(study), orders_table(study),         cheapest_table(study),
          paper_table(study),  clock_table(study, machine), set_up_table(study),
          bands_table(study),  energies_table(study),       least_table(study)};
}

std::vector<Table> speed_error_summary(const SpeedError& study, const std::string& machine) {
  Table clock{
      .columns = {{.name = "machine", .values = std::vector{machine}},
                  {.name = "clock_drift_rel", .values = std::vector{study.probe.drift_rel}},
                  {.name = "clock_steady", .values = std::vector{study.probe.is_steady()}},
                  {.name = "processes", .values = std::vector<std::int64_t>{study.cost.processes}},
                  {.name = "rounds", .values = std::vector<std::int64_t>{study.cost.rounds}},
                  {.name = "order_seed", .values = std::vector{static_cast<std::int64_t>(kOrderSeed)}},
                  {.name = "pairs", .values = std::vector{study.comparisons}},
                  {.name = "ranked_pairs", .values = std::vector{study.ranked_pairs}}},
      .form = JsonForm::members};
  const auto point = [&](PointIndex CheapestBelow::*index) {
    return [&study, index](const CheapestBelow& answer) {
      std::vector<WorkPoint> points;
      if (answer.*index) points.push_back(study.points[*(answer.*index)]);
      using P = const WorkPoint&;
      Table table =
          StudyTable(points)
              .add("method", "", "name of the method", [&](P p) { return study.methods[p.method].name; })
              .add("rate", "Hz", &WorkPoint::rate_hz)
              .add("position_error", "px", [](P p) { return p.errors.position_px; })
              .add("cost", "ns/s", [](P p) { return p.cost.time_ns.median; });
      table.form = JsonForm::one;
      return table;
    };
  };
  const Table cheapest = table_by_problem(study, "cheapest", "", study.cheapest)
                             .add("error_below", "px", &CheapestBelow::error_px)
                             .add("cheapest", "", point(&CheapestBelow::point))
                             .add("paper", "", point(&CheapestBelow::paper_point));
  Table paper = paper_table(study);
  paper.columns.resize(4);  // Without velocities.
  return {clock, orders_table(study), least_table(study), cheapest,
          paper, bands_table(study),  set_up_table(study)};
}

}  // namespace hyrax
