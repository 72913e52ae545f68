#include "tools/hyrax-sim/run_report.h"

#include <fmt/format.h>

#include "tools/files/path.h"
#include "tools/hyrax-sim/difference_text.h"
#include "tools/hyrax-sim/shell_command.h"

namespace hyrax {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "nothing" : text;
}

Json counts_json(const WallCounts& counts) {
  Json::Object object;
  for (std::size_t wall = 0; wall < counts.size(); ++wall)
    object.emplace_back(kWallNames[wall], counts[wall]);
  return object;
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

std::string contacts_text(const WallCounts& counts) {
  std::vector<std::string> words;
  for (std::size_t wall = 0; wall < counts.size(); ++wall)
    if (counts[wall] > 0) words.push_back(fmt::format("{} {}", kWallNames[wall], counts[wall]));
  return words.empty() ? "none" : joined(words);
}

std::string clock_text(const Clock& clock) {
  std::string text;
  if (const auto* rate = std::get_if<FixedRate>(&clock.base)) text = fmt::format("at {} Hz", rate->rate_hz);
  if (const auto* step = std::get_if<FixedStep>(&clock.base)) text = fmt::format("at dt {} s", step->dt_s);
  if (std::holds_alternative<RecordedSteps>(clock.base)) text = "at recorded dt";
  return clock.jitter ? text + ", jittered" : text;
}

std::string rest_text(const RunSummary& summary) {
  return summary.at_rest_since_s ? fmt::format("  settled        since {:.6g} s\n", *summary.at_rest_since_s)
                                 : std::string("  not settled    moved within the last 1 s\n");
}

std::string expectations_text(const ScenarioRun& run) {
  std::size_t holding = 0;
  std::string broken;
  for (const Expectation& expectation : run.expectations) {
    holding += expectation.holds ? 1 : 0;
    if (!expectation.holds) broken += "    does not hold: " + expectation_text(expectation) + "\n";
  }
  return fmt::format("  expect         {} of {} hold\n", holding, run.expectations.size()) + broken;
}

// Only a trajectory file can be compared.
std::string diff_command_for(const ScenarioRun& run) {
  const auto diff = [&](const std::string& output) {
    return shell_command({"hyrax-sim", "diff", as_argument(run.golden_path), as_argument(output)});
  };
  if (file_name(run.output).extension != ".csv") return diff(run.output);
  return shell_command({"hyrax-sim", "run", as_argument(run.path), "-o", "now.h5"}) + "; " + diff("now.h5");
}

std::string golden_text(const ScenarioRun& run) {
  if (run.golden_path.empty()) return "";
  if (!run.comparison)
    return fmt::format("  golden         none at {}; to make one: {}\n", run.golden_path,
                       bless_command_for(run.path, run.golden_folder));
  if (run.comparison->agrees)
    return fmt::format("  golden         agrees bit for bit with {}\n", run.golden_path);
  return fmt::format("  golden         DIFFERS from {}\n", run.golden_path) +
         difference_text(*run.comparison) + fmt::format("  more           {}\n", diff_command_for(run));
}

Json golden_json(const ScenarioRun& run) {
  if (run.golden_path.empty()) return nullptr;
  const char* const status = !run.comparison ? "missing" : run.comparison->agrees ? "agreed" : "disagreed";
  Json::Object object{{"file", run.golden_path}, {"status", status}};
  if (run.comparison && run.comparison->difference) {
    object.emplace_back("class", name_of(*run.comparison->difference));
    object.emplace_back("first_divergence", divergence_json(run.comparison->first));
  }
  return object;
}

Json words_json(const std::vector<std::string>& words) { return Json::Array(words.begin(), words.end()); }

}  // namespace

Coverage coverage_of(const ScenarioRun& run) {
  const RunSummary& summary = run.summary;
  Coverage coverage;
  const auto part = [&](bool is_exercised, const char* name) {
    (is_exercised ? coverage.exercised : coverage.never_touched).emplace_back(name);
  };
  part(summary.had_gravity, "gravity");
  part(summary.had_drag, "drag");
  part(summary.clamped_steps[0] > 0, "left wall");
  part(summary.clamped_steps[1] > 0, "right wall");
  part(summary.clamped_steps[2] > 0, "top");
  part(summary.clamped_steps[3] > 0, "ground");
  part(summary.had_friction, "friction");
  part(summary.rest_steps > 0, "rest rule");
  const std::int64_t skipped = summary.steps - summary.steps_computed;
  if (skipped > 0 && summary.periodic_from_step)
    coverage.not_computed.push_back(
        fmt::format("{} of {} steps (the state repeats every {} from row {})", skipped, summary.steps,
                    summary.period_steps == 1 ? "step" : fmt::format("{} steps", summary.period_steps),
                    *summary.periodic_from_step));
  else if (skipped > 0)
    coverage.not_computed.push_back(
        fmt::format("{} of {} steps (the state repeats between inputs)", skipped, summary.steps));
  if (run.rows_recorded < summary.steps + 1)
    coverage.not_computed.push_back(
        fmt::format("{} of {} rows not stored", summary.steps + 1 - run.rows_recorded, summary.steps + 1));
  if (!run.drift) coverage.not_computed.emplace_back("reference and energy (hyrax-sim drift)");
  if (!run.not_compared.empty())
    coverage.not_computed.push_back(fmt::format("comparison with a golden file ({})", run.not_compared));
  return coverage;
}

std::string run_text(const ScenarioRun& run) {
  const RunSummary& summary = run.summary;
  const Coverage coverage = coverage_of(run);
  std::string text = fmt::format("{}: {} steps, {:.6g} s {}\n", run.scenario.name, summary.steps,
                                 summary.simulated_s, clock_text(run.scenario.clock));
  if (summary.non_finite_step)
    text += fmt::format("  NOT FINITE     from step {}; the run ended there\n", *summary.non_finite_step);
  text += fmt::format("  contacts       {}\n", contacts_text(summary.contacts));
  text += fmt::format("  end            x {:.6g} px, y {:.6g} px, vx {:.6g} px/s, vy {:.6g} px/s\n",
                      summary.final.x_px, summary.final.y_px, summary.final.vx_px_per_s,
                      summary.final.vy_px_per_s);
  text += rest_text(summary);
  text +=
      fmt::format("  exercised      {}\n  never touched  {}\n  not computed   {}\n",
                  joined(coverage.exercised), joined(coverage.never_touched), joined(coverage.not_computed));
  if (!run.expectations.empty()) text += expectations_text(run);
  text += golden_text(run);
  text += fmt::format("  state hash     {}\n", hex(summary.state_hash));
  return text + fmt::format("  written        {} ({} rows)\n", run.output, run.rows_recorded);
}

Json run_json(const ScenarioRun& run) {
  const RunSummary& summary = run.summary;
  const Coverage coverage = coverage_of(run);
  Json clamped = counts_json(summary.clamped_steps);
  clamped.get<Json::Object>()->emplace_back("rest", summary.rest_steps);
  Json::Array expectations;
  for (const Expectation& expectation : run.expectations)
    expectations.push_back(expectation_json(expectation));
  const bool is_good = run.is_as_expected();
  Json::Object object{{"scenario", run.path},
                      {"status", is_good ? "agreed" : "disagreed"},
                      {"steps", summary.steps},
                      {"simulated_s", summary.simulated_s},
                      {"contacts", counts_json(summary.contacts)},
                      {"clamped_steps", clamped},
                      {"final", Json::Object{{"x_px", summary.final.x_px},
                                             {"y_px", summary.final.y_px},
                                             {"vx_px_per_s", summary.final.vx_px_per_s},
                                             {"vy_px_per_s", summary.final.vy_px_per_s}}},
                      {"at_rest_since_s", or_null(summary.at_rest_since_s)},
                      {"periodic_from_step", or_null(summary.periodic_from_step)},
                      {"state_hash", hex(summary.state_hash)},
                      {"output", run.output},
                      {"expect", std::move(expectations)},
                      {"golden", golden_json(run)},
                      {"exercised", words_json(coverage.exercised)},
                      {"never_touched", words_json(coverage.never_touched)},
                      {"not_computed", words_json(coverage.not_computed)}};
  if (summary.non_finite_step) object.emplace_back("non_finite_step", *summary.non_finite_step);
  return object;
}

Json expectation_json(const Expectation& expectation) {
  const Json measured = std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
          return nullptr;
        else
          return value;
      },
      expectation.measured);
  return Json::Object{{"rule", expectation.rule}, {"holds", expectation.holds}, {"measured", measured}};
}

std::string expectation_text(const Expectation& expectation) {
  const Json measured = *expectation_json(expectation).find("measured");
  return expectation.rule + ": wanted " + expectation.wanted + ", measured " +
         (measured.is_null() ? "none" : to_text(measured));
}

}  // namespace hyrax
