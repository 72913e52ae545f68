// `hyrax-sim study speed-error`: its verdict, and what is played.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "sim/study/speed_error/speed_error.h"
#include "sim/study/study.h"

namespace hyrax {
namespace {

using PointIndex = std::optional<std::size_t>;

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
    if (fit.problem == problem && fit.method == method) return fmt::format("{:.2f}", fit.order);
  return std::holds_alternative<Exact>(study.methods[method].accuracy) ? "exact" : "-";
}

// A line each method that goes by frames.
Table methods_text(const SpeedError& study, std::size_t problem) {
  struct Line {
    std::size_t method;
    const WorkPoint *at_60, *best;
  };
  std::vector<Line> lines;
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    if (study.methods[method].is_adaptive()) continue;
    const WorkPoint* best = nullptr;
    for (const WorkPoint& point : study.points)
      if (point.problem == problem && point.method == method && !point.errors.is_failed &&
          (best == nullptr || point.errors.position_px < best->errors.position_px))
        best = &point;
    const WorkPoint* const at_60 = find_point(study, problem, method, 60.0);
    if (best != nullptr && at_60 != nullptr) lines.push_back({method, at_60, best});
  }
  using L = const Line&;
  return {
      .columns = {
          column_of<std::string>("method", "", "", lines, [&](L l) { return study.methods[l.method].label; }),
          column_of<std::string>("order", "", "", lines,
                                 [&](L l) { return order_text(study, problem, l.method); }),
          column_of<double>("error_at_60_Hz", "px", "", lines,
                            [](L l) { return l.at_60->errors.position_px; }),
          column_of<double>(
              "cost_at_60_Hz", "ns/s", "", lines, [](L l) { return l.at_60->cost.median_ns; }, 3),
          column_of<double>("least_error", "px", "", lines, [](L l) { return l.best->errors.position_px; }),
          column_of<double>("at", "Hz", "", lines, [](L l) { return l.best->rate_hz; })}};
}

std::string point_text(const SpeedError& study, const PointIndex& index) {
  if (!index) return "no method at any rate";
  const WorkPoint& point = study.points[*index];
  const MethodKind& kind = study.methods[point.method];
  return kind.is_adaptive() ? kind.label : fmt::format("{}, {:.0f} Hz", kind.label, point.rate_hz);
}

Table cheapest_text(const SpeedError& study, std::size_t problem) {
  std::vector<CheapestBelow> answers;
  for (const CheapestBelow& answer : study.cheapest)
    if (answer.problem == problem) answers.push_back(answer);
  using A = const CheapestBelow&;
  const auto cost = [&](PointIndex CheapestBelow::*index) {
    return [&study, index](A a) { return a.*index ? study.points[*(a.*index)].cost.median_ns : kNotGiven; };
  };
  const auto paper = [&](A a) {
    return a.paper_point ? fmt::format("{:.0f} Hz", study.points[*a.paper_point].rate_hz) : "at no rate";
  };
  return {.columns = {column_of<double>("for_an_error_below", "px", "", answers, &CheapestBelow::error_px),
                      column_of<std::string>("the_cheapest_is", "", "", answers,
                                             [&](A a) { return point_text(study, a.point); }),
                      column_of<double>("at", "ns/s", "", answers, cost(&CheapestBelow::point), 3),
                      column_of<std::string>("the_paper's_step_needs", "", "", answers, paper),
                      column_of<double>("at", "ns/s", "", answers, cost(&CheapestBelow::paper_point), 3)}};
}

// How far off the paper's step is at 60 Hz at the end and at walls; empty of a flight.
std::string paper_text(const SpeedError& study, std::size_t problem) {
  const WorkPoint* const point = find_point(study, problem, 0, 60.0);
  if (point == nullptr || std::isnan(point->errors.contact_time_s)) return "";
  return fmt::format(
      "At 60 Hz the paper's step ends {:.3g} px from the exact position, and its first impacts are up to "
      "{:.3g} "
      "ms off.",
      point->errors.end_px, 1e3 * point->errors.contact_time_s);
}

// One screen: a flight, and a fling or the last of the scenarios that were given.
Verdict verdict_of(const SpeedError& study, const StudyRequest& request) {
  std::size_t fling = study.problems.size() - 1;
  if (request.scenarios.empty())
    for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
      if (study.problems[problem].name == "fling") fling = problem;
  Verdict verdict{
      {fmt::format("Speed against error on {}; its clock was steady to {:.1f} %.", request.machine,
                   100.0 * study.probe.drift_rel),
       "Exact: the fixed laws, v' = g - k v with k = 0.06003 1/s (drag as at 60 Hz), from impact to "
       "impact."},
      broken_rules(study)};
  for (const std::size_t problem : {std::size_t{0}, fling}) {
    const Problem& played = study.problems[problem];
    verdict.text.push_back(fmt::format("\n{} ({}){}", played.label, played.name,
                                       played.remark.empty() ? "" : ", " + played.remark));
    verdict.text.push_back(methods_text(study, problem));
    verdict.text.push_back(cheapest_text(study, problem));
  }
  if (const std::string sentence = paper_text(study, fling); !sentence.empty())
    verdict.text.push_back(sentence);
  for (const std::string& sentence : convergence_sentences(study)) verdict.text.push_back(sentence);
  return verdict;
}

std::vector<Problem> problems_of(const StudyRequest& request) {
  std::vector<Problem> problems = study_problems();
  if (request.is_quick) problems = {problems[0], problems[4]};
  std::set<std::string> names;
  for (const Problem& problem : problems) names.insert(problem.name);
  for (const NamedScenario& given : request.scenarios) {
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

StudyResult run(const StudyRequest& request) {
  std::vector<MethodKind> methods = frame_methods();
  for (MethodKind& kind : gsl_methods(request.is_quick)) methods.push_back(std::move(kind));
  SpeedErrorOptions options;
  options.rates_hz = {15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0};
  if (request.is_quick) {
    options.rates_hz = {15.0, 30.0, 60.0, 240.0, 960.0};
    options.cost.sample_ns = 5'000;
  }
  options.report_progress = [&](std::int64_t done, std::int64_t total) {
    if (request.report_progress) request.report_progress("samples", done, total);
  };
  const SpeedError study =
      study_speed_error(problems_of(request), std::move(methods), options, request.now_ns);
  StudyResult result{.tables = speed_error_tables(study, request.machine),
                     .verdict = verdict_of(study, request),
                     .summary = speed_error_summary(study, request.machine)};
  for (std::size_t problem = 0; problem < study.problems.size(); ++problem)
    result.figures.push_back(speed_error_figure(study, problem, request.machine));
  return result;
}

}  // namespace

Study speed_error_study() {
  return {.name = "speed-error",
          .summary = "what every method and rate costs, and how far it is from the exact motion",
          .takes_scenarios = true,
          .run = run};
}

}  // namespace hyrax
