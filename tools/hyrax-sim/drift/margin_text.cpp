#include "tools/hyrax-sim/drift/margin_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "sim/replay/replay.h"

namespace hyrax {
namespace {

// Two digits, never more than the value.
std::string rounded_down(double value) {
  std::string text = fmt::format("{:.17e}", value);
  text.erase(text.find('.') + 2, 16);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return fmt::format("{:g}", rounded);
}

// Air drag brings what a start moves to 2e-9 of itself in 20,000 steps; these are a few more.
constexpr std::int64_t kBlocksUntilStartIsForgotten = 5;

bool has_input_within(const std::vector<Input>& inputs, std::int64_t first_step, std::int64_t end_step) {
  return std::ranges::any_of(
      inputs, [&](const Input& input) { return input.frame >= first_step && input.frame < end_step; });
}

// The rows that can decide the margin. A block that repeats is played until its start is forgotten, and then
// left for the next one: its last row has the same state each time.
void hand_decisive_rows(const StoredRun& run, RowSink& sink) {
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

}  // namespace

bool is_knife_edge(const Margin& margin) {
  constexpr double kKnifeEdge = 1e-9;
  return margin.half_width && *margin.half_width < kKnifeEdge;
}

std::string margin_text(const Margin& margin) {
  if (!margin.half_width || !margin.nearest) return "no start changes the contacts";
  return fmt::format("any start within ±{} px and px/s keeps all contacts; nearest decision: {}, step {}",
                     rounded_down(*margin.half_width),
                     kDecisionNames[static_cast<std::size_t>(margin.nearest->decision)],
                     margin.nearest->step);
}

std::string margin_in_summary(const FreshRun& fresh) {
  const StoredRun& run = fresh.run;
  MarginMeter meter(run.scenario, run.inputs);
  if (run.blocks.empty())
    meter.rows(run.rows);
  else
    hand_decisive_rows(run, meter);
  const Margin margin = meter.margin();
  return margin_text(margin) + (is_knife_edge(margin) ? " (a knife edge)" : "");
}

}  // namespace hyrax
