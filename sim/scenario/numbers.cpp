#include "sim/scenario/numbers.h"

#include <charconv>
#include <limits>
#include <string>

namespace hyrax {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::max();
constexpr double kSeedMax = 0x1p64;  // The nearest double to the largest seed.
constexpr double kFramesMax = static_cast<double>(kStepsMax);

NumberField timing(NumberField field) {
  field.is_timing = true;
  return field;
}

// Calls visit(pointer, field) for the sizes, the start and the clock, but not for the frames of a trace.
void visit_world(Scenario& scenario, const auto& visit) {
  visit("/window/width_px", window_field(scenario.window.width_px));
  visit("/window/height_px", window_field(scenario.window.height_px));
  visit("/sprite/width_px", sprite_field(scenario.sprite.width_px));
  visit("/sprite/height_px", sprite_field(scenario.sprite.height_px));
  visit_start(scenario.start, scenario.start_velocity,
              [&](const char* key, const NumberField& field) { visit(std::string("/start/") + key, field); });
  if (auto* const rate = std::get_if<FixedRate>(&scenario.clock.base))
    visit("/clock/rate_hz", timing({&rate->rate_hz, 1.0 / kFrameMax_s, kRateMax_hz}));
  if (auto* const step = std::get_if<FixedStep>(&scenario.clock.base))
    visit("/clock/dt_s", frame_field(step->dt_s));
  if (!scenario.clock.jitter) return;
  Jitter& jitter = *scenario.clock.jitter;
  const JitterKeys& keys = kJitterKeys.at(static_cast<std::size_t>(jitter.kind));
  visit(std::string("/clock/jitter/").append(keys.amount), timing({&jitter.amount, 0.0, keys.amount_max}));
  visit("/clock/jitter/seed", timing({&jitter.seed, 0.0, kSeedMax}));
}

// Takes the prefix and an index below `size` off the pointer; nothing, and no change, if it has none.
std::optional<std::size_t> take_index(std::string_view& pointer, std::string_view prefix, std::size_t size) {
  if (!pointer.starts_with(prefix)) return std::nullopt;
  const std::string_view rest = pointer.substr(prefix.size());
  const std::string_view token = rest.substr(0, rest.find('/'));
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  if (error != std::errc() || end != token.data() + token.size() || index >= size) return std::nullopt;
  pointer = rest.substr(token.size());
  return index;
}

}  // namespace

ScenarioNumberKind number_kind(std::string_view pointer) {
  const std::string_view key = pointer.substr(pointer.rfind('/') + 1);
  if (key == "seed") return ScenarioNumberKind::seed;
  for (const std::string_view integer : {"width_px", "height_px", "step", "steps", "every"})
    if (key == integer) return ScenarioNumberKind::integer;
  return ScenarioNumberKind::real;
}

std::optional<NumberField> number_at(Scenario& scenario, std::string_view pointer) {
  std::optional<NumberField> found;
  const auto find = [&](std::string_view path, const NumberField& field) {
    if (path == pointer) found = field;
  };
  visit_world(scenario, find);
  find("/record/every", {&scenario.record_every, 1.0, kFramesMax});
  auto* const trace = std::get_if<RecordedSteps>(&scenario.clock.base);
  const double frames = trace == nullptr ? 0.0 : static_cast<double>(trace->dt_s.size());
  if (auto* const steps = std::get_if<std::int64_t>(&scenario.length))
    find("/steps", timing({steps, frames, trace == nullptr ? kFramesMax : frames}));
  if (auto* const duration_s = std::get_if<double>(&scenario.length))
    find("/duration_s", timing({duration_s, 0.0, kNoLimit}));
  if (trace != nullptr)
    if (const auto frame = take_index(pointer, "/clock/dt_s/", trace->dt_s.size())) {
      find("", frame_field(trace->dt_s[*frame]));
      return found;
    }
  for (auto& [name, value] : scenario.parameters) find("/parameters/" + name, parameter_field(value));
  const auto index = take_index(pointer, "/events/", scenario.events.size());
  if (!index) return found;
  Event& event = scenario.events[*index];
  if (auto* const step = std::get_if<std::int64_t>(&event.when))
    find("/step", timing({step, 0.0, kFramesMax}));
  if (auto* const at_s = std::get_if<double>(&event.when)) find("/at_s", timing({at_s, -kNoLimit, kNoLimit}));
  const std::string action = std::string("/").append(name_of(event.action)) + "/";
  visit_numbers(event.action,
                [&](const char* name, const NumberField& field) { find(action + name, field); });
  return found;
}

std::vector<NumberField> numbers_of(Scenario& scenario) {
  std::vector<NumberField> numbers;
  const auto add = [&](std::string_view, const NumberField& field) { numbers.push_back(field); };
  visit_world(scenario, add);
  if (auto* const trace = std::get_if<RecordedSteps>(&scenario.clock.base))
    for (double& dt_s : trace->dt_s) numbers.push_back(frame_field(dt_s));
  for (Event& event : scenario.events) visit_numbers(event.action, add);
  for (Parameter& parameter : scenario.parameters) numbers.push_back(parameter_field(parameter.value));
  return numbers;
}

}  // namespace hyrax
