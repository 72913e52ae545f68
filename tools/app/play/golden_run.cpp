#include "tools/app/play/play.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <optional>

#include "sim/compare/run_comparer.h"
#include "sim/core/contact_stepper.h"
#include "sim/core/listing_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/trajectory/input_playback.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/scenario_changes.h"

namespace hyrax {
namespace {

// Keeps the rows of the first block.
class BlockSink : public RowSink {
 public:
  explicit BlockSink(RowBlock& rows) : rows_(rows) {}
  [[nodiscard]] Wants wants() const override { return {.blocks = true}; }
  void block(const Block& block, std::int64_t) override {
    if (rows_.size() == 0) rows_.append(block.rows, 0, block.rows.size());
  }

 private:
  RowBlock& rows_;
};

constexpr std::size_t kContactsHeldMax = 1 << 16;

// Keeps all contacts up to a limit; beyond it, only the last step of each.
class FreshRecorder final : public RunRecorder {
 public:
  using RunRecorder::RunRecorder;
  void contact_began(const Contact& contact) override {
    last_steps_.push_back(contact.step);
    if (last_steps_.size() <= kContactsHeldMax) RunRecorder::contact_began(contact);
  }
  void contact_ended(std::int64_t index, std::int64_t last_step) override {
    last_steps_[static_cast<std::size_t>(index)] = last_step;
    if (static_cast<std::size_t>(index) < kContactsHeldMax) RunRecorder::contact_ended(index, last_step);
  }
  [[nodiscard]] bool holds_all() const { return last_steps_.size() <= kContactsHeldMax; }
  [[nodiscard]] std::vector<std::int64_t> take_last_steps() { return std::move(last_steps_); }

 private:
  std::vector<std::int64_t> last_steps_;
};

// Sends the contacts of a run that was played before, each with its last step.
class ContactSink final : public RowSink {
 public:
  ContactSink(const std::vector<std::int64_t>& last_steps, const std::function<void(const Contact&)>& take)
      : last_steps_(last_steps), take_(take) {}
  [[nodiscard]] Wants wants() const override { return {.contacts = true}; }
  void contact_began(const Contact& contact) override {
    Contact complete = contact;
    complete.last_step = last_steps_[next_++];
    take_(complete);
  }

 private:
  const std::vector<std::int64_t>& last_steps_;
  const std::function<void(const Contact&)>& take_;
  std::size_t next_ = 0;
};

// Replays a stored block from its keyframe, by the first core that gives its digest.
RowBlock expand(const std::vector<Core>& cores, const Scenario& scenario, const StoredBlock& kept) {
  const std::int64_t end_step = kept.keyframe.row.step + static_cast<std::int64_t>(kBlockRows) - 1;
  RowBlock rows;
  for (const Core& core : cores) {
    rows.shrink(0);
    BlockSink sink(rows);
    Replay replay(core, scenario, kept.keyframe, sink);
    replay.play_to(std::min(replay.steps(), end_step));
    static_cast<void>(replay.finish());
    if (digest(rows) == kept.digest) break;
  }
  return rows;
}

// A core that gives the stored run again, and what it comes to; nothing where none does.
struct RestoredRun {
  const Core* core = nullptr;
  RunSummary summary = {};
};
RestoredRun restored(const std::vector<Core>& cores, const StoredRun& kept, std::int64_t steps_played) {
  if (step_count(kept.scenario) <= std::max(steps_played, kRowsPlayedMax))
    for (const Core& core : cores)
      if (const RunSummary summary = replay(core, kept.scenario); hex(summary.state_hash) == kept.state_hash)
        return {&core, summary};
  return {};
}

// Since when a run has settled, in s. REQUIRES: every row of it, from row 0.
std::optional<double> at_rest_since_s(const Columns& rows) {
  assert(rows.size() > 0);
  RestAnchor anchor{rows.x_px.front(), rows.y_px.front(), rows.t_s.front()};
  for (std::size_t index = 1; index < rows.size(); ++index)
    if (anchor.moves_to(rows.x_px[index], rows.y_px[index])) anchor.t_s = rows.t_s[index];
  return anchor.at_rest_since_s(rows.t_s.back());
}

void add_contacts(ContactChanges changes, Comparison& comparison) {
  if (changes.is_none()) return;
  ContactChanges& all = comparison.contacts;
  std::ranges::move(changes.moved, std::back_inserter(all.moved));
  std::ranges::move(changes.only_a, std::back_inserter(all.only_a));
  std::ranges::move(changes.only_b, std::back_inserter(all.only_b));
  all.is_cut |= changes.is_cut;
  comparison.difference = std::max(*comparison.difference, DifferenceClass::contacts);
}

// What a comparison by rows and blocks does not say.
// @param other_walls whose contacts have other sources in the two runs: they are compared by rows.
void measure_whole(const Core& core, const StoredRun& kept, const Scenario& scenario,
                   const std::vector<Core>& restoring, std::uint8_t other_walls, Comparison& comparison) {
  RestoredRun whole;
  if (!kept.blocks.empty()) whole = restored(restoring, kept, step_count(scenario));
  RunEnd& end = comparison.expected_end;
  end.is_rest_known = kept.blocks.empty() || whole.core != nullptr;
  end.settled_since_s = kept.blocks.empty() ? at_rest_since_s(kept.rows) : whole.summary.at_rest_since_s;
  Distance& distance = comparison.distance;
  if (!distance.is_at_equal_times && other_walls == 0) return;
  if (!end.is_rest_known) {
    if (!distance.is_at_equal_times) return;
    distance.largest.reset();
    distance.has_unknown_rows = true;
    return;
  }
  const auto expected = [&]() -> TimedRun {
    return {whole.core != nullptr ? played_rows(*whole.core, kept.scenario) : batches_of(kept.rows),
            kept.inputs};
  };
  const auto actual = [&]() -> TimedRun {
    return {played_rows(core, scenario), inputs_of(scenario, step_count(scenario))};
  };
  if (other_walls != 0)
    add_contacts(contact_changes(contacts_by_rows(expected(), kept.scenario, other_walls),
                                 contacts_by_rows(actual(), scenario, other_walls)),
                 comparison);
  if (!distance.is_at_equal_times) return;
  distance = walk_equal_times(expected(), actual());
  if (std::min(kept.steps, step_count(scenario)) > kRowsPlayedMax) distance.rows_max = kRowsPlayedMax;
}

}  // namespace

ComparedRun compare_with(const Core& core, const StoredRun& kept, const Scenario& scenario,
                         std::vector<Core> restoring) {
  restoring.push_back(core);
  const auto other_walls = static_cast<std::uint8_t>(kept.walls_of_rows ^ core.walls_of_rows);
  RunComparer comparer(
      kept, [&](const StoredBlock& block) { return expand(restoring, kept.scenario, block); }, other_walls);
  const RunSummary summary = replay(core, scenario, comparer, judged_options(scenario));
  ComparedRun compared{comparer.finish(scenario, core.name, summary), summary};
  if (const std::string changes = scenario_changes(kept.scenario, scenario); !changes.empty())
    compared.comparison.shape += ": " + changes;
  if (compared.comparison.agrees)
    compared.comparison.expected_end = compared.comparison.actual_end;
  else
    measure_whole(core, kept, scenario, restoring, other_walls, compared.comparison);
  return compared;
}

bool gives_its_rows(const Core& core, const StoredRun& kept) {
  const std::optional<Core> played = with_parameters(core, kept.scenario.parameters);
  return played && kept.steps <= kRowsPlayedMax && step_count(kept.scenario) == kept.steps &&
         compare_with(*played, kept, kept.scenario).comparison.agrees;
}

std::vector<Contact> contacts_by_rows(const TimedRun& run, const Scenario& scenario, std::uint8_t walls) {
  InputPlayback playback(scenario, run.inputs);
  std::vector<Contact> contacts;
  PerWall<std::size_t> latest{};
  std::uint8_t contact_before = 0;
  std::optional<Row> from;
  for (RowCursor cursor(run.rows); !cursor.is_done(); cursor.next()) {
    const Row row = cursor.row();
    std::uint8_t contact = 0;
    if (from && !playback.is_held())
      contact = contact_of_rows(playback.bounds(), state_of(*from), row.dt_s, state_of(row));
    for (const Wall wall : kWalls) {
      if (!touches(contact, wall) || !touches(walls, wall)) continue;
      if (!touches(contact_before, wall)) {
        if (std::ssize(contacts) == kContactsRecordedMax) return contacts;
        latest[wall] = contacts.size();
        contacts.push_back({.step = row.step, .wall = wall, .t_s = row.t_s});
      }
      contacts[latest[wall]].last_step = row.step;
    }
    contact_before = contact;
    from = row;
    playback.apply(*from);
  }
  return contacts;
}

FreshRun play_for_golden(const Core& core, const Scenario& scenario, const Core& recording) {
  FreshRecorder recorder(step_count(scenario));
  const RunSummary summary = replay(recording, scenario, recorder, judged_options(scenario));
  StoredRun run = recorder.take();
  if (!recorder.holds_all()) {
    run.contacts = {};
    run.replay_contacts = [core, scenario, last_steps = recorder.take_last_steps()](const auto& take) {
      ContactSink sink(last_steps, take);
      static_cast<void>(replay(core, scenario, sink, judged_options(scenario)));
    };
  }
  run.scenario = scenario;
  run.physics = core.name;
  run.constants = core.constants;
  run.core = core.record.checksum();
  run.walls_of_rows = core.walls_of_rows;
  run.steps = summary.steps;
  run.state_hash = hex(summary.state_hash);
  run.final = summary.final;
  run.contacts_total = summary.contacts.total();
  run.inputs = inputs_of(scenario, summary.steps);
  return {std::move(run), summary};
}

}  // namespace hyrax
