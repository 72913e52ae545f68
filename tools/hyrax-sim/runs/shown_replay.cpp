#include "tools/hyrax-sim/runs/shown_replay.h"

#include <algorithm>
#include <chrono>

#include "tools/hyrax-sim/command_line/progress.h"

namespace hyrax {

void play_shown(Replay& replay, std::int64_t end) {
  using SteadyClock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kShortPiece(50);
  Progress progress("steps", end);
  // Steps that repeat take no time: the pieces grow until a piece is worth a look.
  std::int64_t piece = progress.is_shown() ? 1 << 16 : end;
  for (std::int64_t step = 0; step < end && replay.keyframe().row.step == step;) {
    const SteadyClock::time_point begin = SteadyClock::now();
    step = std::min(end, step + piece);
    replay.play_to(step);
    progress.show(step);
    if (SteadyClock::now() - begin < kShortPiece) piece = std::min(end, 2 * piece);
  }
}

}  // namespace hyrax
