#include "tools/app/golden/golden_pair.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/cause/cause_groups.h"
#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/study/reference_model.h"
#include "sim/trajectory/waypoints.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/app/core/accepted_core.h"
#include "tools/app/core/core_requirements.h"
#include "tools/app/drift/drift.h"
#include "tools/files/non_finite_text.h"
#include "tools/files/summary_text.h"
#include "tools/files/text_file.h"
#include "tools/platform/path.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_summary.h"
#include "tools/store/trajectory_format.h"

namespace hyrax {
namespace {

// Air drag reduces a change of the start to 2e-9 in 20,000 steps; these are a few more.
constexpr std::int64_t kBlocksUntilStartIsForgotten = 5;

bool has_input_within(const std::vector<Input>& inputs, std::int64_t first_step, std::int64_t end_step) {
  return std::ranges::any_of(
      inputs, [&](const Input& input) { return input.frame >= first_step && input.frame < end_step; });
}

// Sends the rows that can decide the margin. A block that repeats is played until its start has no effect
// any more, and the rest of it skipped: its last row has the same state each time.
void send_decisive_rows(const Core& core, const StoredRun& run, RowSink& sink) {
  auto replay = std::make_optional<Replay>(core, run.scenario, sink);
  for (std::size_t index = 0; index + 1 < run.blocks.size(); ++index) {
    const StoredBlock& block = run.blocks[index];
    const Keyframe& next = run.blocks[index + 1].keyframe;
    const std::int64_t end_step =
        block.keyframe.row.step + kBlocksUntilStartIsForgotten * static_cast<std::int64_t>(kBlockRows);
    if (end_step >= next.row.step || has_input_within(run.inputs, end_step - 1, next.row.step)) continue;
    replay->play_to(end_step - 1);
    static_cast<void>(replay->finish());
    sink.row(next.row);
    replay.emplace(core, run.scenario, next, sink);
  }
  replay->play_to(run.steps);
  static_cast<void>(replay->finish());
}

// Empty for a core with another step: the margin is measured by the paper's laws.
std::string margin_in_summary(const Core& core, const FreshRun& fresh) {
  const StoredRun& run = fresh.run;
  const Model model = reference_model(run.physics, run.constants, run.scenario.parameters);
  if (!is_measurable(run.constants, model)) return "";
  MarginMeter meter(run.scenario, run.inputs, model);
  if (run.blocks.empty())
    meter.rows(run.rows);
  else
    send_decisive_rows(core, run, meter);
  const Margin margin = meter.margin();
  return margin_text(margin) + (is_knife_edge(margin) ? " (a knife edge)" : "");
}

// What in a pair whose rows agree is not as it was blessed.
std::optional<std::string> fault_in(const std::string& text, const StoredRun& kept,
                                    const std::string& h5_checksum, bool is_blessed_file,
                                    const GoldenPlace& place) {
  if (text.find("\r\n") != std::string::npos) return place.txt_path + ": " + kConvertedLineEnds;
  if (!has_checksums(text, contents_checksum(kept), h5_checksum))
    return place.txt_path + ": its checksums are not those of its lines and of " + place.h5_path;
  // Files of earlier versions have fewer attributes; those that they have must be the same.
  return attribute_difference(place.h5_path, kept, is_blessed_file);
}

void refuse_pair(Comparison& comparison, const std::string& fault) {
  comparison.agrees = false;
  comparison.difference = DifferenceClass::shape;
  comparison.shape = fault;
}

std::string changed_text(const std::string& fault) {
  return "the golden file was changed since it was blessed: " + fault +
         "; restore it, or bless the scenario again";
}

// The cores that a file's rows may be of.
std::vector<Core> cores_of(const Core& core, const StoredRun& kept, const GoldenPlace& place) {
  std::vector<Core> cores;
  if (kept.blocks.empty()) return cores;
  if (kept.constants) cores.push_back(listing_core(*kept.constants));
  if (const auto accepted = accepted_step(place.folder, core))
    if (auto played = with_parameters(*accepted, kept.scenario.parameters))
      cores.push_back(*std::move(played));
  return cores;
}

// Judges a pair that the summary's hash does not decide, by all that the .h5 file has.
PairComparison read_and_compare(const Core& core, const Scenario& scenario, const GoldenPlace& place,
                                const std::string& text, FreshRun fresh, const std::string& h5_checksum) {
  StoredRun kept = read_golden(place.h5_path);
  require_own_core(core, place.h5_path, kept.physics);
  PairComparison pair{compare_with(core, kept, scenario, cores_of(core, kept, place))};
  pair.is_proved = false;
  const std::optional<std::string> blessed_checksum = summary_file_checksum(text);
  const bool is_blessed_file = !blessed_checksum || *blessed_checksum == h5_checksum;
  // The run was played twice: for `fresh`, and against the kept rows.
  const bool is_repeated = fresh.run.state_hash == hex(pair.summary.state_hash);
  const bool is_same_scenario = plays_the_same(kept.scenario, scenario);
  // Another scenario is a difference of its own, unless the file was edited: then it contradicts itself.
  if (is_repeated && !is_blessed_file && !is_same_scenario && !gives_its_rows(core, kept)) {
    pair.gives_its_rows = false;
    refuse_pair(pair.comparison, changed_text(place.h5_path + ": its scenario does not give its rows"));
    return pair;
  }
  const bool is_same_run = is_same_scenario && !pair.comparison.first && pair.comparison.contacts.is_none();
  // Only of a file as it was blessed is the hash that of its rows.
  const bool has_other_hash = blessed_checksum == h5_checksum && kept.state_hash != fresh.run.state_hash;
  if (!is_repeated)
    refuse_pair(pair.comparison, std::string(kNotRepeated));
  else if (has_other_hash && is_same_run && kept.steps == fresh.run.steps)
    refuse_pair(pair.comparison, "the state hash differs, but no row that was compared");
  // The file is as it was blessed, by another core whose run had the same hash: where only the contacts
  // differ, the two cores find them in the same rows by other means, which is no difference.
  const std::optional<Divergence>& first = pair.comparison.first;
  const bool is_told_otherwise = is_repeated && is_same_scenario && blessed_checksum == h5_checksum &&
                                 kept.state_hash == fresh.run.state_hash &&
                                 (!first || first->field.starts_with("contacts/")) &&
                                 summary_core(text) != core.record.checksum();
  if (is_told_otherwise) pair.comparison = {};
  // What remains different gets a cause, for which both runs are needed.
  if (!is_repeated || has_other_hash || !(is_same_run || is_told_otherwise))
    pair.runs = std::make_shared<const PairRuns>(
        PairRuns{std::move(kept), std::move(fresh.run), is_blessed_file, summary_core(text), is_repeated});
  if (!pair.comparison.agrees) return pair;
  // The runs agree; so must the text and the attributes beside them.
  if (const auto fault = fault_in(text, kept, blessed_checksum.value_or(h5_checksum), is_blessed_file, place))
    refuse_pair(pair.comparison, changed_text(*fault));
  else if (!is_blessed_file)
    pair.note = place.h5_path + ": agrees, but does not have the checksum in " + place.txt_path +
                ": its provenance or its layout differs";
  else
    pair.note = pair.comparison.physics;
  pair.is_kept = pair.comparison.agrees && pair.note.empty() && kept.scenario.name == scenario.name;
  return pair;
}

bool has_core_constants(const Core& core, const StoredRun& kept) {
  const std::optional<Constants> constants = core.constants;
  if (!kept.constants || !constants) return kept.constants.has_value() == constants.has_value();
  return numbers_of(*kept.constants) == numbers_of(*constants);
}

}  // namespace

Deviation PairVerdict::deviation() const {
  return {comparison.difference, comparison.distance.px(), comparison.contacts.counts(),
          comparison.rest_shift_px()};
}

std::string PairVerdict::consequence() const {
  const std::string non_finite = runs ? non_finite_text(runs->fresh.scenario, runs->fresh.final) : "";
  return non_finite.empty() ? comparison_sentence(comparison) : non_finite;
}

std::string PairVerdict::first_difference() const {
  if (!comparison.first) return "";
  return fmt::format("step {}, field {}", comparison.first->step, comparison.first->field);
}

std::string PairVerdict::differences_text(bool lists_all) const {
  return comparison_text(comparison, lists_all);
}

Json::Object PairVerdict::differences_json() const { return comparison_json(comparison); }

std::string summary_of(const Core& core, const FreshRun& fresh, const std::string& reason,
                       const std::string& h5_checksum, const std::string& core_name) {
  WaypointMeter waypoints(step_count(fresh.run.scenario));
  static_cast<void>(replay(core, fresh.run.scenario, waypoints));
  return golden_summary_text(fresh.run, fresh.summary, waypoints.take(), reason,
                             margin_in_summary(core, fresh),
                             {contents_checksum(fresh.run), h5_checksum, core_name});
}

std::string renewed_summary(const Core& core, const Scenario& scenario, const GoldenPlace& place) {
  const std::string text = read_text_file(place.txt_path);
  return summary_of(core, play_for_golden(core, scenario, core), summary_reason(text),
                    file_checksum(place.h5_path), summary_core(text));
}

std::optional<PairComparison> compare_with_pair(const Core& core, const Scenario& scenario,
                                                const GoldenPlace& place, bool reads_h5,
                                                const Core& recording) {
  const std::string text = is_there(place.txt_path) ? read_text_file(place.txt_path) : "";
  const std::string h5_checksum = file_checksum(place.h5_path);
  FreshRun fresh = play_for_golden(core, scenario, recording);
  // The checksum of the contents asks for all contacts: of a long run with many it is another play.
  if (summary_state_hash(text) == fresh.run.state_hash &&
      has_checksums(text, contents_checksum(fresh.run), h5_checksum) &&
      text.starts_with("scenario: " + scenario.name + "\n"))
    return PairComparison{{.summary = fresh.summary}};
  if (!reads_h5) return std::nullopt;
  return read_and_compare(core, scenario, place, text, std::move(fresh), h5_checksum);
}

bool is_h5_current(const Core& core, const Scenario& scenario, const GoldenPlace& place) {
  const StoredRun kept = read_golden(place.h5_path);
  return kept.scenario.name == scenario.name && kept.physics == core.name && has_core_constants(core, kept) &&
         compare_with(core, kept, scenario).comparison.agrees &&
         !attribute_difference(place.h5_path, kept, false);
}

}  // namespace hyrax
