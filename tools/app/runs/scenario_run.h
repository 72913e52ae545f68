// A scenario played for `run`: into a file, with the verdicts of its expectations and its golden file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/compare/comparison.h"
#include "sim/compare/expectations.h"
#include "sim/core/core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/scenario.h"
#include "sim/trajectory/run_summary.h"
#include "tools/app/command_line/print.h"
#include "tools/app/drift/drift.h"
#include "tools/files/json.h"
#include "tools/report/run_scene.h"

namespace hyrax {

struct WriteOptions {
  ReplayOptions replay;
  std::optional<DriftOptions> drift;  ///< Measured as the run is written.
  std::vector<RowSink*> also = {};    ///< Get the run as well.
};

struct WrittenRun {
  RunSummary summary;
  std::int64_t rows_recorded = 0;
  std::optional<DriftRun> drift;
};

/// Plays the scenario and writes a trajectory file, or as CSV if `output` ends in ".csv" or is
/// kStandardOutput. Shows progress. ERRORS: Failure(cannot_access) if `output` cannot be written.
[[nodiscard]] WrittenRun write_run(const Core& core, const std::string& output, const Scenario& scenario,
                                   const WriteOptions& options);

class RunPicture;

struct ScenarioRunOptions {
  std::string golden_folder;  ///< Empty: the `golden` beside the nearest `scenarios`.
  bool skips_repetition = true;
  bool compares = true;  ///< With the golden file, if there is one.
  std::optional<DriftOptions> drift;
  bool measures_start = false;    ///< How the run depends on its start.
  RunPicture* picture = nullptr;  ///< Gets what it draws.
};

struct ScenarioRun : WrittenRun {
  std::string path;  ///< As given.
  Scenario scenario;
  std::string output;
  std::vector<Expectation> expectations;
  std::optional<Margin> start;           ///< If it was measured.
  std::string golden_path;               ///< Empty if no golden file was looked for.
  std::string golden_folder;             ///< As given; empty if it was not.
  std::string not_compared;              ///< Why no golden file was looked for; else empty.
  std::optional<Comparison> comparison;  ///< With the golden file; nothing if it is missing.

  [[nodiscard]] bool is_as_expected() const;
  /// "agreed", "disagreed", or "played" if there was nothing to compare with, or its golden file is missing.
  [[nodiscard]] const char* status() const;
};

/// Compares with the golden file, so that nothing is written if it cannot be read; then plays the scenario,
/// writes `output` and judges.
/// ERRORS: Failure(cannot_access) for the output, Failure of reading the golden file.
[[nodiscard]] ScenarioRun run_scenario(const Core& core, const std::string& path, const Scenario& scenario,
                                       const std::string& output, const ScenarioRunOptions& options);

void print_run(const Core& core, const ScenarioRun& run, const Printing& printing);

/// An entry of "runs".
[[nodiscard]] Json run_json(const Core& core, const ScenarioRun& run);

/// What a figure shows of a run, gathered as it is played: every row of the first 50,000 steps, whatever the
/// file records, then as many as a figure can show, and the first contacts.
class RunPicture final : public RowSink {
 public:
  explicit RunPicture(const Scenario& scenario);

  [[nodiscard]] Wants wants() const override;
  void row(const Row& row) override { rows_.append(row); }
  void contact_began(const Contact& contact) override;

  /// ERRORS: those of write_text_file.
  void draw(const std::string& path, const ScenarioRun& run) const;
  /// For a contact sheet.
  [[nodiscard]] Sheet panel(const Scenario& scenario) const { return run_panel(scenario, rows_, contacts_); }

 private:
  std::int64_t rows_every_;
  Columns rows_;
  std::vector<Contact> contacts_;
};

}  // namespace hyrax
