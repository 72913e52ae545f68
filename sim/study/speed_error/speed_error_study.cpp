// `hyrax-sim study speed-error`: its verdict, and what is played.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "sim/result/number_text.h"
#include "sim/study/reference_model.h"
#include "sim/study/speed_error/speed_error.h"
#include "sim/study/study.h"
#include "sim/study/study_table.h"

namespace hyrax {
namespace {

constexpr std::string_view kFlingName = "fling";  // Of study_problems().
constexpr double kGslEnd_px = 1e-6;

// A method's point at a rate; nullptr if there is none.
const WorkPoint* find_point(const SpeedError& study, std::size_t problem, std::size_t method,
                            double rate_hz) {
  for (const WorkPoint& point : study.points)
    if (point.problem == problem && point.method == method && point.rate_hz == rate_hz &&
        !point.errors.is_failed)
      return &point;
  return nullptr;
}

std::string order_text(const SpeedError& study, std::size_t problem, std::size_t method) {
  for (const OrderFit& fit : study.orders)
    if (fit.problem == problem && fit.method == method)
      return fit.flings > 1 ? fmt::format("{:.2f} ({:.2f} .. {:.2f})", fit.order, fit.least, fit.most)
                            : fmt::format("{:.2f} ± {:.2f}", fit.order, fit.standard_error);
  return std::holds_alternative<Exact>(study.methods[method].accuracy) ? "exact" : "-";
}

// "187 (185 .. 190)": the median and its interval; "-": not measured.
std::string cost_text(const Cost& cost) {
  if (!cost.is_measured()) return "-";
  return interval_text(cost.time_ns.median, cost.time_ns.low, cost.time_ns.high);
}

std::string band_text(const Band& band) {
  constexpr double kRounding_px = 1e-6;
  if (band.high < kRounding_px) return "rounding";
  return fmt::format("{} ({} .. {})", rounded(band.median, 3), rounded(band.low, 3), rounded(band.high, 3));
}

std::string set_up_text(const SpeedError& study, std::size_t problem, std::size_t method) {
  for (const SetUp& set_up : study.set_ups)
    if (set_up.problem == problem && set_up.method == method && set_up.cost.is_measured())
      return fmt::format("{:.0f}", set_up.cost.time_ns.median);
  return "-";
}

// A line each method that goes by frames.
Table methods_text(const SpeedError& study, std::size_t problem) {
  std::vector<LeastError> lines;
  std::ranges::copy_if(study.least, std::back_inserter(lines), [&](const LeastError& least) {
    return least.problem == problem && find_point(study, problem, least.method, 60.0) != nullptr;
  });
  using L = const LeastError&;
  const auto at_60 = [&](L l) -> const WorkPoint& { return *find_point(study, problem, l.method, 60.0); };
  return StudyTable(lines)
      .add("method", "", [&](L l) { return study.methods[l.method].label; })
      .add("order", "", [&](L l) { return order_text(study, problem, l.method); })
      .add("error_at_60_Hz", "px", [&](L l) { return at_60(l).errors.position_px; })
      .add("cost_at_60_Hz,_ns/s", "", [&](L l) { return cost_text(at_60(l).cost); })
      .add("set-up,_ns", "", [&](L l) { return set_up_text(study, problem, l.method); })
      .add("least_error", "px", &LeastError::position_px)
      .add("at", "Hz", &LeastError::rate_hz);
}

// A line each of GSL's steppers, at the loosest tolerance that ends near enough; nothing where they do not
// play.
std::optional<Table> gsl_text(const SpeedError& study, std::size_t problem) {
  struct Line {
    std::size_t method;
    const WorkPoint *end_only, *rows;
  };
  std::vector<Line> lines;
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    const std::string& family = study.methods[method].family;
    const WorkPoint* const end_only =
        find_point(study, problem, method, end_only_hz(study.problems[problem]));
    const WorkPoint* const rows = find_point(study, problem, method, kRowRate_hz);
    if (family.empty() || end_only == nullptr || rows == nullptr) continue;
    if (!(end_only->errors.end_px < kGslEnd_px)) continue;
    if (lines.empty() || study.methods[lines.back().method].family != family)
      lines.push_back({method, end_only, rows});
  }
  if (lines.empty()) return std::nullopt;
  using L = const Line&;
  return StudyTable(lines)
      .add("stepper", "", [&](L l) { return study.methods[l.method].label; })
      .add("end_only", "px", [](L l) { return l.end_only->errors.end_px; })
      .add("60_rows", "px", [](L l) { return l.rows->errors.position_px; })
      .add("cost,_end_only,_ns/s", "", [](L l) { return cost_text(l.end_only->cost); })
      .add("cost,_60_rows,_ns/s", "", [](L l) { return cost_text(l.rows->cost); });
}

// The cheapest, and how many others the noise hides behind it.
std::string cheapest_name(const SpeedError& study, const CheapestBelow& answer) {
  if (!answer.point) return answer.as_cheap.empty() ? "no method at any rate" : unsteady_text({});
  std::string name = point_text(study, *answer.point);
  if (answer.as_cheap.empty()) return name;
  return name + " or " +
         (answer.as_cheap.size() == 1 ? point_text(study, answer.as_cheap.front())
                                      : fmt::format("{} others", answer.as_cheap.size()));
}

// How costs were measured and ranked, and how many were not.
std::string costs_text(const SpeedError& study) {
  std::string text = fmt::format(
      "Costs: {} processes of {} rounds (order seed {}); of {} pairs {:.1f} % are ranked, each the same in "
      "all.",
      study.cost.processes, study.cost.rounds, kOrderSeed,
      with_decimals(static_cast<double>(study.comparisons), 0),
      study.comparisons == 0
          ? 0.0
          : 100.0 * static_cast<double>(study.ranked_pairs) / static_cast<double>(study.comparisons));
  const auto unsteady = std::ranges::count_if(study.points, [](const WorkPoint& point) {
    return !point.errors.is_failed && !point.cost.is_measured();
  });
  if (unsteady > 0) text += fmt::format(" Of {} they are {}.", counted(unsteady, "point"), unsteady_text({}));
  return text;
}

Table cheapest_text(const SpeedError& study, std::size_t problem) {
  std::vector<CheapestBelow> answers;
  for (const CheapestBelow& answer : study.cheapest)
    if (answer.problem == problem) answers.push_back(answer);
  using A = const CheapestBelow&;
  const auto cost = [&](PointIndex CheapestBelow::*index) {
    return
        [&study, index](A a) { return a.*index ? study.points[*(a.*index)].cost.time_ns.median : kNotGiven; };
  };
  const auto paper = [&](A a) {
    if (a.paper_point) return fmt::format("{:.0f} Hz", study.points[*a.paper_point].rate_hz);
    for (const LeastError& least : study.least)
      if (least.problem == a.problem && least.method == 0 && least.position_px < a.error_px)
        return fmt::format("{:.4g} Hz", least.rate_hz);
    return std::string("at no rate");
  };
  return StudyTable(answers)
      .add("for_an_error_below", "px", &CheapestBelow::error_px)
      .add("the_cheapest_is", "", [&](A a) { return cheapest_name(study, a); })
      .add("at", "ns/s", cost(&CheapestBelow::point), 3)
      .add("the_paper's_step_needs", "", paper)
      .add("at", "ns/s", cost(&CheapestBelow::paper_point), 3);
}

// A line each method at 60 Hz, over flings like the problem.
Table bands_text(const std::vector<MethodBands>& bands, const SpeedError& study) {
  using B = const MethodBands&;
  const auto count = [](Share MethodBands::*share) {
    return [share](B b) { return fmt::format("{} of {}", (b.*share).count, (b.*share).of); };
  };
  return StudyTable(bands)
      .add("method", "", [&](B b) { return study.methods[b.method].label; })
      .add("largest_distance,_px", "", [](B b) { return band_text(b.position_px); })
      .add("at_the_end,_px", "", [](B b) { return band_text(b.end_px); })
      .add("energy,_%", "",
           [](B b) {
             const auto& [samples, median, low, high] = b.energy_rel;
             return band_text({samples, 100.0 * median, 100.0 * low, 100.0 * high});
           })
      .add("ends_nearer_in", "", count(&MethodBands::nearer))
      .add("other_contacts_in", "", count(&MethodBands::other_contacts));
}

// The bands of a problem: what is played, the table, and what they say of the exact flight step.
void add_bands(Verdict& verdict, const SpeedError& study, std::size_t problem) {
  std::vector<MethodBands> bands;
  std::copy_if(study.bands.begin(), study.bands.end(), std::back_inserter(bands),
               [&](const MethodBands& b) { return b.problem == problem && b.rate_hz == 60.0; });
  if (bands.empty()) return;
  verdict.text.push_back(fmt::format(
      "{} flings like it at 60 Hz (start within {:g} px, speeds within {:g} %, seed {}): median (10 .. 90 %)",
      bands.front().position_px.samples, kBandStart_px, 100.0 * kBandSpeed_rel, kBandSeed));
  verdict.text.push_back(bands_text(bands, study));
  for (const MethodBands& b : bands)
    if (study.methods[b.method].name == "exact-flight")
      verdict.text.push_back(fmt::format(
          "At {:.0f} Hz the {} ends nearer to the exact place than the paper's step in {} of {} flings "
          "({:.0f} .. {:.0f} %): {}.",
          b.rate_hz, study.methods[b.method].label, b.nearer.count, b.nearer.of, 100.0 * b.nearer.low(),
          100.0 * b.nearer.high(), nearness_text(b.nearer)));
}

// How far off the paper's step is at 60 Hz at the end and at walls; empty of a flight.
std::string paper_text(const SpeedError& study, std::size_t problem) {
  const WorkPoint* const point = find_point(study, problem, 0, 60.0);
  if (point == nullptr || std::isnan(point->errors.contact_time_s)) return "";
  return fmt::format(
      "At 60 Hz the paper's step ends {} px from the exact position, and its first impacts are up to {} ms "
      "off.",
      rounded(point->errors.end_px, 3), rounded(1e3 * point->errors.contact_time_s, 3));
}

// "At 60 Hz the paper's step is 45.6 px off, exact flight and impacts 3e-12 px.": over the flings like the
// problem, else in the problem.
std::string answer_of(const SpeedError& study, std::size_t problem) {
  std::string text;
  for (const std::string_view name : {"paper", "exact-impacts"}) {
    const auto method = static_cast<std::size_t>(std::ranges::find(study.methods, name, &MethodKind::name) -
                                                 study.methods.begin());
    const WorkPoint* const point = find_point(study, problem, method, 60.0);
    double error_px = point == nullptr ? kNotGiven : point->errors.position_px;
    for (const MethodBands& bands : study.bands)
      if (bands.problem == problem && bands.method == method && bands.rate_hz == 60.0)
        error_px = bands.position_px.median;
    if (!std::isnan(error_px))
      text += fmt::format("{}{} {}{} px{}", text.empty() ? "At 60 Hz " : ", ", study.methods[method].label,
                          text.empty() ? "is " : "", rounded(error_px, 3), text.empty() ? " off" : "");
  }
  return text + ".";
}

std::vector<Problem> problems_of(const StudyRequest& request) {
  std::vector<Problem> problems = study_problems(FixedLaws(reference_model(request.core)));
  if (request.is_quick)
    problems = {problems.front(), *std::ranges::find(problems, kFlingName, &Problem::name)};
  std::set<std::string> names;
  for (const Problem& problem : problems) names.insert(problem.name);
  for (const NamedScenario& given : request.scenarios) {
    if (given.scenario.parameters != request.core.parameters)
      throw RequestRefused(given.path +
                           ": /parameters: differ from another scenario's; a study of speed against error "
                           "compares methods for one set of constants");
    const ScenarioProblem made = problem_of(given.scenario);
    if (!made.problem)
      throw RequestRefused(given.path + ": cannot be studied for speed against error: " + made.why_not);
    if (!names.insert(made.problem->name).second)
      throw RequestRefused(given.path + ": /name: must differ from the other problems' (found " +
                           made.problem->name + "); give it another name");
    problems.push_back(*made.problem);
  }
  return problems;
}

// The whole fling first: it is what a user sees.
std::vector<Figure> figures_of(const SpeedError& study, const std::string& machine) {
  std::vector<Figure> figures;
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem) {
    const bool is_first = study.problems[problem].name == kFlingName;
    Figure figure = speed_error_figure(study, problem, machine);
    if (is_first) figure.suffix.clear();
    figures.insert(is_first ? figures.begin() : figures.end(), std::move(figure));
  }
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    for (std::optional<Figure> figure : {bands_figure(study, problem), energies_figure(study, problem)})
      if (figure) figures.push_back(std::move(*figure));
  return figures;
}

Result run_speed_error(const StudyRequest& request) {
  std::vector<MethodKind> methods = frame_methods(request.core);
  for (MethodKind& kind : gsl_methods(request.core, request.is_quick)) methods.push_back(std::move(kind));
  SpeedErrorOptions options;
  options.rates_hz = {15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0};
  options.band_rates_hz = {15.0, 30.0, 60.0, 120.0, 240.0, 480.0};
  options.order_rates_hz = {60.0, 120.0, 240.0, 480.0, 960.0};
  if (request.is_quick) {
    options.rates_hz = {15.0, 30.0, 60.0, 240.0, 960.0};
    options.band_rates_hz = {60.0};
    options.order_rates_hz = {60.0, 120.0, 240.0};
    options.order_flings = 20;
    options.cost.sample_ns = 5'000;
  }
  options.cost.is_only = request.is_costs_only;
  const SpeedError study = study_speed_error(request.core, problems_of(request), std::move(methods), options,
                                             request.measure_costs);
  if (request.is_costs_only) return {};
  return {.tables = speed_error_tables(study, request.machine),
          .figures = figures_of(study, request.machine),
          .verdict = speed_error_verdict(study, request.machine, !request.scenarios.empty()),
          .summary = speed_error_summary(study, request.machine)};
}

}  // namespace

Verdict speed_error_verdict(const SpeedError& study, const std::string& machine, bool has_scenarios) {
  std::size_t fling = study.problems.size() - 1;
  if (!has_scenarios)
    for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
      if (study.problems[problem].name == kFlingName) fling = problem;
  Verdict verdict{
      answer_of(study, fling),
      {study.probe.is_steady()
           ? fmt::format("Speed against error on {}; its clock was steady to {:.1f} %.\n{}", machine,
                         100.0 * study.probe.drift_rel, costs_text(study))
           : fmt::format("Speed against error on {}; costs are {}.", machine, unsteady_text(study.probe)),
       fmt::format(
           "Exact: the fixed laws, v' = g - k v with k = {:.4g} 1/s (drag as at 60 Hz), from impact to "
           "impact.",
           study.laws.drag_rate_per_s)},
      broken_rules(study)};
  for (const std::size_t problem : {std::size_t{0}, fling}) {
    const Problem& played = study.problems[problem];
    verdict.text.push_back(fmt::format("\n{} ({}){}", played.label, played.name,
                                       played.remark.empty() ? "" : ", " + played.remark));
    verdict.text.push_back(methods_text(study, problem));
    if (study.probe.is_steady()) {
      verdict.text.push_back(
          fmt::format("  cheapest of 60 rows a second (\"or\": not cheaper than these in every process; \"at "
                      "no rate\": none "
                      "from {:g} to {:g} Hz)",
                      study.low_hz, study.high_hz));
      verdict.text.push_back(cheapest_text(study, problem));
    }
    if (std::optional<Table> steppers = gsl_text(study, problem)) {
      verdict.text.push_back(
          fmt::format("  GSL's steppers at the loosest tolerance that ends within {:g} px: the end only, and "
                      "60 rows a second",
                      kGslEnd_px));
      verdict.text.push_back(std::move(*steppers));
    }
    add_bands(verdict, study, problem);
  }
  if (const std::string sentence = paper_text(study, fling); !sentence.empty())
    verdict.text.push_back(sentence);
  for (const std::string& sentence : convergence_sentences(study)) verdict.text.push_back(sentence);
  return verdict;
}

Study speed_error_study() {
  return {.name = "speed-error",
          .summary = "what every method and rate costs, and how far it is from the exact motion",
          .run = run_speed_error};
}

}  // namespace hyrax
