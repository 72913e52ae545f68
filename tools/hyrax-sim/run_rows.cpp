#include "tools/hyrax-sim/run_rows.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <string_view>

#include "sim/replay/replay.h"
#include "tools/files/path.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/golden_check.h"
#include "tools/hyrax-sim/shown_replay.h"
#include "tools/store/trajectory_file.h"

namespace hyrax {
namespace {

void replay_to(const Scenario& scenario, RowSink& sink, std::int64_t last_step) {
  Replay replay(scenario, sink);
  play_shown(replay, last_step);
  static_cast<void>(replay.finish());
}

void read_to(const TrajectoryFile& file, RowSink& sink, std::int64_t last_step) {
  constexpr std::int64_t kBatchRows = 1 << 16;
  for (std::int64_t first = 0; first <= last_step; first += kBatchRows) {
    const Columns rows = file.rows(first, std::min(kBatchRows, last_step + 1 - first));
    for (std::size_t index = 0; index < rows.size(); ++index)
      if (rows.step[index] != first + static_cast<std::int64_t>(index))
        file.refuse("/trajectory/step: holds " + std::to_string(rows.step[index]) + " where row " +
                    std::to_string(first + static_cast<std::int64_t>(index)) + " belongs");
    sink.rows(rows);
  }
}

RunRows rows_of(const std::shared_ptr<const TrajectoryFile>& file) {
  const FileHead& head = file->head();
  if (file->row_count() != head.steps + 1) {
    const RunSummary summary = play(head.scenario);
    RunRows rows = rows_of(head.scenario, summary);
    rows.note = "replayed from its scenario, since it holds " + std::to_string(file->row_count()) + " of " +
                std::to_string(head.steps + 1) + " rows";
    if (hex(summary.state_hash) != head.state_hash) rows.note += "; THE REPLAY HAS ANOTHER STATE HASH";
    return rows;
  }
  RunRows rows;
  rows.scenario = head.scenario;
  rows.inputs = inputs_taken(head.scenario, head.steps);
  rows.steps = head.steps;
  rows.simulated_s = file->rows(head.steps, 1).t_s.front();
  rows.hand_to = [file](RowSink& sink, std::int64_t last_step) { read_to(*file, sink, last_step); };
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
  rows.hand_to = [scenario](RowSink& sink, std::int64_t last_step) { replay_to(scenario, sink, last_step); };
  return rows;
}

// A file that is damaged in its first bytes should be refused as what its name says. Looking into a pipe
// would take its first bytes away, or wait for them.
bool is_trajectory(const std::string& path) {
  if (path.ends_with(".h5")) return true;
  if (!is_regular_file(path)) return false;
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  char begin[kSignature.size()] = {};
  std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
  return std::string_view(begin, sizeof begin) == kSignature;
}

RunRows load_rows(const std::string& path) {
  if (is_trajectory(path)) return rows_of(std::make_shared<const TrajectoryFile>(TrajectoryFile::open(path)));
  const Scenario scenario = load_scenario(path);
  return rows_of(scenario, play(scenario));
}

}  // namespace hyrax
