#include "tools/files/scenario_members.h"

#include "sim/scenario/numbers.h"

namespace hyrax {
namespace {

Size read_size(const JsonPlace& here, std::int64_t low_px, std::int64_t high_px) {
  if (!here.is_object_of({"width_px", "height_px"})) return {};
  return {static_cast<std::int32_t>(here.required("width_px").integer(low_px, high_px).value_or(0)),
          static_cast<std::int32_t>(here.required("height_px").integer(low_px, high_px).value_or(0))};
}

Resize read_resize(const JsonPlace& here) {
  Resize resize;
  if (!here.is_object_of({"window", "sprite"})) return resize;
  if (const JsonPlace window = here.member("window"); window.is_there()) resize.window = read_window(window);
  if (const JsonPlace sprite = here.member("sprite"); sprite.is_there()) resize.sprite = read_sprite(sprite);
  if (!resize.window && !resize.sprite) here.wrong("must hold window, sprite or both");
  return resize;
}

Action read_action(const JsonPlace& here, std::size_t kind) {
  Action action = make_action(kind);
  if (auto* const resize = std::get_if<Resize>(&action)) {
    *resize = read_resize(here);
    return action;
  }
  std::vector<std::string_view> keys;
  visit_numbers(action, [&](std::string_view key, const NumberField&) { keys.push_back(key); });
  if (!here.is_object_of(keys)) return action;
  visit_numbers(action, [&](std::string_view key, const NumberField& field) {
    field.set(here.required(key).number({field.low, field.high}).value_or(0.0));
  });
  return action;
}

}  // namespace

Size read_window(const JsonPlace& here) { return read_size(here, 0, kWindowSideMax_px); }
Size read_sprite(const JsonPlace& here) { return read_size(here, kSpriteSideMin_px, kSpriteSideMax_px); }

Expect read_expect(const JsonPlace& here) {
  Expect expect;
  if (!here.is_object_of({"in_bounds", "finite", "final_x_px", "final_y_px", "at_rest_since_s", "contacts",
                          "state_hash", "implementation_px_max", "truncation_px_max",
                          "energy_drift_rel_max"}))
    return expect;
  expect.in_bounds = here.member("in_bounds").boolean();
  expect.finite = here.member("finite").boolean();
  expect.final_x_px = read_interval(here.member("final_x_px"));
  expect.final_y_px = read_interval(here.member("final_y_px"));
  expect.at_rest_since_s = read_time(here.member("at_rest_since_s"));
  if (const JsonPlace contacts = here.member("contacts");
      contacts.is_there() && contacts.is_object_of({kWallNames.begin(), kWallNames.end()}))
    for (const Wall wall : kWalls) expect.contacts[wall] = read_count(contacts.member(name_of(wall)));
  expect.state_hash = read_hash(here.member("state_hash"));
  expect.implementation_px_max = here.member("implementation_px_max").number(kNotNegativeRule);
  expect.truncation_px_max = here.member("truncation_px_max").number(kNotNegativeRule);
  expect.energy_drift_rel_max = here.member("energy_drift_rel_max").number(kNotNegativeRule);
  return expect;
}

void read_events(const JsonPlace& here, const FramesRead& frames, Scenario& scenario) {
  const auto* const array = here.is_there() ? here.json()->get<Json::Array>() : nullptr;
  scenario.events.resize(array == nullptr ? 0 : array->size());
  const auto read = [&](const JsonPlace& place, std::size_t event, std::size_t kind) {
    const Action& action = scenario.events[event].action = read_action(place, kind);
    EventEffect effect;
    if (std::holds_alternative<Grab>(action)) effect.hold = EventEffect::Hold::held;
    if (std::holds_alternative<Release>(action)) effect.hold = EventEffect::Hold::let_go;
    if (const auto* const hitch = std::get_if<Hitch>(&action)) effect.hitch_dt_s = hitch->dt_s;
    return effect;
  };
  const std::vector<EventTime> times =
      read_events(here, frames, scenario.clock,
                  {.names = {kActionNames.begin(), kActionNames.end()},
                   .held_already = "the sprite is held already; release it first",
                   .not_held = "the sprite is not held; grab it first",
                   .read = read});
  for (std::size_t event = 0; event < times.size(); ++event) scenario.events[event].when = times[event].when;
}

}  // namespace hyrax
