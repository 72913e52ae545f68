#include "tools/hyrax-sim/golden/golden_pair.h"

#include <algorithm>
#include <cassert>

#include "sim/replay/replay.h"
#include "tools/files/text_file.h"
#include "tools/hyrax-sim/drift/drift.h"
#include "tools/store/golden_digest.h"
#include "tools/store/golden_file.h"
#include "tools/store/golden_seal.h"

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
void send_decisive_rows(const StoredRun& run, RowSink& sink) {
  auto replay = std::make_optional<Replay>(run.scenario, sink);
  for (std::size_t index = 0; index + 1 < run.blocks.size(); ++index) {
    const StoredBlock& block = run.blocks[index];
    const Keyframe& next = run.blocks[index + 1].keyframe;
    const std::int64_t end_step =
        block.keyframe.row.step + kBlocksUntilStartIsForgotten * static_cast<std::int64_t>(kBlockRows);
    if (end_step >= next.row.step || has_input_within(run.inputs, end_step - 1, next.row.step)) continue;
    replay->play_to(end_step - 1);
    static_cast<void>(replay->finish());
    Columns row;
    row.append(next.row);
    sink.rows(row);
    replay.emplace(run.scenario, next, sink);
  }
  replay->play_to(run.steps);
  static_cast<void>(replay->finish());
}

std::string margin_in_summary(const FreshRun& fresh) {
  const StoredRun& run = fresh.run;
  MarginMeter meter(run.scenario, run.inputs);
  if (run.blocks.empty())
    meter.rows(run.rows);
  else
    send_decisive_rows(run, meter);
  const Margin margin = meter.margin();
  return margin_text(margin) + (is_knife_edge(margin) ? " (a knife edge)" : "");
}

std::string sealed_summary(const FreshRun& fresh, const std::string& reason, const GoldenSeal& seal) {
  return golden_digest_text(fresh.run, fresh.summary, reason, margin_in_summary(fresh)) + seal_line(seal);
}

// What in a pair whose rows agree is not as it was blessed. Two scenarios may differ in name and in how they
// are written and be the same all the same, so both are taken from the .h5 file.
std::optional<std::string> fault_in(const std::string& text, const StoredRun& kept, FreshRun fresh,
                                    const std::string& sealed_hash, const GoldenPlace& place) {
  fresh.run.scenario.name = kept.scenario.name;
  const GoldenSeal seal{contents_hash(kept), sealed_hash};
  if (const auto fault = digest_fault(text, sealed_summary(fresh, digest_reason(text), seal)))
    return place.txt_path + ": " + *fault;
  return golden_words_fault(place.h5_path);
}

void refuse_pair(Comparison& comparison, const std::string& fault) {
  comparison.agrees = false;
  comparison.difference = DifferenceClass::shape;
  comparison.shape = "all rows agree, but the golden file was changed after it was blessed: " + fault +
                     "; restore it, or bless the scenario again";
}

PairComparison read_and_compare(const Scenario& scenario, const GoldenPlace& place, const std::string& text,
                                FreshRun fresh, const std::string& h5_hash) {
  const StoredRun kept = read_golden(place.h5_path);
  ComparedRun compared = compare_with(kept, scenario);
  PairComparison pair{std::move(compared.comparison), compared.summary, false, ""};
  if (!pair.comparison.agrees) return pair;
  const auto seal = seal_in(text);
  const std::string sealed_hash = seal ? seal->file : h5_hash;
  if (const auto fault = fault_in(text, kept, std::move(fresh), sealed_hash, place))
    refuse_pair(pair.comparison, *fault);
  else if (sealed_hash != h5_hash)
    pair.note = place.h5_path + ": agrees, but its bytes are not those that " + place.txt_path +
                " seals: its provenance or its layout is another";
  return pair;
}

}  // namespace

std::string summary_of(const FreshRun& fresh, const std::string& reason, const std::string& h5_hash) {
  return sealed_summary(fresh, reason, {contents_hash(fresh.run), h5_hash});
}

std::optional<PairComparison> compare_with_pair(const Scenario& scenario, const GoldenPlace& place,
                                                bool reads_h5) {
  const std::string text = read_text_file(place.txt_path);
  const std::string h5_hash = file_hash(place.h5_path);
  FreshRun fresh = play_for_golden(scenario);
  if (text == summary_of(fresh, digest_reason(text), h5_hash))
    return PairComparison{.summary = fresh.summary};
  if (!reads_h5) return std::nullopt;
  return read_and_compare(scenario, place, text, std::move(fresh), h5_hash);
}

bool is_h5_current(const Scenario& scenario, const GoldenPlace& place) {
  const StoredRun kept = read_golden(place.h5_path);
  return kept.scenario.name == scenario.name && compare_with(kept, scenario).comparison.agrees &&
         !golden_words_fault(place.h5_path);
}

}  // namespace hyrax
