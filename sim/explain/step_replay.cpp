#include "sim/explain/step_replay.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "sim/replay/kernel_of.h"
#include "sim/replay/replay.h"

namespace hyrax {
namespace {

// A core whose step is data.
class StatementCore {
 public:
  StatementCore(const StepStatements& step, const State& state) : step_(&step), state_(state) {}

  void update(double dt_s, int window_width, int window_height, int sprite_width, int sprite_height) {
    StatementRun(dt_s, bounds_of({window_width, window_height}, {sprite_width, sprite_height}))(*step_,
                                                                                                state_);
  }
  [[nodiscard]] double x() const { return state_.x_px; }
  [[nodiscard]] double y() const { return state_.y_px; }
  [[nodiscard]] double vx() const { return state_.vx_px_per_s; }
  [[nodiscard]] double vy() const { return state_.vy_px_per_s; }
  void setPos(double x_px, double y_px) {
    state_.x_px = x_px;
    state_.y_px = y_px;
  }
  void setVelocity(double vx_px_per_s, double vy_px_per_s) {
    state_.vx_px_per_s = vx_px_per_s;
    state_.vy_px_per_s = vy_px_per_s;
  }
  void resetVelocity() { setVelocity(0.0, 0.0); }

 private:
  const StepStatements* step_;
  State state_;
};

struct StatementCores {
  using Core = StatementCore;

  const StepStatements* step = nullptr;
  Constants observed;

  [[nodiscard]] StatementCore make(const State& state) const { return {*step, state}; }
  [[nodiscard]] Constants constants() const { return observed; }
};

// Compares the blocks of a replay with those of a run, until one differs.
class BlockMatcher final : public RowSink {
 public:
  explicit BlockMatcher(const StoredRun& run) : blocks_(run.blocks) {}

  [[nodiscard]] Wants wants() const override { return {.blocks = !blocks_.empty()}; }
  void block(const Block& block, std::int64_t count) override {
    while (count > 0 && !differs_) {
      if (at_ == blocks_.size() || blocks_[at_].digest != block.digest) {
        differs_ = true;
        return;
      }
      const std::int64_t both = std::min(count, blocks_[at_].count - used_);
      count -= both;
      used_ += both;
      if (used_ < blocks_[at_].count) continue;
      ++at_;
      used_ = 0;
    }
  }
  [[nodiscard]] bool differs() const { return differs_; }

 private:
  const std::vector<StoredBlock>& blocks_;
  std::size_t at_ = 0;
  std::int64_t used_ = 0;
  bool differs_ = false;
};

bool is_hitch(const Input& input) { return std::holds_alternative<Hitch>(input.action); }

}  // namespace

Scenario playback_of(const StoredRun& golden) {
  Scenario playback = golden.scenario;
  playback.events.clear();
  const bool has_rows = golden.rows.size() > 1;
  for (const Input& input : golden.inputs)
    if (!has_rows || !is_hitch(input)) playback.events.push_back({input.frame, input.action});
  if (has_rows) {
    playback.clock = {RecordedSteps{{golden.rows.dt_s.begin() + 1, golden.rows.dt_s.end()}}, {}};
    playback.length = std::monostate();
    return playback;
  }
  if (const auto* const rate = std::get_if<FixedRate>(&playback.clock.base))
    playback.clock.base = FixedStep{1.0 / rate->rate_hz};
  playback.length = golden.steps;
  return playback;
}

bool reproduces(const StepStatements& step, const Constants& observed, const Scenario& scenario,
                const StoredRun& run) {
  const KernelOf<StatementCores> kernel(StatementCores{&step, observed});
  BlockMatcher matcher(run);
  Replay replay(scenario, matcher, {.kernel = &kernel});
  if (replay.steps() < run.steps) return false;
  std::int64_t piece = 16 * static_cast<std::int64_t>(kBlockRows);
  for (std::int64_t at = -1; at < run.steps && !matcher.differs(); piece *= 2) {
    if (replay.keyframe().row.step == at) break;  // The state is not finite any more.
    at = replay.keyframe().row.step;
    replay.play_to(std::min(run.steps, at + piece));
  }
  if (matcher.differs()) return false;
  const RunSummary summary = replay.finish();
  return summary.steps == run.steps && hex(summary.state_hash) == run.state_hash;
}

}  // namespace hyrax
