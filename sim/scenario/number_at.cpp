#include "sim/scenario/number_at.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>
#include <string>
#include <vector>

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

Field in_size(Size& size, Tokens path, std::int64_t low_px, std::int64_t high_px) {
  if (is(path, "width_px")) return NumberField{&size.width_px, real(low_px), real(high_px)};
  if (is(path, "height_px")) return NumberField{&size.height_px, real(low_px), real(high_px)};
  return std::nullopt;
}
Field in_window(Size& window, Tokens path) { return in_size(window, path, 0, kWindowSideMax_px); }
Field in_sprite(Size& sprite, Tokens path) {
  return in_size(sprite, path, kSpriteSideMin_px, kSpriteSideMax_px);
}

Field in_position(Position& position, Tokens path) {
  if (is(path, "x_px")) return NumberField{&position.x_px, -kCoordinateMax_px, kCoordinateMax_px};
  if (is(path, "y_px")) return NumberField{&position.y_px, -kCoordinateMax_px, kCoordinateMax_px};
  return std::nullopt;
}

Field in_velocity(Velocity& velocity, Tokens path) {
  if (is(path, "vx_px_per_s"))
    return NumberField{&velocity.vx_px_per_s, -kSpeedMax_px_per_s, kSpeedMax_px_per_s};
  if (is(path, "vy_px_per_s"))
    return NumberField{&velocity.vy_px_per_s, -kSpeedMax_px_per_s, kSpeedMax_px_per_s};
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

Field in_jitter(Jitter& jitter, Tokens path) {
  if (is(path, "seed")) return timing({&jitter.seed, 0.0, kSeedMax});
  switch (jitter.kind) {
    case Jitter::Kind::uniform:
      if (is(path, "fraction")) return timing({&jitter.amount, 0.0, 1.0});
      break;
    case Jitter::Kind::normal:
      if (is(path, "sigma_s")) return timing({&jitter.amount, 0.0, kFrameMax_s});
      break;
    case Jitter::Kind::missed_frames:
      if (is(path, "probability")) return timing({&jitter.amount, 0.0, 1.0});
      break;
  }
  return std::nullopt;
}

Field in_clock(Clock& clock, Tokens path) {
  if (path.empty()) return std::nullopt;
  if (path.front() == "jitter" && clock.jitter) return in_jitter(*clock.jitter, path.subspan(1));
  if (auto* const rate = std::get_if<FixedRate>(&clock.base); rate != nullptr && is(path, "rate_hz"))
    return timing({&rate->rate_hz, 1.0 / kFrameMax_s, kRateMax_hz});
  if (auto* const step = std::get_if<FixedStep>(&clock.base); step != nullptr && is(path, "dt_s"))
    return timing({&step->dt_s, 0.0, kFrameMax_s});
  auto* const trace = std::get_if<RecordedSteps>(&clock.base);
  if (trace == nullptr || path.size() != 2 || path.front() != "dt_s") return std::nullopt;
  const auto frame = index_in(path[1], trace->dt_s.size());
  if (!frame) return std::nullopt;
  return timing({&trace->dt_s[*frame], 0.0, kFrameMax_s});
}

struct InAction {
  Tokens path;

  Field operator()(Fling& fling) const { return in_velocity(fling.velocity, path); }
  Field operator()(Release& release) const { return in_velocity(release.velocity, path); }
  Field operator()(Place& place) const { return in_position(place.position, path); }
  Field operator()(Hitch& hitch) const {
    if (!is(path, "dt_s")) return std::nullopt;
    return timing({&hitch.dt_s, 0.0, kFrameMax_s});
  }
  Field operator()(Resize& resize) const {
    if (path.empty()) return std::nullopt;
    if (path.front() == "window" && resize.window) return in_window(*resize.window, path.subspan(1));
    if (path.front() == "sprite" && resize.sprite) return in_sprite(*resize.sprite, path.subspan(1));
    return std::nullopt;
  }
  Field operator()(Stop&) const { return std::nullopt; }
  Field operator()(Grab&) const { return std::nullopt; }
};

Field in_event(Event& event, Tokens path) {
  if (path.empty()) return std::nullopt;
  if (auto* const step = std::get_if<std::int64_t>(&event.when); step != nullptr && is(path, "step"))
    return timing({step, 0.0, real(kStepsMax)});
  if (auto* const at_s = std::get_if<double>(&event.when); at_s != nullptr && is(path, "at_s"))
    return timing({at_s, -kNoLimit, kNoLimit});
  if (path.front() != name_of(event.action)) return std::nullopt;
  return std::visit(InAction{path.subspan(1)}, event.action);
}

Field in_events(std::vector<Event>& events, Tokens path) {
  if (path.empty()) return std::nullopt;
  const auto event = index_in(path.front(), events.size());
  return event ? in_event(events[*event], path.subspan(1)) : std::nullopt;
}

}  // namespace

NumberKind number_kind(std::string_view pointer) {
  const std::string_view key = pointer.substr(pointer.rfind('/') + 1);
  if (key == "seed") return NumberKind::seed;
  for (const std::string_view integer : {"width_px", "height_px", "step", "steps", "every"})
    if (key == integer) return NumberKind::integer;
  return NumberKind::real;
}

std::optional<NumberField> number_at(Scenario& scenario, std::string_view pointer) {
  const std::vector<std::string_view> tokens = tokens_of(pointer);
  if (tokens.empty()) return std::nullopt;
  const std::string_view first = tokens.front();
  const Tokens path = Tokens(tokens).subspan(1);
  if (first == "window") return in_window(scenario.window, path);
  if (first == "sprite") return in_sprite(scenario.sprite, path);
  if (first == "start") {
    const Field position = in_position(scenario.start, path);
    return position ? position : in_velocity(scenario.start_velocity, path);
  }
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

}  // namespace hyrax
