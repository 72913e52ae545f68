#include "tools/hyrax/menu.h"

#include "sim/scenario/split_mix64.h"

namespace hyrax {
namespace {

// Up and to one side.
Velocity random_throw(std::uint64_t seed) {
  const double side = split_mix64_unit(seed, 0) < 0.5 ? -1.0 : 1.0;
  return {side * (600.0 + 1400.0 * split_mix64_unit(seed, 1)), -800.0 - 900.0 * split_mix64_unit(seed, 2)};
}

}  // namespace

std::vector<MenuEntry> menu_entries(const MenuState& state) {
  const bool is_live = !state.is_replay;
  return {{Choice::throw_it, "&Throw", is_live},
          {Choice::pause, state.is_paused ? "&Go on" : "&Pause", is_live},
          {Choice::reset, "&Reset", is_live},
          {},
          {Choice::start_recording, "Start re&cording", is_live && !state.is_recording},
          {Choice::save_recording, "&Save recording", is_live && state.is_recording},
          {Choice::save_just_happened, "Save what &just happened", is_live},
          {},
          {Choice::about, "&About Hyrax"},
          {Choice::quit, "&Quit"}};
}

void execute(Choice choice, Pet& pet, Recorder& recorder, std::int64_t ticks) {
  switch (choice) {
    case Choice::throw_it:
      return pet.fling(random_throw(static_cast<std::uint64_t>(ticks)), ticks);
    case Choice::pause:
      pet.is_paused() ? pet.resume(ticks) : pet.pause();
      return recorder.save_if_due(ticks);
    case Choice::reset:
      return pet.reset(ticks);
    case Choice::start_recording:
      return recorder.start_new(ticks);
    case Choice::save_recording:
      return recorder.save();
    case Choice::save_just_happened:
      return recorder.save_just_happened();
    case Choice::none:
    case Choice::about:
    case Choice::quit:
      return;
  }
}

}  // namespace hyrax
