#include "tools/hyrax-sim/runs/run_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <string_view>

#include "tools/files/presence.h"
#include "tools/hyrax-sim/command_line/progress.h"
#include "tools/hyrax-sim/golden/golden_check.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

void replay_to(const Scenario& scenario, RowSink& sink, std::int64_t last_step) {
  Replay replay(scenario, sink);
  play_with_progress(replay, last_step);
  static_cast<void>(replay.finish());
}

void read_to(const TrajectoryFile& file, RowSink& sink, std::int64_t last_step) {
  constexpr std::int64_t kBatchRows = 1 << 16;
  for (std::int64_t first = 0; first <= last_step; first += kBatchRows) {
    const Columns rows = file.rows(first, std::min(kBatchRows, last_step + 1 - first));
    for (std::size_t index = 0; index < rows.size(); ++index)
      if (rows.step[index] != first + static_cast<std::int64_t>(index))
        file.refuse(fmt::format("/trajectory/step: must be {} (found {})",
                                first + static_cast<std::int64_t>(index), rows.step[index]));
    sink.rows(rows);
  }
}

RunRows rows_of(const std::shared_ptr<const TrajectoryFile>& file) {
  const FileHead& head = file->head();
  if (file->row_count() != head.steps + 1) {
    const RunSummary summary = play(head.scenario);
    RunRows rows = rows_of(head.scenario, summary);
    rows.note = fmt::format("replayed from its scenario: the file holds {} of {} rows", file->row_count(),
                            head.steps + 1);
    if (hex(summary.state_hash) != head.state_hash) rows.note += "; THE REPLAY'S STATE HASH DIFFERS";
    return rows;
  }
  RunRows rows;
  rows.scenario = head.scenario;
  rows.inputs = inputs_taken(head.scenario, head.steps);
  rows.steps = head.steps;
  rows.simulated_s = file->rows(head.steps, 1).t_s.front();
  rows.source = [file](RowSink& sink, std::int64_t last_step) { read_to(*file, sink, last_step); };
  return rows;
}

}  // namespace

RunRows rows_of(const Scenario& scenario, const RunSummary& summary) {
  RunRows rows;
  rows.scenario = scenario;
  rows.inputs = inputs_taken(scenario, summary.steps);
  rows.steps = summary.steps;
  rows.simulated_s = summary.simulated_s;
  if (summary.periodic_from_step) rows.repetition = {*summary.periodic_from_step, summary.period_steps};
  rows.source = [scenario](RowSink& sink, std::int64_t last_step) { replay_to(scenario, sink, last_step); };
  return rows;
}

// By name first: a file with damaged first bytes is reported as a bad trajectory. A pipe is not opened:
// reading its first bytes would consume them, or wait for them.
bool is_trajectory(const std::string& path) {
  if (path.ends_with(".h5")) return true;
  if (!is_regular_file(path)) return false;
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  char begin[kSignature.size()] = {};
  std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
  return std::string_view(begin, sizeof begin) == kSignature;
}

RunRows load_rows(const std::string& path) {
  return rows_of(std::make_shared<const TrajectoryFile>(TrajectoryFile::open(path)));
}

void play_with_progress(Replay& replay, std::int64_t end) {
  using SteadyClock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kShortPiece(50);
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
}

std::string title_of(const Scenario& scenario, std::int64_t steps, double simulated_s) {
  std::string clock = "at recorded dt";
  if (const auto* rate = std::get_if<FixedRate>(&scenario.clock.base))
    clock = fmt::format("at {} Hz", rate->rate_hz);
  if (const auto* step = std::get_if<FixedStep>(&scenario.clock.base))
    clock = fmt::format("at dt {} s", step->dt_s);
  return fmt::format("{}: {} steps, {:.6g} s {}{}", scenario.name, steps, simulated_s, clock,
                     scenario.clock.jitter ? ", jittered" : "");
}

}  // namespace hyrax
