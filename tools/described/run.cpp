#include <fmt/format.h>

#include <algorithm>

#include "sim/described/described_figure.h"
#include "sim/result/number_text.h"
#include "tools/app/command_line/shell_command.h"
#include "tools/app/expect/judged_run.h"
#include "tools/app/library/run_flow.h"
#include "tools/described/commands.h"
#include "tools/described/judged_run.h"
#include "tools/described/run_text.h"
#include "tools/described/scenario_json.h"
#include "tools/described/trajectory_file.h"
#include "tools/files/printable.h"
#include "tools/platform/atomic_file.h"
#include "tools/platform/path.h"
#include "tools/report/figure_svg.h"
#include "tools/report/result_page.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {
namespace {

constexpr std::size_t kValuesPrinted = 12;

// ERRORS: Failure(disagreed) for a run without rows.
void require_rows(const DescribedRun& run) {
  const std::optional<EarlyEnd>& end = run.contents.summary.early_end;
  if (end && end->step == 0 && !end->is_non_finite)
    throw Failure(ExitCode::disagreed, run.path + ": row 0: " + end->what + "; nothing written");
}

// Plays into the file, and judges. `steps` is less than the scenario's if a first try found that the run ends
// there.
DescribedRun play_into(const DescribedCore& core, const RunRequest& request, const std::string& path,
                       const DescribedScenario& scenario, const std::string& output, std::int64_t steps,
                       std::optional<DescribedPicture>& picture) {
  DescribedRun run;
  run.path = path;
  run.scenario = scenario;
  JudgeOptions options{.golden_folder = request.golden_folder, .compares = request.overrides.empty()};
  if (!request.figure.empty() || !request.page.empty())
    options.also = {&picture.emplace(core.description, scenario)};
  if (output == kStandardOutput || file_name(output).extension == ".csv") {
    DescribedCsv csv(output, core.description, steps, scenario.record_every);
    options.also.push_back(&csv);
    judge_run(core, run, options);
    require_rows(run);
    if (run.contents.summary.steps != steps && output != kStandardOutput)
      return play_into(core, request, path, scenario, output, run.contents.summary.steps, picture);
    csv.finish();
    return run;
  }
  AtomicFile target(output);
  DescribedWriter writer(target.part_path(), output, core.description, steps, scenario.record_every);
  options.also.push_back(&writer);
  judge_run(core, run, options);
  require_rows(run);
  if (run.contents.summary.steps != steps)
    return play_into(core, request, path, scenario, output, run.contents.summary.steps, picture);
  writer.finish({{.steps = steps,
                  .physics = std::string(kDescribedModel),
                  .state_hash = run.contents.state_hash(),
                  .core = core.record.checksum()},
                 core.description,
                 scenario},
                run.contents.contacts_total());
  target.commit();
  return run;
}

const char* status_of(const DescribedRun& run) {
  if (!run.holds()) return "disagreed";
  const bool is_missing = run.not_compared.empty() && !run.has_golden;
  return run.comparison || (!run.expectations.empty() && !is_missing) ? "agreed" : "played";
}

// What of the description the run exercised, and what it did not.
struct Coverage {
  std::vector<std::string> exercised;
  std::vector<std::string> never;
};
Coverage coverage_of(const Description& description, const DescribedSummary& summary) {
  Coverage coverage;
  const auto add = [&](bool is_exercised, const std::string& name) {
    (is_exercised ? coverage.exercised : coverage.never).push_back(name);
  };
  for (std::size_t index = 0; index < description.contacts.size(); ++index)
    add(summary.contacts[index] > 0, description.contacts[index]);
  for (std::size_t index = 0; index < description.actions.size(); ++index)
    add(summary.actions_done[index] != 0, description.actions[index].name);
  for (std::size_t index = 0; index < description.inputs.values.size(); ++index)
    add(summary.inputs_set[index] != 0, description.inputs.values[index].name);
  for (std::size_t index = 0; index < description.properties.size(); ++index)
    if (!description.properties[index].is_always)
      add(summary.properties[index].holds, description.properties[index].name);
  return coverage;
}

void print_properties(const Description& description, const DescribedSummary& summary) {
  for (std::size_t index = 0; index < description.properties.size(); ++index) {
    const PropertyInfo& property = description.properties[index];
    const PropertyOutcome& outcome = summary.properties[index];
    const std::string where =
        outcome.step ? fmt::format("step {} ({:.6g} s)", *outcome.step, outcome.t_s) : "";
    if (property.is_always)
      print_text("  always         {}: {}{}\n", printable(property.name),
                 VerdictWord{outcome.holds ? "holds" : "DOES NOT HOLD", outcome.holds},
                 outcome.holds ? "" : " at " + where);
    else
      print_text("  sometimes      {}: {}\n", printable(property.name),
                 outcome.holds ? "shown at " + where : "not shown");
  }
}

void print_run(const DescribedCore& core, const RunRequest& request, const std::string& output,
               const DescribedRun& run) {
  const Description& description = core.description;
  const DescribedSummary& summary = run.contents.summary;
  const DescribedScenario& scenario = run.scenario;
  if (output == kStandardOutput) return print_error(scenario.name + ": " + status_of(run));
  if (request.printing.is_quiet()) {
    const std::string sentence = run.holds() ? "" : ": " + run.sentence();
    print_text("{}: {}{}; written: {}\n", scenario.name, VerdictWord{status_of(run), run.holds()}, sentence,
               output);
    return;
  }
  for (const std::string& fault : run.faults)
    print_text("{}: {}\n", VerdictWord{"DOES NOT HOLD", false}, printable(fault));
  print_text("{}{}: {}, {:.6g} s\n", scenario.name,
             scenario.description ? " (" + printable(*scenario.description) + ")" : "",
             plain_counted(summary.steps, "step"), summary.simulated_s);
  for (const auto& [value, word] : scenario.parameters) {
    const ValueInfo& parameter = description.parameters.values[value];
    if (word != parameter.initial)
      print_text("  with           {} {}, not the core's own {}\n", parameter.name,
                 value_text(parameter, word), value_text(parameter, parameter.initial));
  }
  print_text("  contacts       {}\n  end            {}\n", contacts_text(description, summary),
             state_text(description, summary.final,
                        request.printing.is_verbose() ? summary.final.size() : kValuesPrinted));
  if (summary.at_rest_since_s)
    print_text("  settled        since {:.6g} s\n", *summary.at_rest_since_s);
  else
    print_text("  not settled    {}\n", why_not_settled(description, summary));
  print_properties(description, summary);
  const Coverage coverage = coverage_of(description, summary);
  print_text("  exercised      {}\n  never          {}\n", joined_names(coverage.exercised),
             joined_names(coverage.never));
  if (!run.not_compared.empty()) print_text("  not compared   {}\n", run.not_compared);
  print_expectations(run.expectations, request.printing.is_verbose());
  if (run.comparison && run.comparison->agrees())
    print_text("  golden         {} bit for bit with {}\n", VerdictWord{"agrees", true}, run.golden->h5_path);
  else if (run.comparison)
    print_text("  golden         {} from {}\n{}", VerdictWord{"DIFFERS", false}, run.golden->h5_path,
               run.differences_text(false));
  else if (run.not_compared.empty())
    print_text("  golden         missing: {}{}\n", run.golden->h5_path,
               run.holds() ? "; to create it: " + bless_command_for({run.path}, request.golden_folder) : "");
  print_text("  state hash     {}\n  written        {} ({})\n", run.contents.state_hash(), output,
             plain_counted(TrajectoryWriter::row_count(summary.steps, scenario.record_every), "row"));
}

Json run_json(const DescribedCore& core, const std::string& output, const DescribedRun& run) {
  const Description& description = core.description;
  const DescribedSummary& summary = run.contents.summary;
  Json::Object contacts, final;
  Json::Array properties;
  for (std::size_t index = 0; index < description.contacts.size(); ++index)
    contacts.emplace_back(description.contacts[index], summary.contacts[index]);
  for (std::size_t index = 0; index < summary.final.size(); ++index)
    final.emplace_back(description.state.values[index].name,
                       value_json(description.state.values[index], summary.final[index]));
  for (std::size_t index = 0; index < description.properties.size(); ++index)
    properties.push_back(
        Json::Object{{"name", description.properties[index].name},
                     {"kind", description.properties[index].is_always ? "always" : "sometimes"},
                     {"holds", summary.properties[index].holds},
                     {"step", or_null(summary.properties[index].step)}});
  Json golden;
  if (run.not_compared.empty()) {
    const char* const status = !run.comparison            ? "missing"
                               : run.comparison->agrees() ? "agreed"
                                                          : "disagreed";
    Json::Object object{{"file", run.golden->h5_path}, {"status", status}};
    if (run.comparison && !run.comparison->agrees())
      std::ranges::move(comparison_json(*run.comparison), std::back_inserter(object));
    golden = std::move(object);
  }
  const Coverage coverage = coverage_of(description, summary);
  const auto list = [](const std::vector<std::string>& names) {
    return Json::Array(names.begin(), names.end());
  };
  Json::Object object{{"scenario", run.path},
                      {"status", status_of(run)},
                      {"steps", summary.steps},
                      {"simulated_s", summary.simulated_s},
                      {"contacts", std::move(contacts)},
                      {"final", std::move(final)},
                      {"at_rest_since_s", or_null(summary.at_rest_since_s)},
                      {"periodic_from_step", Json()},
                      {"state_hash", run.contents.state_hash()},
                      {"output", output},
                      {"expect", list_of(run.expectations, expectation_json)},
                      {"golden", std::move(golden)},
                      {"properties", std::move(properties)},
                      {"faults", list(run.faults)},
                      {"exercised", list(coverage.exercised)},
                      {"never_touched", list(coverage.never)}};
  if (summary.early_end && summary.early_end->is_non_finite)
    object.emplace_back("non_finite_step", summary.early_end->step);
  return object;
}

// "agreed: 600 steps, 10 s; rail 4; ends at ...".
ShownResult shown(const DescribedCore& core, const DescribedRun& run, const DescribedPicture& picture,
                  const DescribedPicture* golden) {
  const DescribedSummary& summary = run.contents.summary;
  const std::string found = fmt::format("{}: {}, {:.6g} s", status_of(run),
                                        plain_counted(summary.steps, "step"), summary.simulated_s);
  ShownResult shown = shown_run(
      core.description, run.scenario, summary, picture, golden, found,
      {{"core", core.description.core}, {"file", run.path}, {"state hash", run.contents.state_hash()}});
  shown.verdict.broken = run.faults;
  if (run.differs())
    shown.verdict.broken.push_back("differs from " + run.golden->h5_path + ": " +
                                   (run.golden_fault.empty() ? run.consequence() : run.golden_fault));
  for (const Expectation& expectation : run.broken)
    shown.verdict.broken.push_back(expectation_text(expectation));
  return shown;
}

void draw(const RunRequest& request, const std::string& output, const std::string& path,
          const ShownResult& shown) {
  if (!request.figure.empty()) {
    draw_figure(request.figure, shown.figures.front());
    if (output != kStandardOutput) print_written(request, request.figure);
  }
  if (request.page.empty()) return;
  write_result_page(request.page, page_command(request, {path}), {shown});
  print_written(request, request.page);
}

RunPanel run_one(const DescribedCore& core, const RunRequest& request, const std::string& path,
                 const DescribedScenario& scenario, const std::string& output, CommandResults& results,
                 std::vector<ShownResult>& runs) {
  std::optional<DescribedPicture> picture;
  const DescribedRun run = play_into(core, request, path, scenario, output, step_count(scenario), picture);
  if (!run.holds()) results.add(ExitCode::disagreed);
  if (request.printing.is_json)
    results.add(run_json(core, output, run));
  else
    print_run(core, request, output, run);
  if (!picture) return {};
  const std::unique_ptr<FileRun> golden = differing_golden(core, run);
  ShownResult result = shown(core, run, *picture, picture_of(golden));
  if (!request.shows_sheet) {
    draw(request, output, path, result);
    return {};
  }
  runs.push_back(std::move(result));
  return {.name = scenario.name,
          .status = status_of(run),
          .picture = panel_picture(*picture, picture_of(golden)),
          .link = fmt::format("#result-{}", runs.size())};
}

ExitCode run(const DescribedCore& core, RunRequest& request) {
  std::vector<ShownResult> runs;
  return run_scenarios(
      request,
      [&](const std::string& path, const std::vector<Override>& overrides) {
        const DescribedScenario scenario = load_described_scenario(core.description, path, overrides);
        return LoadedScenario{scenario.name, [&, path, scenario](const std::string& output, auto& results) {
                                return run_one(core, request, path, scenario, output, results, runs);
                              }};
      },
      {.write_page = [&](const std::vector<RunPanel>& panels) {
        write_run_pages(request.page, page_command(request, request.files), panels, runs);
      }});
}

void declare(Options& options, RunRequest& request) {
  declare_run(options, request, "draw the paths and values; of several scenarios a sheet",
              "write them as a page, with the rows; several with a sheet of them");
  options.printing(request.printing, "print every value of the state, and expectations that hold");
}

}  // namespace

Command described_run_command(const DescribedCore& core) {
  return {.name = "run",
          .summary = "play scenarios, write their trajectories and compare them with golden files",
          .example = "hyrax-sim run scenarios/first.json --set /clock/rate_hz=144 -o first.csv",
          .is_common = true,
          .declare =
              with_request<RunRequest>(declare, [&core](RunRequest& request) { return run(core, request); })};
}

}  // namespace hyrax
