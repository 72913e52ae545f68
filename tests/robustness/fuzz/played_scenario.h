// What must hold for every scenario that the reader accepts.
#pragma once

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/scenario.h"
#include "tests/robustness/fuzz/fuzz_target.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {

/// It is written and read again as the same value, and can be played.
inline void hold_accepted(const Scenario& scenario) {
  const std::string text = scenario_file_text(scenario);
  const Scenario again = parse_scenario(text, "again.json");
  hold(plays_the_same(again, scenario) && scenario_file_text(again) == text,
       "a scenario that is written is read as the same");
  constexpr std::int64_t kStepsPlayed = 500;
  Replay replay(shipped_core(), scenario, {}, {.checks_bounds = true});
  replay.play_to(replay.steps() < kStepsPlayed ? replay.steps() : kStepsPlayed);
  static_cast<void>(replay.finish());
}

}  // namespace hyrax
