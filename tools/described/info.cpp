
#include "sim/described/described_run.h"
#include "sim/described/described_step.h"
#include "tools/described/commands.h"
#include "tools/described/core_verdict.h"
#include "tools/described/value_json.h"
#include "tools/files/printable.h"
#include "tools/store/build_facts.h"

namespace hyrax {
namespace {

constexpr std::int64_t kPlayedFrames = 600;

std::string with_unit(const ValueInfo& value) {
  return value.unit.empty() ? value.name : fmt::format("{} ({})", value.name, value.unit);
}

std::string with_arguments(const ActionInfo& action) {
  std::string text;
  for (const ValueInfo& argument : action.arguments) text += (text.empty() ? "" : ", ") + argument.name;
  return fmt::format("{}({})", action.name, text);
}

// "A, B"; "none" of an empty list.
std::string joined(const auto& items, const auto& text_of) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + text_of(item);
  return text.empty() ? "none" : text;
}

std::vector<std::pair<std::string, std::string>> lists_of(const Description& description) {
  const auto same = [](const std::string& name) { return name; };
  return {{"state", joined(description.state.values, with_unit)},
          {"inputs", joined(description.inputs.values, with_unit)},
          {"parameters", joined(description.parameters.values, with_unit)},
          {"outputs", joined(description.outputs.values, with_unit)},
          {"actions", joined(description.actions, with_arguments)},
          {"contacts", joined(description.contacts, same)},
          {"properties", joined(description.properties,
                                [](const PropertyInfo& property) {
                                  return fmt::format("{} \"{}\"", property.is_always ? "always" : "sometimes",
                                                     property.name);
                                })},
          {"undeclared", joined(description.undeclared, same)}};
}

DescribedScenario default_scenario() {
  DescribedScenario scenario;
  scenario.name = "info";
  scenario.clock.base = FixedRate{60.0};
  scenario.length = kPlayedFrames;
  return scenario;
}

// What the check of the description found.
std::string check_finding(const DescribedCore& core) {
  const DescribedScenario scenario = default_scenario();
  if (const auto early = play(core, scenario, {}).early_end)
    return fmt::format("ends at row {}: {}", early->step, early->what);
  if (const auto fault = description_fault(core, scenario)) return *fault;
  if (core.description.undeclared.empty()) return "complete, as far as they show";
  return "repeats; whether the state is complete is not checked, for part of it is undeclared";
}

// Whether distances can be measured.
std::string distance_fact(const Description& description) {
  if (!has_px(description))
    return "nothing in px: no distance, path or rest; names of places end in _px, as x_px and y_px";
  const std::vector<PositionPair> pairs = position_pairs(description);
  return joined(pairs, [&](const PositionPair& pair) {
    return fmt::format("{} with {}", description.state.values[pair.x].name,
                       description.state.values[pair.y].name);
  });
}

// As that of a core of the paper's interface.
std::string step_fact(const DescribedCore& core) {
  const DescribedStep traced = described_step(core);
  return traced.step ? fmt::format("complete, {} paths", traced.step->paths.front().size())
                     : "not complete: " + traced.why_incomplete;
}

ExitCode described_info(const DescribedCore& core, const Printing& printing) {
  Json::Object all = build_facts();
  all.emplace_back("core", core.description.core);
  all.emplace_back("physics", kDescribedModel);
  all.emplace_back("step", step_fact(core));
  all.emplace_back("beyond_library", kNotDescribedYet);
  all.emplace_back("unnoticed", kNotDescribedYet);
  for (auto& fact : library_facts()) all.push_back(std::move(fact));
  const std::string check = check_finding(core);
  const std::string positions = distance_fact(core.description);
  if (printing.is_json) {
    all.emplace_back("check", check);
    all.emplace_back("positions", positions);
    all.emplace_back("undeclared",
                     Json::Array(core.description.undeclared.begin(), core.description.undeclared.end()));
    all.emplace_back("description", description_json(core.description));
    print_json(all, 3);
    return ExitCode::agreed;
  }
  for (const auto& [name, value] : all)
    if (!printing.is_quiet() || name == "self_test")
      print_text("{:<16} {}\n", name, *value.get<std::string>());
  if (printing.is_quiet()) return ExitCode::agreed;
  for (const auto& [name, text] : lists_of(core.description)) print_text("{}: {}\n", name, printable(text));
  print_text("positions: {}\n", positions);
  print_text("check of {} frames at 60 Hz: {}\n", kPlayedFrames, printable(check));
  return ExitCode::agreed;
}

}  // namespace

Command described_info_command(const DescribedCore& core) {
  return {.name = "info",
          .summary = "print what the core is made of, whether its state is complete, and the build",
          .example = "hyrax-sim info",
          .needs_strict_ieee = false,
          .declare = with_request<Printing>(
              [](Options& options, Printing& printing) { options.printing(printing); },
              [&core](const Printing& printing) { return described_info(core, printing); })};
}

}  // namespace hyrax
