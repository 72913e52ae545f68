#include "sim/card/core_run.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"

namespace hyrax {
namespace {

// Keeps rows up to the end of the first period, if the run repeats itself, and hashes all of them.
class RowCollector final : public RowSink {
 public:
  explicit RowCollector(CoreRun& run) : run_(run) {}

  [[nodiscard]] Wants wants() const override { return {.rows_every = is_complete() ? 0 : 1, .blocks = true}; }
  void row(const Row& row) override {
    const bool is_last = row.step != std::ssize(run_.rows);
    if (!is_last && !is_complete()) run_.rows.push_back(row);
  }
  void repeats(const Repetition& repetition) override { run_.repetition = repetition; }
  void block(const Block& block, std::int64_t count) override {
    states_.shrink(0);
    states_.append(block.rows, 0, block.rows.size());
    for (std::size_t index = 0; index < states_.size(); ++index) states_.set_contact(index, 0);
    hash_.add(digest(states_), count);
  }

  [[nodiscard]] Digest hash() const { return hash_.value(); }

  // Whether the rows have all of the first period.
  [[nodiscard]] bool has_period() const {
    return run_.repetition &&
           std::ssize(run_.rows) > run_.repetition->from_step + run_.repetition->period_steps;
  }

 private:
  [[nodiscard]] bool is_complete() const { return has_period() || std::ssize(run_.rows) >= kCoreRunRowsMax; }

  CoreRun& run_;
  RowBlock states_;
  StateHash hash_;
};

// Rows that both runs must have so that none that differs is missed: of two that repeat, both periods.
std::size_t common_length(const CoreRun& base, const CoreRun& candidate, std::int64_t rows_of_run) {
  std::size_t length = std::max(base.rows.size(), candidate.rows.size());
  if (base.repetition && candidate.repetition) {
    const std::int64_t both = std::max(base.repetition->from_step, candidate.repetition->from_step) +
                              std::lcm(base.repetition->period_steps, candidate.repetition->period_steps) + 1;
    length = std::max(length, static_cast<std::size_t>(std::min(both, kCoreRunRowsMax)));
  }
  return std::min(length, static_cast<std::size_t>(rows_of_run));
}

// The scenario with kPlayedOn_s more of its last frame; nothing where that adds no time, or too many frames.
std::optional<Scenario> played_on(const Scenario& scenario) {
  Scenario longer = scenario;
  const std::int64_t steps = step_count(scenario);
  auto* const recorded = std::get_if<RecordedSteps>(&longer.clock.base);
  const double dt_s = recorded != nullptr ? recorded->dt_s.back() : base_dt_s(scenario.clock);
  const double frames = std::ceil(kPlayedOn_s / dt_s);
  if (!(frames + static_cast<double>(steps) <= static_cast<double>(kCoreRunStepsMax))) return std::nullopt;
  if (recorded != nullptr)
    recorded->dt_s.insert(recorded->dt_s.end(), static_cast<std::size_t>(frames), dt_s);
  else
    longer.length = steps + static_cast<std::int64_t>(frames);
  return longer;
}

// Walls, first and last steps of the contacts that the rows' contact bytes tell.
std::vector<Contact> contacts_of(const std::vector<Row>& rows) {
  std::vector<Contact> contacts;
  std::array<std::size_t, kWalls.size()> open{};  // Index of the wall's latest contact.
  for (std::size_t index = 1; index < rows.size(); ++index)
    for (const Wall wall : kWalls) {
      if (!touches(rows[index].contact, wall)) continue;
      const std::int64_t step = rows[index].step;
      if (touches(rows[index - 1].contact, wall)) {
        contacts[open[wall_index(wall)]].last_step = step;
        continue;
      }
      open[wall_index(wall)] = contacts.size();
      contacts.push_back({.step = step, .last_step = step, .wall = wall});
    }
  return contacts;
}

}  // namespace

void CoreRun::extend(std::size_t length) {
  assert(repetition || rows.size() >= length);
  while (rows.size() < length) {
    Row row = rows[rows.size() - static_cast<std::size_t>(repetition->period_steps)];
    row.step = std::ssize(rows);
    row.t_s = rows.back().t_s + row.dt_s;
    rows.push_back(row);
  }
}

CoreRun play_by(const Core& core, const Scenario& scenario) {
  CoreRun run;
  RowCollector collector(run);
  Replay replay(core, scenario, collector);
  replay.play_to(std::min(replay.steps(), kCoreRunStepsMax));
  const RunSummary summary = replay.finish();
  run.final = summary.final;
  run.at_rest_since_s = summary.at_rest_since_s;
  run.is_finite = !summary.non_finite_step;
  run.hash = collector.hash();
  if (!collector.has_period()) run.repetition.reset();  // It begins past the last row that is kept.
  run.is_cut = !run.repetition && (summary.final.step >= std::ssize(run.rows) ||
                                   (run.is_finite && summary.final.step < step_count(scenario)));
  return run;
}

bool settles(const Core& core, const Scenario& scenario, const CoreRun& run) {
  if (run.at_rest_since_s || !run.is_finite) return run.at_rest_since_s.has_value();
  const std::optional<Scenario> longer = played_on(scenario);
  return longer && replay(core, *longer).at_rest_since_s;
}

RunChange compare_runs(const Scenario& scenario, CoreRun& base, CoreRun& candidate) {
  const std::size_t length = common_length(base, candidate, step_count(scenario) + 1);
  for (CoreRun* const run : {&base, &candidate})
    if (run->repetition) run->extend(length);
  RunChange change{.became_non_finite = base.is_finite && !candidate.is_finite};
  const std::vector<Contact> before = contacts_of(base.rows);
  const std::vector<Contact> after = contacts_of(candidate.rows);
  change.contacts_before = std::ssize(before);
  change.contacts_after = std::ssize(after);
  change.contacts = contact_changes(before, after);
  RunDistance distance;
  const std::size_t rows = std::min(base.rows.size(), candidate.rows.size());
  for (std::size_t index = 0; index < rows; ++index) {
    const Row& from = base.rows[index];
    Row to = candidate.rows[index];
    to.t_s = from.t_s;  // The scenario's, not the core's.
    distance.add(from, to);
    if (!same_bits(state_of(from), state_of(to))) change.has_same_bits = false;
  }
  const bool has_other_length = base.final.step != candidate.final.step;
  if (base.is_cut || candidate.is_cut) {
    const bool is_known = !has_other_length && base.final.step == step_count(scenario);
    if (is_known && base.hash != candidate.hash) change.has_same_bits = false;
    change.is_cut = !is_known || !change.has_same_bits;
  }
  if (has_other_length) change.has_same_bits = false;
  if (!change.has_same_bits)
    change.difference = has_other_length ? DifferenceClass::shape : class_of(change.contacts, distance);
  change.largest = distance.largest();
  change.end_shift_px = distance_px(state_of(base.final), state_of(candidate.final));
  return change;
}

}  // namespace hyrax
