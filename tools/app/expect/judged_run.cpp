#include "tools/app/expect/judged_run.h"

#include <cmath>

#include "sim/reference/drift_meter.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

std::optional<double> value_of(const std::optional<Worst>& worst) {
  return worst ? std::optional(worst->value) : std::nullopt;
}

}  // namespace

ReplayOptions judged_options(const Scenario& scenario) {
  return {.checks_bounds = scenario.expect && scenario.expect->in_bounds};
}

RunSummary play(const Core& core, const Scenario& scenario) {
  return replay(core, scenario, {}, judged_options(scenario));
}

std::vector<Expectation> judge_run(const Core& core, const Scenario& scenario, const RunSummary& summary,
                                   std::optional<DriftSummary> measured) {
  if (!scenario.expect) return {};
  if (!bounds_errors(*scenario.expect)) return judge(*scenario.expect, summary);
  if (!measured) {
    DriftSink ignored;
    DriftMeter meter(scenario, inputs_of(scenario, summary.steps), ignored, nullptr,
                     reference_model(core.name, core.constants, core.parameters));
    replay(core, scenario, meter);
    measured = meter.finish();
  }
  return judge(*scenario.expect, summary,
               RunErrors{value_of(measured->implementation_px), value_of(measured->truncation_px),
                         value_of(measured->energy_drift_rel_max)});
}

std::vector<Expectation> broken_expectations(const Core& core, const Scenario& scenario,
                                             const RunSummary& summary) {
  std::vector<Expectation> broken;
  for (Expectation& expectation : judge_run(core, scenario, summary))
    if (!expectation.holds) broken.push_back(std::move(expectation));
  return broken;
}

bool is_updatable_range(const Expectation& broken) {
  return broken.range && std::isfinite(broken.range->low) && std::holds_alternative<double>(broken.measured);
}

bool is_updatable(const Expectation& broken) {
  return broken.rule == "state_hash" || is_updatable_range(broken);
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
  std::string text = measured.is_null() ? "none" : to_text(measured);
  std::erase(text, '"');  // Of a hash, or "NaN".
  return expectation.rule + ": wanted " + expectation.wanted + ", measured " + text;
}

std::string broken_sentence(const std::vector<Expectation>& broken) {
  std::string text;
  for (const Expectation& expectation : broken)
    text += (text.empty() ? "expect " : "; ") + expectation_text(expectation);
  return text;
}

}  // namespace hyrax
