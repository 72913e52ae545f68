#include "sim/cause/run_match.h"

#include <algorithm>

#include "sim/compare/comparison.h"
#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/apply.h"

namespace hyrax {
namespace {

constexpr auto kRows = static_cast<std::int64_t>(kBlockRows);

// Compares a replay with a run, by rows or by blocks, until one differs.
class RunMatcher final : public ContactRecorder {
 public:
  explicit RunMatcher(const StoredRun& run) : run_(run) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = run_.blocks.empty() ? 1 : 0, .contacts = true, .blocks = !run_.blocks.empty()};
  }
  void row(const Row& played) override {
    if (!match_.rows) return;
    const Row stored = at_ < run_.rows.size() ? run_.rows.row(at_) : Row{.step = -1};
    match_.rows = stored.step == played.step && same_bits(state_of(stored), state_of(played)) &&
                  same_bits(stored.dt_s, played.dt_s) && stored.contact == played.contact;
    match_.times &= same_bits(stored.t_s, played.t_s);
    ++at_;
  }
  void block(const Block& block, std::int64_t count) override {
    while (count > 0 && match_.rows) {
      match_.rows = at_ < run_.blocks.size() && run_.blocks[at_].digest == block.digest;
      if (!match_.rows) return;
      if (used_ == 0) match_.times &= same_bits(run_.blocks[at_].keyframe.row.t_s, block.keyframe.row.t_s);
      const std::int64_t both = std::min(count, run_.blocks[at_].count - used_);
      count -= both;
      used_ += both;
      if (used_ < run_.blocks[at_].count) return;
      ++at_;
      used_ = 0;
    }
  }

  [[nodiscard]] bool differs() const { return !match_.rows; }
  RunMatch finish(const RunSummary& summary) {
    match_.rows &= summary.steps == run_.steps && hex(summary.state_hash) == run_.state_hash;
    match_.times &= same_bits(summary.final.t_s, run_.final.t_s);
    std::size_t next = 0;
    run_.each_contact([&](const Contact& contact) {
      match_.contacts &= next < contacts().size() && is_same(contact, contacts()[next]);
      ++next;
    });
    match_.contacts &= next == contacts().size() && summary.contacts.total() == run_.contacts_total;
    return match_;
  }

 private:
  static bool is_same(const Contact& a, const Contact& b) {
    return has_same_steps(a, b) &&
           std::ranges::all_of(kContactQuantities,
                               [&](const ContactColumn& quantity) { return agrees(quantity, a, b); });
  }

  const StoredRun& run_;
  std::size_t at_ = 0;     // The row, or the block, that comes next,
  std::int64_t used_ = 0;  // and how many repetitions of the block there were.
  RunMatch match_{true, true, true};
};

// Hitches and resizes leave position and velocity as they are.
bool sets_state(const Action& action) {
  return !std::holds_alternative<Hitch>(action) && !std::holds_alternative<Resize>(action);
}

// What the rows from `first` on show. @param world that of the row before.
std::vector<ObservedStep> steps_of(const Columns& rows, std::size_t first, const std::vector<Input>& inputs,
                                   World world) {
  std::vector<ObservedStep> steps;
  for (std::size_t index = first; index < rows.size(); ++index) {
    const Row row = rows.row(index);
    bool follows_input = false;
    const std::int64_t frame = row.step - 1;
    for (auto input = std::ranges::lower_bound(inputs, frame, {}, &Input::frame);
         input != inputs.end() && input->frame == frame; ++input) {
      apply(input->action, world);
      follows_input |= sets_state(input->action);
    }
    if (!world.is_held) steps.push_back({row.step, follows_input, world, row.dt_s, state_of(row)});
    world.state = state_of(row);
  }
  return steps;
}

// The number of the first block, counting repetitions, that is not the same in both.
std::int64_t first_block_that_differs(const std::vector<StoredBlock>& a, const std::vector<StoredBlock>& b) {
  std::int64_t same = 0;
  std::int64_t left_a = 0, left_b = 0;
  for (std::size_t at_a = 0, at_b = 0; at_a < a.size() && at_b < b.size();) {
    if (a[at_a].digest != b[at_b].digest) break;
    if (left_a == 0) left_a = a[at_a].count;
    if (left_b == 0) left_b = b[at_b].count;
    const std::int64_t both = std::min(left_a, left_b);
    same += both;
    if ((left_a -= both) == 0) ++at_a;
    if ((left_b -= both) == 0) ++at_b;
  }
  return same;
}

// The keyframe of block `number`, counting repetitions. REQUIRES: the run has blocks.
Keyframe keyframe_of_block(const std::vector<StoredBlock>& blocks, std::int64_t number) {
  std::int64_t first = 0;
  for (const StoredBlock& block : blocks) {
    if (number < first + block.count || &block == &blocks.back()) {
      Keyframe keyframe = block.keyframe;
      keyframe.row.step += (number - first) * kRows;
      keyframe.timeline.frames += (number - first) * kRows;
      return keyframe;
    }
    first += block.count;
  }
  return {};
}

std::vector<ObservedStep> steps_of_blocks(const StoredRun& run, const StoredRun& other, const Core& core) {
  const std::int64_t differing = first_block_that_differs(run.blocks, other.blocks);
  const Keyframe from = keyframe_of_block(run.blocks, std::max<std::int64_t>(0, differing - 1));
  RunRecorder recorder(0);  // Of all rows.
  Replay replay(core, run.scenario, from, recorder);
  replay.play_to(std::min({run.steps, replay.steps(), from.row.step + 2 * kRows - 1}));
  static_cast<void>(replay.finish());
  return steps_of(recorder.take().rows, 0, run.inputs,
                  {state_of(from.row), from.window, from.sprite, from.is_held});
}

}  // namespace

Scenario playback_of(const StoredRun& golden) {
  Scenario playback = golden.scenario;
  playback.events.clear();
  for (const Input& input : golden.inputs)
    if (!std::holds_alternative<Hitch>(input.action)) playback.events.push_back({input.frame, input.action});
  playback.clock = {RecordedSteps{{golden.rows.dt_s.begin() + 1, golden.rows.dt_s.end()}}, {}};
  playback.length = std::monostate();
  return playback;
}

RunMatch match(const Core& core, const Scenario& scenario, const StoredRun& run) {
  const std::optional<Core> played = with_parameters(core, scenario.parameters);
  if (!played) return {};
  RunMatcher matcher(run);
  Replay replay(*played, scenario, matcher);
  if (replay.steps() < run.steps) return {};
  std::int64_t piece = 16 * kRows;
  for (std::int64_t at = -1; at < run.steps && !matcher.differs(); piece *= 2) {
    if (replay.keyframe().row.step == at) break;  // The state is not finite any more.
    at = replay.keyframe().row.step;
    replay.play_to(std::min(run.steps, at + piece));
  }
  if (matcher.differs()) return {};
  return matcher.finish(replay.finish());
}

std::vector<ObservedStep> observed_steps(const StoredRun& run, const StoredRun& other, const Core& core) {
  if (!run.blocks.empty()) return steps_of_blocks(run, other, core);
  if (run.rows.size() == 0) return {};
  return steps_of(run.rows, 1, run.inputs,
                  {state_of(run.rows.row(0)), run.scenario.window, run.scenario.sprite});
}

bool gives(const Core& core, const ObservedStep& observed) {
  const auto& [state, window, sprite, is_held] = observed.before;
  const Stretch stretch{.window = window, .sprite = sprite, .dt_s = &observed.dt_s, .frames = 1};
  CoreBody after{state};
  RestAnchor rest;
  RowBlock rows;
  StretchLog log;
  core.stepper->play(stretch, after, rest, rows, log);
  return same_bits(after.state, observed.after);
}

}  // namespace hyrax
