// Which parts of the model and which inputs a scenario needs: each is left out in turn (ablation), then all
// that are not needed at once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/core.h"
#include "sim/result/figure.h"
#include "sim/result/result.h"
#include "sim/result/table.h"
#include "sim/study/methods/cost.h"
#include "sim/study/methods/script.h"
#include "sim/study/speed_error/speed_error.h"
#include "sim/trace/step_player.h"

namespace hyrax {

enum class Need {
  needed,          ///< Some row moves by more than the tolerance.
  needed_jointly,  ///< Not needed alone, but needed as soon as others that are not needed are left out, too.
  below,           ///< Rows change, none by more than the tolerance.
  not_exercised,   ///< Not one bit of any row changes.
};

/// The run with a part left out against the complete run, at the times of the latter's rows.
struct PathDifference {
  bool is_same_bits = true;
  double path_px = 0.0;             ///< Largest distance; infinite if a position is not finite.
  double end_px = 0.0;              ///< Distance at the end.
  std::int64_t first_step = -1;     ///< The first row that differs; -1: none.
  std::int64_t contacts_moved = 0;  ///< Contacts that moved, appeared or vanished.
};

/// What is left out at a time: a part of the step, the jitter, or an input.
struct PartNeed {
  std::string part;                     ///< One of kModelPartNames, "jitter", or the name of an input.
  std::optional<ModelPart> model_part;  ///< None: jitter or an input.
  PathDifference difference = {};
  Need need = Need::needed;
  std::optional<std::size_t> input = {};  ///< Index into Script::inputs; none: a part of the step, or jitter.
  /// Of the step with all parts minus the one without, process by process; may be negative. Not measured
  /// where the part changes the run, and of jitter and inputs.
  MedianEstimate saved_ns_per_step = {};

  /// Whether it takes longer with the part, beyond the noise.
  [[nodiscard]] bool saves() const { return saved_ns_per_step.low > 0.0; }
};

struct ScenarioNeeds {
  std::string scenario;
  std::int64_t steps = 0;
  bool is_cut = false;         ///< Only the first kScriptFramesMax frames were played.
  bool comes_to_rest = false;  ///< Its position is settled at the end.
  /// Of a step of which any part can be left out, with all of them: what the times without some are compared
  /// with.
  MedianEstimate step_ns = {};
  MedianEstimate unneeded_out_ns = {};  ///< The same without all parts that are not needed.
  ClockProbe probe = {};                ///< When the steps were timed.
  std::vector<PartNeed> parts;
  std::set<std::uint32_t> paths_taken;  ///< Of NeedsOptions::core_step.
  PathDifference without_all_unneeded;  ///< All that are not needed, at once.
  /// The cheapest method and rate within the tolerance of the exact motion, if NeedsOptions::rates_hz has
  /// any.
  std::optional<SpeedError> methods;
  std::string why_no_methods;  ///< Why the scenario has no exact motion; empty: it has one.
};

struct NeedsOptions {
  double within_px = 1.0;
  CostOptions cost = {};
  /// The core's, whose paths are counted; null: they are not.
  std::shared_ptr<const StepProgram> core_step = {};
  std::vector<double> rates_hz;  ///< For the cheapest method; empty: it is not searched for.
};

/// Plays the scenario with each part left out in turn, and times it.
[[nodiscard]] ScenarioNeeds study_needs(const Core& core, const Scenario& scenario,
                                        const NeedsOptions& options, const CostMeter& measure_costs);

/// Enough frames to measure a step's time.
inline constexpr std::int64_t kFramesTimedMax = 10'000;

/// Plays the script's first kFramesTimedMax frames when it is called, to be timed: of one kernel whatever it
/// leaves out.
[[nodiscard]] std::function<void()> timed_run(const Core& core, const Script& script,
                                              const ModelParts& parts);

[[nodiscard]] Need need_of(const PathDifference& difference, double within_px);

/// "needed", "needed with others left out", "below the tolerance", "not exercised".
[[nodiscard]] std::string_view name_of(Need need);

[[nodiscard]] inline bool is_unneeded(Need need) {
  return need == Need::below || need == Need::not_exercised;
}

/// How many parts are not needed.
[[nodiscard]] inline std::int64_t unneeded_count(const ScenarioNeeds& needs) {
  return std::ranges::count_if(needs.parts, is_unneeded, &PartNeed::need);
}

/// How far the path of one scenario moves without each part: bars on a logarithmic axis, the tolerance as a
/// mark.
[[nodiscard]] Figure needs_figure(const ScenarioNeeds& needs, double within_px);

/// Which scenario exercises and needs which part: a grid of colours.
[[nodiscard]] Figure coverage_figure(const std::vector<ScenarioNeeds>& scenarios, double within_px);

/// "941 px"; "without bound" if it is infinite.
[[nodiscard]] std::string length_text(double length_px);

/// The parts of the model, jitter, and the kinds of input.
[[nodiscard]] const std::vector<std::string>& coverage_columns();

/// What a scenario needs of each of coverage_columns(): the most that it needs of any part of that kind.
[[nodiscard]] std::vector<Need> coverage_of(const ScenarioNeeds& needs);

/// Those of coverage_columns() that no scenario exercises.
[[nodiscard]] std::vector<std::string> never_exercised(const std::vector<ScenarioNeeds>& scenarios);

/// A row for each scenario, a column for each of coverage_columns().
[[nodiscard]] Table coverage_table(const std::vector<ScenarioNeeds>& scenarios);

/// The paths of the core's step that any of them takes.
[[nodiscard]] std::set<std::uint32_t> paths_taken(const std::vector<ScenarioNeeds>& scenarios);

/// The verdict's text: for each column, how many scenarios exercise and need it.
[[nodiscard]] Verdict coverage_verdict(const std::vector<ScenarioNeeds>& scenarios, double within_px);

}  // namespace hyrax
