#include "tools/hyrax-sim/study_speed_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "sim/reference/gsl_flight.h"
#include "sim/study/solver_method.h"
#include "sim/study/speed_error.h"
#include "sim/study/speed_error_rules.h"
#include "sim/study/speed_error_tables.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/command_line/progress.h"
#include "tools/hyrax-sim/machine_name.h"
#include "tools/hyrax-sim/steady_clock_ns.h"
#include "tools/report/speed_error_figure.h"

namespace hyrax {
namespace {

// Every stepper of GSL's at every tolerance; in a quick study without the one that takes as long as all the
// others together.
void add_gsl_methods(std::vector<MethodKind>& methods, bool is_quick) {
  const std::vector<double> tolerances =
      is_quick ? std::vector{1e-4, 1e-8, 1e-12} : std::vector{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
  for (std::size_t stepper = 0; stepper < kGslStepperNames.size(); ++stepper)
    for (const double tolerance : tolerances) {
      if (is_quick && static_cast<GslStepper>(stepper) == GslStepper::rk1imp) continue;
      const std::string name(kGslStepperNames[stepper]);
      const GslOptions options{static_cast<GslStepper>(stepper), tolerance};
      const auto make_solver = [options](const Model& model) -> std::unique_ptr<FlightSolver> {
        return std::make_unique<GslFlight>(options, model);
      };
      methods.push_back({.name = fmt::format("gsl-{}-{:g}", name, tolerance),
                         .words = fmt::format("GSL {} at {:g}", name, tolerance),
                         .family = "GSL " + name,
                         .convergence = kToTolerance,
                         .meets_walls = false,
                         .tolerance = tolerance,
                         .make = [make_solver] { return method_of(make_solver); }});
    }
}

std::vector<Problem> problems_of(const StudyRequest& request) {
  std::vector<Problem> problems = study_problems();
  if (request.is_quick) problems = {problems[0], problems[4]};
  std::set<std::string> names;
  for (const Problem& problem : problems) names.insert(problem.name);
  for (const std::string& path : list_scenarios(request.scenarios)) {
    const ScenarioProblem made = problem_of(load_scenario(path));
    if (!made.problem)
      throw Failure(ExitCode::bad_input,
                    path + ": cannot be studied for speed against error: " + made.why_not);
    if (!names.insert(made.problem->name).second)
      throw Failure(ExitCode::bad_input, path + ": /name: another problem is called " + made.problem->name +
                                             "; give it another name");
    problems.push_back(*made.problem);
  }
  return problems;
}

std::vector<double> rates_hz(bool is_quick) {
  if (is_quick) return {15.0, 30.0, 60.0, 240.0, 960.0};
  return {15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0};
}

// A method's point at a rate; nullptr where there is none.
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
    if (fit.problem == problem && fit.method == method) return fmt::format("{:.2f}", fit.order);
  return study.methods[method].convergence == kExact ? "exact" : "-";
}

std::string methods_text(const SpeedError& study, std::size_t problem) {
  const Problem& played = study.problems[problem];
  std::string text = fmt::format("\n{} ({}){}\n{:<32}{:>8}{:>16}{:>18}{:>16}{:>10}\n", played.words,
                                 played.name, played.remark.empty() ? "" : ", " + played.remark, "method",
                                 "order", "error at 60 Hz", "cost at 60 Hz", "least error", "at");
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    if (study.methods[method].tolerance > 0.0) continue;
    const WorkPoint* best = nullptr;
    for (const WorkPoint& point : study.points)
      if (point.problem == problem && point.method == method && !point.errors.is_failed &&
          (best == nullptr || point.errors.position_px < best->errors.position_px))
        best = &point;
    const WorkPoint* at_60 = find_point(study, problem, method, 60.0);
    if (best == nullptr || at_60 == nullptr) continue;
    text += fmt::format("{:<32}{:>8}{:>13.3g} px{:>13.0f} ns/s{:>13.3g} px{:>7.0f} Hz\n",
                        study.methods[method].words, order_text(study, problem, method),
                        at_60->errors.position_px, at_60->cost.median_ns, best->errors.position_px,
                        best->rate_hz);
  }
  return text;
}

// Where and when, at 60 Hz, the paper's step is off at the end and at walls; empty of a flight.
std::string paper_text(const SpeedError& study, std::size_t problem) {
  const WorkPoint* point = find_point(study, problem, 0, 60.0);
  if (point == nullptr || std::isnan(point->errors.contact_time_s)) return "";
  return fmt::format(
      "At 60 Hz the paper's step ends {:.3g} px from the exact place and is up to {:.3g} ms off at the first "
      "impacts.\n",
      point->errors.end_px, 1e3 * point->errors.contact_time_s);
}

std::string point_text(const SpeedError& study, const std::optional<std::size_t>& index) {
  if (!index) return "at no rate";
  const WorkPoint& point = study.points[*index];
  const MethodKind& kind = study.methods[point.method];
  const std::string name =
      kind.tolerance > 0.0 ? kind.words : fmt::format("{}, {:.0f} Hz", kind.words, point.rate_hz);
  return fmt::format("{}: {:.0f} ns/s", name, point.cost.median_ns);
}

std::string cheapest_text(const SpeedError& study, std::size_t problem) {
  std::string text =
      fmt::format("{:<21}{:<54}{}\n", "for an error below", "the cheapest is", "the paper's step costs");
  for (const CheapestBelow& answer : study.cheapest) {
    if (answer.problem != problem) continue;
    std::string paper = point_text(study, answer.paper_point);
    if (answer.paper_point) paper = paper.substr(paper.find(", ") + 2);
    text += fmt::format("{:>15g} px   {:<54}{}\n", answer.error_px, point_text(study, answer.point), paper);
  }
  return text;
}

std::string verdict_of(const SpeedError& study, const std::string& machine, bool has_scenarios) {
  std::string text = fmt::format(
      "Speed against error on {}; its clock was steady to {:.1f} %.\n"
      "Truth: the fixed laws, v' = g - k v with k = 0.06003 1/s (drag as at 60 Hz), from impact to impact.\n",
      machine, 100.0 * study.probe.drift_rel);
  // One screen: a flight and a fling, or the last of the scenarios that were named.
  std::size_t fling = study.problems.size() - 1;
  if (!has_scenarios)
    for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
      if (study.problems[problem].name == "fling") fling = problem;
  text += methods_text(study, 0) + cheapest_text(study, 0);
  text += methods_text(study, fling) + cheapest_text(study, fling) + paper_text(study, fling);
  const std::string sentence = convergence_sentence(study);
  const std::size_t middle = std::min(sentence.find(' ', sentence.size() / 2), sentence.size());
  return text + "\n" + sentence.substr(0, middle) + "\n" +
         sentence.substr(std::min(middle + 1, sentence.size())) + "\n";
}

Json::Object json_of(const SpeedError& study, const std::string& machine) {
  const auto point_json = [&](const std::optional<std::size_t>& index) -> Json {
    if (!index) return nullptr;
    const WorkPoint& point = study.points[*index];
    return Json::Object{{"method", study.methods[point.method].name},
                        {"rate_hz", point.rate_hz},
                        {"position_error_px", point.errors.position_px},
                        {"cost_ns_per_s", point.cost.median_ns}};
  };
  Json::Array orders, cheapest, paper;
  for (const OrderFit& fit : study.orders)
    orders.push_back(Json::Object{{"problem", study.problems[fit.problem].name},
                                  {"method", study.methods[fit.method].name},
                                  {"order", fit.order},
                                  {"analytic_order", study.methods[fit.method].convergence.code()},
                                  {"points", static_cast<std::int64_t>(fit.points)}});
  for (const CheapestBelow& answer : study.cheapest)
    cheapest.push_back(Json::Object{{"problem", study.problems[answer.problem].name},
                                    {"error_below_px", answer.error_px},
                                    {"cheapest", point_json(answer.point)},
                                    {"paper", point_json(answer.paper_point)}});
  for (const PaperErrors& errors : study.paper)
    paper.push_back(Json::Object{{"rate_hz", errors.rate_hz},
                                 {"implementation_px", errors.implementation_px},
                                 {"truncation_px", errors.truncation_px},
                                 {"model_px", errors.model_px}});
  return {{"machine", machine},
          {"clock_drift_rel", study.probe.drift_rel},
          {"repetitions", study.repetitions},
          {"orders", std::move(orders)},
          {"cheapest", std::move(cheapest)},
          {"paper", std::move(paper)}};
}

}  // namespace

StudyOutcome make_speed_error(const StudyRequest& request) {
  std::vector<MethodKind> methods = frame_methods();
  add_gsl_methods(methods, request.is_quick);
  SpeedErrorOptions options;
  options.rates_hz = rates_hz(request.is_quick);
  if (request.is_quick) options.cost.sample_ns = 5'000;
  std::unique_ptr<Progress> progress;
  options.tell = [&](std::int64_t done, std::int64_t total) {
    if (!progress) progress = std::make_unique<Progress>("samples", total);
    progress->show(done);
  };
  const SpeedError study =
      study_speed_error(problems_of(request), std::move(methods), options, steady_clock_ns);
  progress.reset();

  const std::string machine = machine_name();
  StudyOutcome outcome;
  outcome.tables = tables_of(study, machine);
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    outcome.figures.push_back({problem == 0 ? std::string() : "-" + study.problems[problem].name,
                               speed_error_script(study, problem, machine)});
  outcome.verdict = verdict_of(study, machine, !request.scenarios.empty());
  for (const BrokenRule& rule : broken_rules(study))
    outcome.broken.push_back(fmt::format("{} ({}): must be {:.6g} .. {:.6g}, is {:.6g}", rule.rule,
                                         rule.where, rule.low, rule.high, rule.value));
  outcome.json = json_of(study, machine);
  return outcome;
}

}  // namespace hyrax
