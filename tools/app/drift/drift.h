// A run measured against the reference: the command-line options for it, the measurement, and its result.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/core.h"
#include "sim/reference/drift_meter.h"
#include "sim/reference/drift_run.h"
#include "sim/reference/gsl_flight.h"
#include "sim/reference/margin.h"
#include "sim/result/result.h"
#include "sim/result/table.h"
#include "sim/study/reference_model.h"
#include "tools/app/command_line/options.h"
#include "tools/app/play/play.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {

/// The options --reference, --stepper and --tolerance.
struct ReferenceRequest {
  std::string name;  ///< "closed" or "gsl"; the initial value is the default.
  std::string stepper;
  std::optional<double> tolerance;

  /// Whether an option was given, for a default of "closed".
  [[nodiscard]] bool is_given() const { return name != "closed" || !stepper.empty() || tolerance; }
};
void declare_reference(Options& options, ReferenceRequest& request);

/// Nothing if GSL is not used.
/// ERRORS: Failure(bad_input) "COMMAND: ..." for a tolerance out of range, or settings of GSL without it.
[[nodiscard]] std::optional<GslOptions> gsl_options(const ReferenceRequest& request,
                                                    const std::string& command);

/// A run lists no more arcs and no more contacts than this; all of them are measured and counted.
inline constexpr std::size_t kArcsListedMax = 100'000;
/// A figure gets no more rows than this; of a longer run every K-th is kept.
inline constexpr std::size_t kRowsDrawnMax = 4'000;

struct DriftOptions {
  std::optional<GslOptions> gsl;  ///< A second solution of every arc; none: the closed form alone.
  bool keeps_rows = false;        ///< For a figure.
  bool encloses = false;          ///< Whether distances from the exact fling get bounds.
  bool stores_rows = false;       ///< In a trajectory file: the errors of every recorded row as well.
};

/// At most kRowsDrawnMax of many values: at the limit every other one is dropped, and from then on half as
/// many are added.
template <class Value>
class Thinned {
 public:
  explicit Thinned(std::vector<Value>& values) : values_(values) {}
  void add(const Value& value) {
    if (seen_++ % every_ != 0) return;
    values_.push_back(value);
    if (values_.size() < kRowsDrawnMax) return;
    for (std::size_t index = 0; 2 * index < values_.size(); ++index) values_[index] = values_[2 * index];
    values_.resize((values_.size() + 1) / 2);
    every_ *= 2;
  }

 private:
  std::vector<Value>& values_;
  std::int64_t seen_ = 0;
  std::int64_t every_ = 1;
};

/// Measures the whole run, its arcs, its contacts and the margin, as the run is played or read.
class DriftRecorder final : private DriftSink {
 public:
  /// @param model reference_model of the core, or of a file.
  /// @param row_sink gets the errors of every row as well; may be nullptr.
  DriftRecorder(const Scenario& scenario, const Model& model, const DriftOptions& options = {},
                DriftSink* row_sink = nullptr);

  /// Each of them must get the run.
  [[nodiscard]] std::vector<RowSink*> sinks() { return {&meter_, &margin_, &whole_}; }
  [[nodiscard]] DriftRun finish(std::int64_t steps, double simulated_s);

 private:
  [[nodiscard]] bool wants_rows() const override { return keeps_rows_ || row_sink_ != nullptr; }
  void row(const RowErrors& row) override;
  void arc(const ArcErrors& arc) override;
  void contact(const ImpactErrors& contact) override;

  bool keeps_rows_;
  DriftSink* row_sink_;
  DriftRun run_;
  std::size_t arcs_seen_ = 0;
  Thinned<DrawnRow> rows_{run_.rows};
  Thinned<WholeRow> whole_rows_{run_.whole_rows};
  std::unique_ptr<FlightSolver> solver_;
  DriftMeter meter_;
  MarginMeter margin_;
  WholeMeter whole_;
};

/// Plays the scenario once. Shows progress.
[[nodiscard]] DriftRun measure_drift(const Core& core, const Scenario& scenario,
                                     const DriftOptions& options = {});
/// What made a file's run: this program's core, or the paper's step with the constants in the file. Refers to
/// `head`.
/// ERRORS: Failure(bad_input) if another step made it, or if the reference does not allow its constants.
[[nodiscard]] Core core_of_file(const Core& core, const std::string& path, const FileHead& head);

/// Measures the rows of a trajectory file; if it does not hold every row, its scenario is played.
/// REQUIRES: a core as core_of_file's.
/// ERRORS: Failure(cannot_access), Failure(bad_input) as TrajectoryFile::open's.
[[nodiscard]] DriftRun load_drift(const Core& core, const std::string& path,
                                  const DriftOptions& options = {});

/// How a measurement ends: a fault of the reference is an internal error; a run that is not finite, or not
/// the listing's, disagrees.
[[nodiscard]] ExitCode drift_exit_code(const DriftRun& run);
/// ERRORS: Failure(bad_input) where GSL, asked for with other settings than its own, differs from the closed
/// form by more than drift.h allows.
void require_reached(const DriftRun& run);

/// The same scenario at half the dt: twice the frames, its events at the same times.
struct HalfDt {
  std::optional<DriftRun> run = {};
  std::string why_not = {};  ///< If it was not measured.
};
[[nodiscard]] HalfDt measure_half_dt(const Core& core, const Scenario& scenario);

struct DriftReport {
  DriftRun run;
  bool has_rows_stored = false;        ///< The errors of every row are in a file.
  std::optional<HalfDt> half_dt = {};  ///< If it was asked for.
};

/// The run as a result: a text of at most 100 columns (the whole run, arcs, contacts, margin, what was not
/// computed, what half the error costs), and the members of an entry of "runs", all except "scenario".
/// @param lists_all all arcs and contacts, and how the end moves with the start, instead of the first 20.
[[nodiscard]] Result drift_result(const DriftReport& report, bool lists_all);

// How a run depends on its start: the margin, and how far its end moves.

/// Whether rounding alone can change a contact.
[[nodiscard]] bool is_knife_edge(const Margin& margin);

/// "any start within ±0.27 px and px/s keeps all contacts; nearest decision: right wall, step 135".
[[nodiscard]] std::string margin_text(const Margin& margin);

/// The line of the text. @param all the table of d(end) / d(start), too.
[[nodiscard]] std::string start_text(const Margin& margin, bool all);

/// d(end) / d(start) as rows of numbers.
[[nodiscard]] Table sensitivity_table(const Sensitivity& sensitivity);
/// The member "margin" of a document.
[[nodiscard]] Table margin_table(const Margin& margin);

}  // namespace hyrax
