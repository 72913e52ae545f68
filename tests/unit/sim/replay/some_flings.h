// Scenarios for the replay's tests: small ones written here, random ones drawn from a seed, and
// the scenario files.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/search/draws.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {

inline constexpr Size kDesktopWindow{1920, 1080};
inline constexpr Size kHyrax{128, 128};

/// A throw across a desktop at a fixed rate.
inline Scenario fling_at(double rate_hz, std::int64_t steps, std::vector<Event> events = {}) {
  Scenario scenario;
  scenario.name = "fling";
  scenario.window = kDesktopWindow;
  scenario.sprite = kHyrax;
  scenario.start = {300.0, 500.0};
  scenario.start_velocity = {2400.0, -700.0};
  scenario.clock.base = FixedRate{rate_hz};
  scenario.length = steps;
  scenario.events = std::move(events);
  return scenario;
}

/// A frame clock, all kinds of input, walls and corners, in 330 frames.
inline Scenario eventful_fling() {
  Scenario scenario = fling_at(60.0, 330,
                               {{std::int64_t{0}, Hitch{0.03}},
                                {std::int64_t{40}, Fling{{-1500.0, -900.0}}},
                                {std::int64_t{60}, Hitch{0.5}},
                                {std::int64_t{100}, Grab{}},
                                {std::int64_t{101}, Place{{640.0, 200.0}}},
                                {std::int64_t{105}, Hitch{0.0}},
                                {std::int64_t{106}, Fling{{5.0, 6.0}}},
                                {std::int64_t{110}, Release{{700.0, -1200.0}}},
                                {std::int64_t{150}, Resize{Size{900, 500}, {}}},
                                {std::int64_t{180}, Resize{{}, Size{1000, 64}}},
                                {std::int64_t{200}, Resize{kDesktopWindow, kHyrax}},
                                {4.5, Stop{}}});
  scenario.clock.jitter = Jitter{Jitter::Kind::missed_frames, 0.1, 7};
  return scenario;
}

inline Action any_action(Draws& draws, bool& is_held) {
  const Velocity velocity{draws.between(-2000.0, 2000.0), draws.between(-2000.0, 2000.0)};
  switch (draws.below(6)) {
    case 0:
      return Place{{draws.between(-100.0, 2000.0), draws.between(-100.0, 1200.0)}};
    case 1:
      return Stop{};
    case 2:
      return Resize{
          Size{static_cast<std::int32_t>(draws.below(1500)), static_cast<std::int32_t>(draws.below(900))},
          {}};
    case 3:
      return Hitch{draws.between(0.0, 0.5)};
    case 4:
      is_held = !is_held;
      return is_held ? Action(Grab{}) : Action(Release{velocity});
    default:
      return Fling{velocity};
  }
}

/// A throw by draws: window and sprite of any proportion, dt from a thousandth of a second to two,
/// so that orbits of all periods come about; some with inputs.
inline Scenario any_fling(std::uint64_t seed, std::int64_t steps) {
  Draws draws(seed);
  Scenario scenario = fling_at(60.0, steps);
  scenario.window = {static_cast<std::int32_t>(draws.below(2000)),
                     static_cast<std::int32_t>(draws.below(1200))};
  scenario.sprite = {static_cast<std::int32_t>(1 + draws.below(300)),
                     static_cast<std::int32_t>(1 + draws.below(300))};
  scenario.start = {draws.between(-100.0, 2000.0), draws.between(-100.0, 1200.0)};
  scenario.start_velocity = {draws.between(-3000.0, 3000.0), draws.between(-3000.0, 3000.0)};
  const double fastest_s[] = {0.001, 0.004, 0.05, 0.05};
  const double slowest_s[] = {0.02, 0.03, 0.4, 2.0};
  const std::uint64_t pace = draws.below(4);
  scenario.clock.base = FixedStep{draws.between(fastest_s[pace], slowest_s[pace])};
  bool is_held = false;
  for (std::uint64_t event = draws.below(5), at = 0; event > 0; --event) {
    at += draws.below(static_cast<std::uint64_t>(steps) / 5);
    scenario.events.push_back({static_cast<std::int64_t>(at), any_action(draws, is_held)});
  }
  return scenario;
}

inline std::vector<std::string> scenario_files() {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(HYRAX_SOURCE_DIR) + "/scenarios"))
    if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace hyrax
