// Sweeps of the paper's interface: their members are played by the ensemble.
#include <algorithm>
#include <memory>

#include "sim/scenario/frame_clock.h"
#include "tools/app/sweep/sweep_run.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {

PlayableSweep paper_sweep(const Core& core, SweepFile file) {
  const auto held = std::make_shared<const SweepFile>(std::move(file));
  const Sweep& sweep = held->sweep;
  const auto make_player = [&core, held] {
    return [held, player = std::make_shared<EnsemblePlayer>(core, held->sweep),
            results = std::vector<MemberResult>()](const WorkPart& part, std::int64_t first_row,
                                                   std::int64_t count, std::vector<Table>& tables) mutable {
      results.resize(static_cast<std::size_t>(count));
      const SweepTally tally{player->play(part, first_row, results)};
      set_members(held->sweep.keep, results, tables.front());
      return tally;
    };
  };
  constexpr std::int64_t kSteps = 1 << 26;
  constexpr std::int64_t kLeast = 64;
  constexpr std::int64_t kMost = 16384;
  return {.contents = {sweep, {members_table(sweep.keep), inputs_table(sweep)}},
          .text = held->text,
          .base_path = held->base_path,
          .chunk_rows = std::clamp(kSteps / (step_count(sweep.base) + 1), kLeast, kMost),
          .make_player = make_player,
          .member_text = [held](std::int64_t member) {
            return scenario_file_text(member_scenario(held->sweep, member));
          }};
}

}  // namespace hyrax
