#include "tools/hyrax/playback.h"

#include <cassert>

#include "tools/files/non_finite_text.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_reader.h"

namespace hyrax {
namespace {

constexpr std::int64_t kFramesAtOnceMax = 100'000;

bool expects_hash(const Scenario& scenario) { return scenario.expect && scenario.expect->state_hash; }

PlaybackVerdict verdict_on(const Scenario& scenario, const RunSummary& run) {
  const std::string hash = hex(run.state_hash);
  const std::string name = scenario.name + ": ";
  if (run.non_finite_step) return {ExitCode::disagreed, name + non_finite_text(scenario, run.final)};
  if (!expects_hash(scenario))
    return {ExitCode::agreed, name + "state hash " + hash + "; the scenario expects none"};
  if (*scenario.expect->state_hash != hash)
    return {ExitCode::disagreed,
            name + "state hash differs (found " + hash + "); expected " + *scenario.expect->state_hash};
  return {ExitCode::agreed, name + "state hash " + hash + " agrees"};
}

}  // namespace

Scenario load_for_pet(const std::string& path) {
  Scenario scenario = load_scenario(path);
  if (!scenario.parameters.empty())
    refuse_input(printable(path) +
                 ": /parameters: hyrax plays its own constants only; hyrax-sim run plays these");
  return scenario;
}

PlaybackVerdict replayed(const Core& core, const Scenario& scenario) {
  return verdict_on(scenario, replay(core, scenario));
}

Playback::Playback(const Core& core, const Scenario& scenario, std::int64_t ticks_per_s, std::int64_t ticks)
    : scenario_(scenario), ticks_per_s_(ticks_per_s), begin_ticks_(ticks), replay_(core, scenario) {
  assert(ticks_per_s > 0);
}

void Playback::play(std::int64_t ticks) {
  const double elapsed_s = static_cast<double>(ticks - begin_ticks_) / static_cast<double>(ticks_per_s_);
  for (std::int64_t frames = 0; !is_over() && now().row.t_s < elapsed_s && frames < kFramesAtOnceMax;
       ++frames) {
    replay_.play_to(now().row.step + 1);
    is_non_finite_ = !is_finite(state_of(now().row));
  }
}

bool Playback::is_over() const { return is_non_finite_ || now().row.step >= replay_.steps(); }

PlaybackVerdict Playback::finish() {
  if (!is_over())
    return {expects_hash(scenario_) ? ExitCode::disagreed : ExitCode::agreed,
            scenario_.name + ": ended at step " + std::to_string(now().row.step) + " of " +
                std::to_string(replay_.steps()) + "; the state hash was not compared"};
  replay_.play_to(replay_.steps());
  return verdict_on(scenario_, replay_.finish());
}

}  // namespace hyrax
