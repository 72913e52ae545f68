#include "sim/scenario/numbers.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>

namespace hyrax {
namespace {

using Field = std::optional<NumberField>;
using Tokens = std::span<const std::string_view>;

constexpr double kNoLimit = std::numeric_limits<double>::max();
constexpr double kSeedMax = 0x1p64;  // The nearest double to the largest seed.

constexpr double real(std::int64_t value) { return static_cast<double>(value); }

std::vector<std::string_view> tokens_of(std::string_view pointer) {
  std::vector<std::string_view> tokens;
  while (!pointer.empty() && pointer.front() == '/') {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    tokens.push_back(pointer.substr(0, end));
    pointer.remove_prefix(end);
  }
  return tokens;
}

bool is(Tokens path, std::string_view key) { return path.size() == 1 && path.front() == key; }

Field in_window(Size& window, Tokens path) {
  if (is(path, "width_px")) return window_field(window.width_px);
  if (is(path, "height_px")) return window_field(window.height_px);
  return std::nullopt;
}
Field in_sprite(Size& sprite, Tokens path) {
  if (is(path, "width_px")) return sprite_field(sprite.width_px);
  if (is(path, "height_px")) return sprite_field(sprite.height_px);
  return std::nullopt;
}

Field in_start(Scenario& scenario, Tokens path) {
  if (is(path, "x_px")) return coordinate_field(scenario.start.x_px);
  if (is(path, "y_px")) return coordinate_field(scenario.start.y_px);
  if (is(path, "vx_px_per_s")) return speed_field(scenario.start_velocity.vx_px_per_s);
  if (is(path, "vy_px_per_s")) return speed_field(scenario.start_velocity.vy_px_per_s);
  return std::nullopt;
}

std::optional<std::size_t> index_in(std::string_view token, std::size_t size) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  if (error != std::errc() || end != token.data() + token.size() || index >= size) return std::nullopt;
  return index;
}

NumberField timing(NumberField field) {
  field.is_timing = true;
  return field;
}

NumberField rate_field(FixedRate& rate) { return timing({&rate.rate_hz, 1.0 / kFrameMax_s, kRateMax_hz}); }

NumberField amount_field(Jitter& jitter) {
  return timing({&jitter.amount, 0.0, jitter.kind == Jitter::Kind::normal ? kFrameMax_s : 1.0});
}
NumberField seed_field(Jitter& jitter) { return timing({&jitter.seed, 0.0, kSeedMax}); }

std::string_view amount_key(Jitter::Kind kind) {
  switch (kind) {
    case Jitter::Kind::uniform:
      return "fraction";
    case Jitter::Kind::normal:
      return "sigma_s";
    case Jitter::Kind::missed_frames:
      return "probability";
  }
  return "";
}

Field in_jitter(Jitter& jitter, Tokens path) {
  if (is(path, "seed")) return seed_field(jitter);
  if (is(path, amount_key(jitter.kind))) return amount_field(jitter);
  return std::nullopt;
}

Field in_clock(Clock& clock, Tokens path) {
  if (path.empty()) return std::nullopt;
  if (path.front() == "jitter" && clock.jitter) return in_jitter(*clock.jitter, path.subspan(1));
  if (auto* const rate = std::get_if<FixedRate>(&clock.base); rate != nullptr && is(path, "rate_hz"))
    return rate_field(*rate);
  if (auto* const step = std::get_if<FixedStep>(&clock.base); step != nullptr && is(path, "dt_s"))
    return frame_field(step->dt_s);
  auto* const trace = std::get_if<RecordedSteps>(&clock.base);
  if (trace == nullptr || path.size() != 2 || path.front() != "dt_s") return std::nullopt;
  const auto frame = index_in(path[1], trace->dt_s.size());
  if (!frame) return std::nullopt;
  return frame_field(trace->dt_s[*frame]);
}

// The part of a pointer that tokens are of.
std::string_view text_of(Tokens path) {
  if (path.empty()) return "";
  const char* const end = path.back().data() + path.back().size();
  return {path.front().data(), static_cast<std::size_t>(end - path.front().data())};
}

Field in_action(Action& action, Tokens path) {
  Field found;
  visit_numbers(action, [&](std::string_view name, const NumberField& field) {
    if (name == text_of(path)) found = field;
  });
  return found;
}

Field in_event(Event& event, Tokens path) {
  if (path.empty()) return std::nullopt;
  if (auto* const step = std::get_if<std::int64_t>(&event.when); step != nullptr && is(path, "step"))
    return timing({step, 0.0, real(kStepsMax)});
  if (auto* const at_s = std::get_if<double>(&event.when); at_s != nullptr && is(path, "at_s"))
    return timing({at_s, -kNoLimit, kNoLimit});
  if (path.front() != name_of(event.action)) return std::nullopt;
  return in_action(event.action, path.subspan(1));
}

Field in_events(std::vector<Event>& events, Tokens path) {
  if (path.empty()) return std::nullopt;
  const auto event = index_in(path.front(), events.size());
  return event ? in_event(events[*event], path.subspan(1)) : std::nullopt;
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
  const std::vector<std::string_view> tokens = tokens_of(pointer);
  if (tokens.empty()) return std::nullopt;
  const std::string_view first = tokens.front();
  const Tokens path = Tokens(tokens).subspan(1);
  if (first == "window") return in_window(scenario.window, path);
  if (first == "sprite") return in_sprite(scenario.sprite, path);
  if (first == "start") return in_start(scenario, path);
  if (first == "clock") return in_clock(scenario.clock, path);
  if (first == "events") return in_events(scenario.events, path);
  if (first == "record" && is(path, "every"))
    return NumberField{&scenario.record_every, 1.0, real(kStepsMax)};
  if (auto* const steps = std::get_if<std::int64_t>(&scenario.length);
      steps != nullptr && is(tokens, "steps"))
    return timing({steps, 0.0, real(kStepsMax)});
  if (auto* const duration_s = std::get_if<double>(&scenario.length);
      duration_s != nullptr && is(tokens, "duration_s"))
    return timing({duration_s, 0.0, kNoLimit});
  return std::nullopt;
}

std::vector<NumberField> numbers_of(Scenario& scenario) {
  std::vector<NumberField> numbers = {window_field(scenario.window.width_px),
                                      window_field(scenario.window.height_px),
                                      sprite_field(scenario.sprite.width_px),
                                      sprite_field(scenario.sprite.height_px),
                                      coordinate_field(scenario.start.x_px),
                                      coordinate_field(scenario.start.y_px),
                                      speed_field(scenario.start_velocity.vx_px_per_s),
                                      speed_field(scenario.start_velocity.vy_px_per_s)};
  Clock& clock = scenario.clock;
  if (auto* const rate = std::get_if<FixedRate>(&clock.base)) numbers.push_back(rate_field(*rate));
  if (auto* const step = std::get_if<FixedStep>(&clock.base)) numbers.push_back(frame_field(step->dt_s));
  if (auto* const trace = std::get_if<RecordedSteps>(&clock.base))
    for (double& dt_s : trace->dt_s) numbers.push_back(frame_field(dt_s));
  if (clock.jitter) {
    numbers.push_back(amount_field(*clock.jitter));
    numbers.push_back(seed_field(*clock.jitter));
  }
  for (Event& event : scenario.events)
    visit_numbers(event.action,
                  [&](std::string_view, const NumberField& field) { numbers.push_back(field); });
  return numbers;
}

}  // namespace hyrax
