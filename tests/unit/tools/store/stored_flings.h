// Flings in trajectory files, for the store's tests.
#pragma once

#include <string>

#include "sim/core/core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/physics_model.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/store/trajectory_file.h"
#include "tools/store/trajectory_format.h"
#include "tools/store/trajectory_writer.h"

namespace hyrax {

/// Plays the scenario into a file, as `run` does.
inline RunSummary write_run(const std::string& path, const Scenario& scenario) {
  const std::int64_t steps = step_count(scenario);
  TrajectoryWriter writer(path, scenario, steps);
  const RunSummary summary = replay(shipped_core(), scenario, writer);
  writer.finish(
      {{steps, std::string(kPhysicsModel), hex(summary.state_hash), *shipped_core().constants}, scenario},
      inputs_of(scenario, steps), summary.contacts.total());
  return summary;
}

inline std::vector<Row> rows_of(const TrajectoryFile& file) {
  const Columns columns = file.rows(0, file.row_count());
  std::vector<Row> rows;
  for (std::size_t row = 0; row < columns.size(); ++row) rows.push_back(columns.row(row));
  return rows;
}

/// Reads all that a trajectory file holds.
inline void read_all(const std::string& path) {
  const TrajectoryFile file(path);
  static_cast<void>(file.rows(0, file.row_count()));
  static_cast<void>(file.contacts());
  static_cast<void>(file.contacts_total());
  static_cast<void>(file.inputs());
}

}  // namespace hyrax
