#include "sim/cause/cause_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "sim/cause/run_match.h"
#include "sim/compare/comparison.h"
#include "sim/core/listing_core.h"
#include "sim/trajectory/row.h"

namespace hyrax {
namespace {

bool has_hitch(const std::vector<Input>& inputs, std::int64_t frame) {
  return std::ranges::any_of(inputs, [frame](const Input& input) {
    return input.frame == frame && std::holds_alternative<Hitch>(input.action);
  });
}

// Rows, or keyframes of a long run, in which time is known.
std::vector<Row> timed_rows(const StoredRun& run) {
  std::vector<Row> rows;
  for (std::size_t row = 0; row < run.rows.size(); ++row) rows.push_back(run.rows.row(row));
  for (const StoredBlock& block : run.blocks) rows.push_back(block.keyframe.row);
  if (!run.blocks.empty()) rows.push_back(run.final);
  return rows;
}

// The first frame time that differs, or time, as text. A hitch is an input: its frame is left out.
std::optional<std::string> time_difference(const StoredRun& golden, const StoredRun& fresh) {
  const std::vector<Row> from = timed_rows(golden), to = timed_rows(fresh);
  const std::size_t rows = std::min(from.size(), to.size());
  for (std::size_t row = 0; row < rows && from[row].step == to[row].step; ++row) {
    const std::int64_t frame = from[row].step - 1;
    if (!same_bits(from[row].dt_s, to[row].dt_s) && !has_hitch(golden.inputs, frame) &&
        !has_hitch(fresh.inputs, frame))
      return fmt::format("the clock gives other frame times: dt of row {} {} -> {} s", from[row].step,
                         from[row].dt_s, to[row].dt_s);
  }
  // A hitch in another frame changes all times.
  if (input_difference(golden.inputs, fresh.inputs)) return std::nullopt;
  for (std::size_t row = 0; row < rows && from[row].step == to[row].step; ++row)
    if (!same_bits(from[row].t_s, to[row].t_s))
      return fmt::format("the clock counts time differently: t of row {} {} -> {} s", from[row].step,
                         from[row].t_s, to[row].t_s);
  return std::nullopt;
}

// Which of a run's steps a core does not give.
struct StepEvidence {
  bool has_steps = false;
  bool gives_free_steps = true;  // Those that follow no input.
  bool gives_all = true;
};

// REQUIRES: the core takes the run's parameters.
StepEvidence evidence_of(const Core& own_core, const StoredRun& run, const StoredRun& other) {
  StepEvidence evidence;
  const Core core = with_parameters(own_core, run.scenario.parameters).value();
  for (const ObservedStep& step : observed_steps(run, other, core)) {
    evidence.has_steps = true;
    if (gives(core, step)) continue;
    evidence.gives_all = false;
    evidence.gives_free_steps &= step.follows_input;
  }
  return evidence;
}

constexpr char kOtherBits[] =
    "the accepted core gives other bits, too: the compiler, its flags, the processor, the C library, or a "
    "fault of the program";

class CauseFinder {
 public:
  explicit CauseFinder(const CauseBase& base) : base_(base) {}

  [[nodiscard]] Cause cause_of(const DifferingRun& run) const {
    const auto& [golden, fresh, scenario_change, is_as_blessed, names_accepted, is_repeated] = run;
    if (!is_repeated) return {CauseKind::unknown, std::string(kNotRepeated)};
    const bool is_judged = base_.accepted != nullptr && names_accepted;
    const Core& core = is_judged ? *base_.accepted : base_.program;
    for (const StoredRun* const each : {&golden, &fresh})
      if (!with_parameters(core, each->scenario.parameters))
        return {CauseKind::unknown,
                fmt::format("{} does not take the scenario's parameters", name_of_core(is_judged))};
    // A changed scenario of other length, or of equal rows, differs whatever the core is.
    const bool is_core_asked =
        scenario_change.empty() ||
        (golden.state_hash != fresh.state_hash && step_count(golden.scenario) == step_count(fresh.scenario));
    if (is_judged && is_core_asked && match(core, fresh.scenario, golden).is_whole()) return core_cause();
    if (!scenario_change.empty()) return scenario_cause(run, core, is_judged);
    // A golden file is no evidence of anything but its own damage.
    if (!is_as_blessed) return {CauseKind::golden, "the golden file was changed since it was blessed"};
    if (const auto cause = playback_cause(golden, fresh, core)) return *cause;
    if (!is_judged) return {CauseKind::unknown, not_judged()};
    return step_cause(golden, fresh, core);
  }

 private:
  [[nodiscard]] Cause core_cause() const {
    if (!base_.is_same_core) return {CauseKind::core, base_.core_change};
    return {CauseKind::unknown,
            "the core is the accepted one, and its step gives the golden file, but this program does not: "
            "its compiler, flags or processor, or a fault of the program"};
  }

  [[nodiscard]] std::string not_judged() const {
    return base_.accepted == nullptr ? base_.why_not_played
                                     : "blessed with another core than the accepted one";
  }

  static const char* name_of_core(bool is_judged) {
    return is_judged ? "the accepted core" : "this program's core";
  }

  [[nodiscard]] static Cause scenario_cause(const DifferingRun& run, const Core& core, bool is_judged) {
    if (match(core, run.golden.scenario, run.golden).rows) return {CauseKind::scenario, run.scenario_change};
    if (!run.is_golden_as_blessed)
      return {CauseKind::golden, "the golden file was changed since it was blessed"};
    return {
        CauseKind::unknown,
        fmt::format("the scenario changed since it was blessed: {}; {} does not give the golden file either",
                    run.scenario_change, name_of_core(is_judged))};
  }

  // Frame times and inputs differ in the files themselves. With those of the golden file the core must give
  // its rows; the frame times of a long run are not kept, and nothing but the clock and hitches makes them.
  [[nodiscard]] static std::optional<Cause> playback_cause(const StoredRun& golden, const StoredRun& fresh,
                                                           const Core& core) {
    const auto time = time_difference(golden, fresh);
    const auto input = input_difference(golden.inputs, fresh.inputs);
    if (!time && !input) return std::nullopt;
    if (golden.rows.size() > 0 && !match(core, playback_of(golden), golden).rows) return std::nullopt;
    if (!time) return Cause{CauseKind::input, *input};
    return Cause{CauseKind::clock, *time + (input ? "; " + *input : "")};
  }

  // The scenario, its frame times and inputs are the golden file's, but the accepted core, playing them, does
  // not give its rows. The core then plays the recorded steps one by one:
  // - it does not give the golden file's, though no input is before them: other arithmetic, or edited rows;
  // - it gives all of the golden file's, and the inputs differ: they came in other frames;
  // - of this run it does not give only those after an input: an input has another effect.
  [[nodiscard]] Cause step_cause(const StoredRun& golden, const StoredRun& fresh, const Core& core) const {
    if (base_.has_further_members && !match(core, golden.scenario, golden).rows)
      return {CauseKind::unknown, kOtherBits};
    const StepEvidence of_golden = evidence_of(core, golden, fresh);
    if (!of_golden.has_steps || !of_golden.gives_free_steps) {
      if (base_.calls_libm || !of_golden.has_steps) return {CauseKind::unknown, kOtherBits};
      return {CauseKind::golden, "the golden file's scenario and inputs do not give its rows"};
    }
    if (const auto input = input_difference(golden.inputs, fresh.inputs); input && of_golden.gives_all)
      return {CauseKind::input, *input};
    const StepEvidence of_fresh = evidence_of(core, fresh, golden);
    if (!of_golden.gives_all || !of_fresh.gives_all || golden.state_hash != fresh.state_hash) {
      if (of_fresh.gives_free_steps && !golden.inputs.empty())
        return {CauseKind::input, "an input has another effect"};
      return {CauseKind::unknown, kOtherBits};
    }
    return {CauseKind::unknown, "all rows agree, but what is measured of the contacts differs"};
  }

  const CauseBase& base_;
};

}  // namespace

std::vector<CauseGroup> group_by_cause(const std::vector<DifferingRun>& runs, const CauseBase& base) {
  const CauseFinder finder(base);
  std::vector<CauseGroup> groups;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const Cause cause = finder.cause_of(runs[run]);
    // Frame times and inputs are one cause each, whatever differs first in a run.
    const bool has_own_detail = cause.kind != CauseKind::clock && cause.kind != CauseKind::input;
    const auto group = std::ranges::find_if(groups, [&](const CauseGroup& one) {
      return one.cause.kind == cause.kind && (!has_own_detail || one.cause.detail == cause.detail);
    });
    if (group == groups.end())
      groups.push_back({cause, {run}});
    else
      group->runs.push_back(run);
  }
  std::ranges::stable_sort(groups, {}, [](const CauseGroup& group) {
    return std::tuple(group.cause.kind == CauseKind::unknown, -static_cast<std::int64_t>(group.runs.size()));
  });
  return groups;
}

}  // namespace hyrax
