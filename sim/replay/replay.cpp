#include "sim/replay/replay.h"

#include "sim/replay/player.h"

namespace hyrax {

Replay::Replay(const Scenario& scenario, RowSink& sink, ReplayOptions options)
    : player_(std::make_unique<Player>(scenario, sink, options)) {}
Replay::Replay(const Scenario& scenario, const Keyframe& from, RowSink& sink, ReplayOptions options)
    : player_(std::make_unique<Player>(scenario, from, sink, options)) {}
Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;

std::int64_t Replay::steps() const { return player_->steps(); }
const Keyframe& Replay::keyframe() const { return player_->now(); }
void Replay::play_to(std::int64_t step) { player_->play_to(step); }
RunSummary Replay::finish() { return player_->finish(); }

RunSummary replay(const Scenario& scenario, RowSink& sink, ReplayOptions options) {
  Replay run(scenario, sink, options);
  run.play_to(run.steps());
  return run.finish();
}

}  // namespace hyrax
