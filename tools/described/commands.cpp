#include "tools/described/commands.h"

#include <cmath>

#include "sim/scenario/frame_clock.h"
#include "tools/app/clock/new_scenario.h"
#include "tools/app/command_line/scenario_commands.h"
#include "tools/described/scenario_json.h"
#include "tools/files/scenario_head.h"

namespace hyrax {
namespace {

// What a list has by default, as the member of a scenario, which holds no infinity.
void add_defaults(std::string_view key, const ValueList& list, Json::Object& document) {
  Json::Object defaults;
  for (const ValueInfo& value : list.values)
    if (std::isfinite(number_of(value.type, value.initial)))
      defaults.emplace_back(value.name, value_json(value, value.initial));
  if (!defaults.empty()) document.emplace_back(key, std::move(defaults));
}

// Without parameters: a default of theirs that changes shows in what is played.
Json new_document(const Description& description) {
  Json::Object document{{"$schema", "scenario.schema.json"},
                        {"format", kScenarioFormat},
                        {"name", ""},
                        {"description", "What happens, and why it is worth testing."},
                        {"core", description.core}};
  add_defaults("inputs", description.inputs, document);
  add_defaults("start", description.state, document);
  document.emplace_back("clock", Json::Object{{"rate_hz", 60}});
  document.emplace_back("steps", 600);
  document.emplace_back("record", Json::Object{{"every", 1}});
  document.emplace_back("expect", Json::Object{{"finite", true}});
  return document;
}

}  // namespace

Command described_new_command(const DescribedCore& core) {
  const auto write = [&core](const NewRequest& request) {
    return write_new(request, new_document(core.description),
                     [&core](const Json& document, const std::string& path) {
                       static_cast<void>(to_described_scenario(core.description, document, path, ""));
                     });
  };
  return {.name = "new",
          .summary = "write a scenario file to start from, with its inputs and state",
          .example = "hyrax-sim new my-scenario",
          .needs_strict_ieee = false,
          .declare = with_request<NewRequest>(
              [](Options& options, NewRequest& request) { declare_new(options, request); }, write)};
}

Command described_validate_command(const DescribedCore& core) {
  return validate_command_of([&core](const Core& /*paper*/, const std::string& path) {
    const DescribedScenario scenario = load_described_scenario(core.description, path);
    return GoodScenario{scenario.name, step_count(scenario), scenario.events.size()};
  });
}

Command described_schema_command(const DescribedCore& core) {
  return schema_command_of([&core] { return to_text(schema_json(core.description), 3) + "\n"; });
}

}  // namespace hyrax
