#include "tools/app/play/play_with_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "sim/result/number_text.h"
#include "tools/app/command_line/progress.h"

namespace hyrax {

RunSummary play_with_progress(const Core& core, const Scenario& scenario, std::vector<RowSink*> sinks,
                              const ReplayOptions& options) {
  using SteadyClock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kShortPiece(50);
  Replay replay(core, scenario, std::move(sinks), options);
  const std::int64_t end = replay.steps();
  Progress progress("steps", end);
  // Steps that repeat take almost no time, so pieces grow until each takes long enough.
  std::int64_t piece = progress.is_shown() ? 1 << 16 : end;
  for (std::int64_t step = 0; step < end && replay.keyframe().row.step == step;) {
    const SteadyClock::time_point begin = SteadyClock::now();
    step = std::min(end, step + piece);
    replay.play_to(step);
    progress.show(step);
    if (SteadyClock::now() - begin < kShortPiece) piece = std::min(end, 2 * piece);
  }
  return replay.finish();
}

std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s) {
  std::string clock = "at recorded dt";
  if (const auto* rate = std::get_if<FixedRate>(&scenario.clock.base))
    clock = fmt::format("at {} Hz", rate->rate_hz);
  if (const auto* step = std::get_if<FixedStep>(&scenario.clock.base))
    clock = fmt::format("at dt {} s", step->dt_s);
  const std::int64_t scripted = step_count(scenario);
  return fmt::format("{}: {}{}, {:.6g} s {}{}", scenario.name,
                     steps == scripted ? "" : fmt::format("{} of ", steps), plain_counted(scripted, "step"),
                     simulated_s, clock, scenario.clock.jitter ? ", jittered" : "");
}

}  // namespace hyrax
