#include "tools/app/play/play.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "sim/result/number_text.h"
#include "tools/app/command_line/print.h"

namespace hyrax {
namespace {

class PlayedRows final : public RowSink {
 public:
  PlayedRows(const Core& core, const Scenario& scenario)
      : scenario_(scenario),
        replay_(core, scenario_, *this),
        end_(std::min(replay_.steps(), kRowsPlayedMax)) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override { rows_.append(row); }

  // Rows come in batches of a block; those that are left, at the end.
  void next(Columns& batch) {
    constexpr std::int64_t kPiece = 1 << 16;
    rows_.clear();
    while (rows_.size() == 0 && !is_done_) {
      const std::int64_t from = replay_.keyframe().row.step;
      replay_.play_to(std::min(end_, from + kPiece));
      is_done_ = replay_.keyframe().row.step < from + kPiece;
      if (is_done_) static_cast<void>(replay_.finish());
    }
    std::swap(batch, rows_);
  }

 private:
  Scenario scenario_;
  Columns rows_;
  bool is_done_ = false;
  Replay replay_;
  std::int64_t end_;
};

}  // namespace

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

RowBatches played_rows(const Core& core, const Scenario& scenario) {
  return [played = std::make_shared<PlayedRows>(core, scenario)](Columns& batch) { played->next(batch); };
}

}  // namespace hyrax
