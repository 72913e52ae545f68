#include "sim/explain/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/explain/first_operation.h"
#include "sim/explain/step_replay.h"
#include "sim/motion/listing.h"

namespace hyrax {
namespace {

Cause unknown(std::string detail) { return {kUnknownCause, CauseKind::unknown, std::move(detail), {}, {}}; }
Cause changed(std::string_view operation, std::string detail) {
  return {operation, CauseKind::changed, std::move(detail), {}, {}};
}

std::string input_text(const Input& input) {
  return fmt::format("{} in frame {}", name_of(input.action), input.frame);
}

// The first input that differs, as text.
std::optional<std::string> input_difference(const StoredRun& golden, const StoredRun& fresh) {
  const auto [from, to] = std::ranges::mismatch(
      golden.inputs, fresh.inputs, [](const Input& a, const Input& b) { return same_bits(a, b); });
  const bool has_from = from != golden.inputs.end();
  const bool has_to = to != fresh.inputs.end();
  if (!has_from && !has_to) return std::nullopt;
  return fmt::format("inputs differ: {} -> {}", has_from ? input_text(*from) : "none",
                     has_to ? input_text(*to) : "none");
}

bool has_hitch(const std::vector<Input>& inputs, std::int64_t frame) {
  return std::ranges::any_of(inputs, [frame](const Input& input) {
    return input.frame == frame && std::holds_alternative<Hitch>(input.action);
  });
}

// The first frame time that differs, or time, as text. A hitch is an input: its frame is left out.
std::optional<std::string> time_difference(const StoredRun& golden, const StoredRun& fresh) {
  const std::size_t rows = std::min(golden.rows.size(), fresh.rows.size());
  for (std::size_t row = 1; row < rows; ++row) {
    const double from_s = golden.rows.dt_s[row];
    const double to_s = fresh.rows.dt_s[row];
    const auto frame = static_cast<std::int64_t>(row) - 1;
    if (!same_bits(from_s, to_s) && !has_hitch(golden.inputs, frame) && !has_hitch(fresh.inputs, frame))
      return fmt::format("the clock gives other frame times: dt of row {} {} -> {} s", row, from_s, to_s);
  }
  if (input_difference(golden, fresh)) return std::nullopt;  // A hitch in another frame changes all times.
  for (std::size_t row = 0; row < rows; ++row)
    if (!same_bits(golden.rows.t_s[row], fresh.rows.t_s[row]))
      return fmt::format("the clock counts time differently: t of row {} {} -> {} s", row,
                         golden.rows.t_s[row], fresh.rows.t_s[row]);
  return std::nullopt;
}

// Whether the listing gives every step of a short golden file but those that follow an input.
bool gives_between_inputs(const StepStatements& base, const StoredRun& golden, const Kernel& program) {
  return golden.rows.size() > 1 &&
         std::ranges::all_of(observed_steps(golden, golden, program), [&](const ObservedStep& step) {
           return step.follows_input || gives(base, step);
         });
}

constexpr const char* kGoldenNotReproduced =
    "the listing with the golden file's constants does not give the golden file's own rows";

// The step is the listing, so frame times or inputs differ. Nothing: all rows agree.
std::optional<Cause> cause_of_playback(const DifferingRun& run, const Kernel& program,
                                       const StepStatements& base, bool gives_golden) {
  const auto& [golden, fresh, scenario_change, is_as_blessed] = run;
  if (!is_as_blessed)
    return unknown("the golden file was changed after it was blessed, so its rows are no evidence");
  if (!reproduces(base, *program.constants(), fresh.scenario, fresh))
    return {{kInputCause,
             CauseKind::unknown,
             "every step is the listing's, but an input has another effect",
             {},
             {}}};
  const std::optional<std::string> time = time_difference(golden, fresh);
  const std::optional<std::string> input = input_difference(golden, fresh);
  if (!gives_golden) {
    if (time || !gives_between_inputs(base, golden, program)) return unknown(kGoldenNotReproduced);
    return changed(kInputCause, input.value_or("an input has another effect"));
  }
  if (time) return changed(kClockCause, *time + (input ? "; " + *input : ""));
  if (input) return changed(kInputCause, *input);
  if (golden.state_hash != fresh.state_hash) return changed(kClockCause, "the clock gives other frame times");
  return std::nullopt;
}

// Of a core of one's own no change can be tried.
Cause without_listing(const std::string& scenario_change) {
  if (!scenario_change.empty())
    return unknown("the scenario changed since it was blessed: " + scenario_change);
  return unknown("changes can be tried on the paper's model only, and the core is another one");
}

}  // namespace

Diagnosis diagnose(const DifferingRun& run, const Kernel& program) {
  const auto& [golden, fresh, scenario_change, is_as_blessed] = run;
  if (!program.constants() || !golden.constants) return {without_listing(scenario_change), {}};
  const StepStatements base = listing(*golden.constants);
  if (!scenario_change.empty()) {
    if (reproduces(base, *program.constants(), fresh.scenario, fresh))
      return {changed(kScenarioCause, scenario_change), {}};
    return {unknown("the scenario changed since it was blessed: " + scenario_change +
                    "; the listing does not reproduce its run"),
            {}};
  }
  Diagnosis diagnosis{std::nullopt, observed_steps(fresh, golden, program)};
  std::stable_partition(diagnosis.evidence.begin(), diagnosis.evidence.end(),
                        [&](const ObservedStep& step) { return !gives(base, step); });
  const bool gives_golden = reproduces(base, *golden.constants, playback_of(golden), golden);
  const bool is_step_changed = !diagnosis.evidence.empty() && !gives(base, diagnosis.evidence.front());
  if (!is_step_changed) diagnosis.cause = cause_of_playback(run, program, base, gives_golden);
  diagnosis.has_equal_rows = !is_step_changed && !diagnosis.cause;
  if (!diagnosis.cause && !gives_golden) diagnosis.cause = unknown(kGoldenNotReproduced);
  return diagnosis;
}

Cause unexplained(const DifferingRun& run, const std::vector<ObservedStep>& evidence) {
  const StepStatements base = listing(*run.golden.constants);
  if (evidence.empty() || gives(base, evidence.front()))
    return unknown("all rows agree, but what is measured of the contacts does not");
  const auto differing_end =
      std::ranges::find_if(evidence, [&](const ObservedStep& step) { return gives(base, step); });
  const bool is_input = std::all_of(evidence.begin(), differing_end,
                                    [](const ObservedStep& step) { return step.follows_input; });
  const std::string nothing = "no single change reproduces it";
  if (is_input)
    return {kInputCause, CauseKind::unknown, nothing + "; only steps after inputs differ", {}, {}};
  const std::optional<Operation> first = first_operation(*run.golden.constants, evidence.front());
  if (!first) return unknown(nothing);
  return {name_of(*first),
          CauseKind::unknown,
          fmt::format("{}; the first operation whose result differs: {}", nothing, name_of(*first)),
          {},
          {}};
}

}  // namespace hyrax
