#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/core/core.h"
#include "sim/result/number_text.h"
#include "sim/trajectory/physics_model.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/run_flow.h"
#include "tools/app/play/play.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/summary_text.h"
#include "tools/files/table_text.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// What the run exercised, what it never touched, and what was not computed.
struct Coverage {
  std::vector<std::string> exercised;
  std::vector<std::string> never_touched;
  std::vector<std::string> not_computed;
};

Coverage coverage_of(const Core& core, const ScenarioRun& run) {
  const RunSummary& summary = run.summary;
  Coverage coverage;
  const auto add = [&](bool is_exercised, const char* name) {
    (is_exercised ? coverage.exercised : coverage.never_touched).emplace_back(name);
  };
  const bool is_paper = core.constants.has_value();  // Of another step only the walls are known.
  if (is_paper) {
    add(summary.had_gravity, "gravity");
    add(summary.had_drag, "drag");
  }
  add(summary.clamped_steps.left > 0, "left wall");
  add(summary.clamped_steps.right > 0, "right wall");
  add(summary.clamped_steps.top > 0, "top");
  add(summary.clamped_steps.ground > 0, "ground");
  if (is_paper) {
    add(summary.had_friction, "friction");
    add(summary.rest_steps > 0, "rest rule");
  }
  const std::int64_t skipped = summary.steps - summary.steps_computed;
  if (skipped > 0 && summary.periodic_from_step)
    coverage.not_computed.push_back(
        fmt::format("{} of {} steps (the state repeats every {} from row {})", skipped, summary.steps,
                    summary.period_steps == 1 ? "step" : plain_counted(summary.period_steps, "step"),
                    *summary.periodic_from_step));
  else if (skipped > 0)
    coverage.not_computed.push_back(
        fmt::format("{} of {} steps (the state repeats between inputs)", skipped, summary.steps));
  if (run.rows_recorded < summary.steps + 1)
    coverage.not_computed.push_back(
        fmt::format("{} of {} rows not stored", summary.steps + 1 - run.rows_recorded, summary.steps + 1));
  if (is_paper && !run.drift)
    coverage.not_computed.push_back(fmt::format("reference and energy ({})", program_command({"drift"})));
  if (!run.not_compared.empty())
    coverage.not_computed.push_back(fmt::format("comparison with a golden file ({})", run.not_compared));
  return coverage;
}

std::string counts_text(const WallCounts& counts) {
  std::vector<std::string> names;
  for (const Wall wall : kWalls)
    if (counts[wall] > 0) names.push_back(fmt::format("{} {}", name_of(wall), counts[wall]));
  return names.empty() ? "none" : joined_names(names);
}

Json counts_json(const WallCounts& counts) {
  Json::Object object;
  for (const Wall wall : kWalls) object.emplace_back(name_of(wall), counts[wall]);
  return object;
}

Json golden_json(const ScenarioRun& run) {
  if (run.golden_path.empty()) return nullptr;
  const char* const status = !run.comparison ? "missing" : run.comparison->agrees ? "agreed" : "disagreed";
  Json::Object object{{"file", run.golden_path}, {"status", status}};
  if (run.comparison && !run.comparison->agrees)
    std::ranges::move(comparison_json(*run.comparison), std::back_inserter(object));
  return object;
}

Json sources_json(const Core& core) {
  Json::Object sources;
  for (const Wall wall : kWalls)
    sources.emplace_back(name_of(wall), touches(core.walls_of_rows, wall) ? "rows" : "step");
  return sources;
}

Json list_json(const std::vector<std::string>& names) { return Json::Array(names.begin(), names.end()); }

// Only a trajectory file can be compared.
std::string diff_command_for(const ScenarioRun& run) {
  if (file_name(run.output).extension == ".csv") return diff_commands(run.path, run.golden_path);
  return program_command({"diff", as_argument(run.golden_path), as_argument(run.output)});
}

void print_motion(const Core& core, const RunSummary& summary) {
  const std::string_view why = core.record.why_incomplete;
  const std::string walls = core.sources();
  print_text("  contacts       {}{}{}\n", contacts_text(summary), walls.empty() ? "" : "; " + walls,
             why.empty() ? "" : fmt::format(": the core's step is not complete: {}", why));
  const auto text = [](double value) { return std::isnan(value) ? "NaN" : fmt::format("{:.6g}", value); };
  const Row& end = summary.final;
  print_text("  end            x {} px, y {} px, vx {} px/s, vy {} px/s\n", text(end.x_px), text(end.y_px),
             text(end.vx_px_per_s), text(end.vy_px_per_s));
  if (summary.at_rest_since_s)
    print_text("  settled        since {:.6g} s\n", *summary.at_rest_since_s);
  else
    print_text("  not settled    {}\n", summary.why_not_settled());
}

// "with GRAVITY 980, not the core's own 1200"; several are joined by "; ". Empty: all are the core's own.
std::string parameters_text(const Core& core) {
  std::string text;
  if (core.parameters.empty()) return text;
  const Constants& own = core.own->paper_match.constants.value();
  for (std::size_t place = 0; place < core.constant_names.size(); ++place)
    for (const auto& [name, value] : core.parameters)
      if (name == core.constant_names[place] && value != own.*kConstantFields[place])
        text += fmt::format("{} {} {}, not the core's own {}", text.empty() ? "with" : ";", name, value,
                            own.*kConstantFields[place]);
  return text;
}

void print_details(const RunSummary& summary) {
  print_text("  clamped steps  {}; rest rule {}\n", counts_text(summary.clamped_steps), summary.rest_steps);
  if (summary.periodic_from_step)
    print_text("  repeats        from row {}, every {}\n", *summary.periodic_from_step,
               plain_counted(summary.period_steps, "step"));
}

void print_golden(const ScenarioRun& run) {
  if (run.golden_path.empty()) return;
  if (!run.comparison)
    print_text(
        "  golden         missing: {}{}\n", run.golden_path,
        run.is_as_expected() ? "; to create it: " + bless_command_for({run.path}, run.golden_folder) : "");
  else if (run.comparison->agrees)
    print_text("  golden         {} bit for bit with {}\n", VerdictWord{"agrees", true}, run.golden_path);
  else
    print_text("  golden         {} from {}\n{}  more           {}\n", VerdictWord{"DIFFERS", false},
               run.golden_path, comparison_text(*run.comparison), diff_command_for(run));
}

}  // namespace

void print_run(const Core& core, const ScenarioRun& run, const Printing& printing) {
  const RunSummary& summary = run.summary;
  if (printing.is_quiet()) {
    const std::string_view status = run.status();
    if (status == "played")
      print_text("{}: played{}; written: {}\n", run.scenario.name,
                 run.golden_path.empty() ? "; no golden file and no expect" : ": golden file missing",
                 run.output);
    else
      print_text("{}: {}; written: {}\n", run.scenario.name, VerdictWord{status, run.is_as_expected()},
                 run.output);
    return;
  }
  if (const std::string text = non_finite_text(run.scenario, summary.final); !text.empty())
    print_text("{}: {}; the run ended there\n", VerdictWord{"NOT FINITE", false}, text);
  print_text("{}\n", title_of(run.scenario, summary.steps, summary.simulated_s));
  if (!is_paper_model(core.name)) print_text("  core           {}\n", core.name);
  if (const std::string text = parameters_text(core); !text.empty())
    print_text("  parameters     {}\n", text);
  print_motion(core, summary);
  if (printing.is_verbose()) print_details(summary);
  if (run.start) print_text("{}\n", start_text(*run.start, true));
  const Coverage coverage = coverage_of(core, run);
  print_text("  exercised      {}\n  never touched  {}\n  not computed   {}\n",
             joined_names(coverage.exercised), joined_names(coverage.never_touched),
             joined_names(coverage.not_computed));
  print_expectations(run.expectations, printing.is_verbose());
  print_golden(run);
  print_text("  state hash     {}\n", hex(summary.state_hash));
  print_text("  written        {} ({})\n", run.output, plain_counted(run.rows_recorded, "row"));
}

Json run_json(const Core& core, const ScenarioRun& run) {
  const RunSummary& summary = run.summary;
  const Coverage coverage = coverage_of(core, run);
  Json clamped = counts_json(summary.clamped_steps);
  clamped.get<Json::Object>()->emplace_back("rest", summary.rest_steps);
  Json::Object object{{"scenario", run.path},
                      {"status", run.status()},
                      {"steps", summary.steps},
                      {"simulated_s", summary.simulated_s},
                      {"contacts", counts_json(summary.contacts)},
                      {"bounces", counts_json(summary.bounces)},
                      {"resting_contact_from_step", or_null(summary.resting_contact_from_step)},
                      {"contacts_from", sources_json(core)},
                      {"clamped_steps", clamped},
                      {"final", Json::Object{{"x_px", summary.final.x_px},
                                             {"y_px", summary.final.y_px},
                                             {"vx_px_per_s", summary.final.vx_px_per_s},
                                             {"vy_px_per_s", summary.final.vy_px_per_s}}},
                      {"at_rest_since_s", or_null(summary.at_rest_since_s)},
                      {"periodic_from_step", or_null(summary.periodic_from_step)},
                      {"state_hash", hex(summary.state_hash)},
                      {"output", run.output},
                      {"expect", list_of(run.expectations, expectation_json)},
                      {"golden", golden_json(run)},
                      {"exercised", list_json(coverage.exercised)},
                      {"never_touched", list_json(coverage.never_touched)},
                      {"not_computed", list_json(coverage.not_computed)}};
  if (run.start) add_members(object, {margin_table(*run.start)});
  if (!core.parameters.empty()) {
    Json::Object parameters;
    for (const auto& [name, value] : core.parameters) parameters.emplace_back(name, value);
    object.emplace_back("parameters", std::move(parameters));
  }
  if (summary.non_finite_step) object.emplace_back("non_finite_step", *summary.non_finite_step);
  return object;
}

}  // namespace hyrax
