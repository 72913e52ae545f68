#include "sim/ensemble/ensemble.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/core/listing_core.h"
#include "sim/ensemble/lane_player.h"
#include "sim/scenario/apply.h"
#include "sim/scenario/schedule.h"

namespace hyrax {
namespace {

bool is_in_trace(const VariedKey& key) { return key.pointer.starts_with("/clock/dt_s/"); }

bool is_parameter(const VariedKey& key) { return key.pointer.starts_with("/parameters/"); }

// The kernels keep no rows, so they cannot hash them; and they have one trace and one set of constants for
// all members.
bool needs_replay(const Sweep& sweep) {
  return sweep.keep.has(Keep::state_hash) || std::ranges::any_of(sweep.vary, is_in_trace) ||
         std::ranges::any_of(sweep.vary, is_parameter);
}

Detail detail_of(const KeepSet& keep) {
  if (keep.has(Keep::extremes)) return Detail::extremes;
  return keep.has(Keep::contacts) || keep.has(Keep::at_rest) ? Detail::tracked : Detail::final;
}

LaneClock lane_clock(const Clock& clock) {
  if (std::holds_alternative<RecordedSteps>(clock.base)) return LaneClock::trace;
  constexpr std::array kJittered = {LaneClock::uniform, LaneClock::normal, LaneClock::missed_frames};
  return clock.jitter ? kJittered[static_cast<std::size_t>(clock.jitter->kind)] : LaneClock::fixed;
}

bool has_timing_keys(const Sweep& sweep) {
  Scenario base = sweep.base;
  return std::ranges::any_of(sweep.vary,
                             [&](const VariedKey& key) { return number_at(base, key.pointer)->is_timing; });
}

}  // namespace

// Members that are played together. All have the same events, with numbers and frames of their own: they go
// from event to event.
class EnsemblePlayer::Batch {
 public:
  Batch(const Sweep& sweep, const KernelSet& kernels, const Constants& constants)
      : player_(kernels, constants, detail_of(sweep.keep)),
        sweep_(sweep),
        scenarios_(sweep),
        clock_(lane_clock(sweep.base.clock)),
        detail_(detail_of(sweep.keep)),
        has_own_frames_(has_timing_keys(sweep)) {
    if (const auto* const trace = std::get_if<RecordedSteps>(&sweep.base.clock.base))
      trace_ = trace->dt_s.data();
    if (!has_own_frames_) event_frames_ = frames_of(sweep.base, step_count(sweep.base));
  }

  StepTally play(const WorkPart& part, std::int64_t first_row, std::span<MemberResult> results) {
    load(part, first_row, results);
    StepTally tally;
    const std::size_t events = sweep_.base.events.size();
    for (std::size_t event = 0; event < events; ++event) {
      tally += play_to_event(event);
      for (std::size_t member = 0; member < members_.size(); ++member)
        apply_event(members_[member], actions_[member * events + event]);
    }
    tally += play_to_event(events);
    for (const MovingMember& member : members_) store(member);
    return tally;
  }

 private:
  static std::vector<std::int64_t> frames_of(const Scenario& scenario, std::int64_t steps) {
    return scenario.events.empty() ? std::vector<std::int64_t>{} : schedule_events(scenario, steps).frames;
  }

  void load(const WorkPart& part, std::int64_t first_row, std::span<MemberResult> results) {
    members_.resize(results.size());
    actions_.clear();
    if (has_own_frames_) event_frames_.clear();
    for (std::size_t row = 0; row < results.size(); ++row) {
      members_[row].result = &results[row];
      load(scenarios_.scenario(part.member(first_row + static_cast<std::int64_t>(row))), members_[row]);
    }
  }

  // Sets every field: members are reused.
  void load(const Scenario& scenario, MovingMember& member) {
    member.world = {start_state(scenario), scenario.window, scenario.sprite};
    member.frame = 0;
    member.steps = step_count(scenario);
    if (clock_ != LaneClock::trace) member.base_dt_s = base_dt_s(scenario.clock);
    if (scenario.clock.jitter) member.jitter = *scenario.clock.jitter;
    member.hitch_dt_s.reset();
    member.walls = 0;
    member.timeline = {};
    member.rest = {scenario.start.x_px, scenario.start.y_px, 0.0};
    member.result->contacts = {};
    member.result->begin_extremes(member.world.state);
    for (const Event& event : scenario.events) actions_.push_back(event.action);
    if (!has_own_frames_) return;
    const std::vector<std::int64_t> frames = frames_of(scenario, member.steps);
    event_frames_.insert(event_frames_.end(), frames.begin(), frames.end());
  }

  [[nodiscard]] std::int64_t end_frame(std::size_t member, std::size_t event) const {
    const std::size_t events = sweep_.base.events.size();
    if (event == events) return members_[member].steps;
    return event_frames_[has_own_frames_ ? member * events + event : event];
  }

  // All members up to the frame of an event, or to their ends.
  StepTally play_to_event(std::size_t event) {
    if (!members_.empty() && members_.front().world.is_held) return hold_to_event(event);
    legs_.clear();
    for (std::size_t index = 0; index < members_.size(); ++index) {
      MovingMember& member = members_[index];
      if (!member.hitch_dt_s || member.frame == end_frame(index, event)) continue;
      legs_.push_back({&member, *member.hitch_dt_s, 1});
      member.hitch_dt_s.reset();
    }
    StepTally tally = player_.play(legs_, LaneClock::fixed, nullptr);
    legs_.clear();
    for (std::size_t index = 0; index < members_.size(); ++index)
      if (const std::int64_t frames = end_frame(index, event) - members_[index].frame; frames > 0)
        legs_.push_back({&members_[index], members_[index].base_dt_s, frames});
    return tally += player_.play(legs_, clock_, trace_);
  }

  // Frames pass, no update, contact 0.
  StepTally hold_to_event(std::size_t event) {
    StepTally tally;
    for (std::size_t index = 0; index < members_.size(); ++index) {
      const std::int64_t frames = end_frame(index, event) - members_[index].frame;
      if (frames > 0) hold(members_[index], frames);
      tally += {frames, frames};
    }
    return tally;
  }

  void hold(MovingMember& member, std::int64_t frames) const {
    member.walls = 0;
    member.result->include(member.world.state);
    bool moves = member.rest.moves_to(member.world.state.x_px, member.world.state.y_px);
    for (const std::int64_t end = member.frame + frames; member.frame < end;) {
      const bool is_even = clock_ == LaneClock::fixed && !member.hitch_dt_s;
      const std::int64_t count = is_even ? end - member.frame : 1;
      member.timeline.play(member.hitch_dt_s ? *member.hitch_dt_s : next_dt_s(member), count);
      member.hitch_dt_s.reset();
      member.frame += count;
      if (std::exchange(moves, false)) member.rest.t_s = member.timeline.time_s(1 - count);
    }
  }

  [[nodiscard]] double next_dt_s(const MovingMember& member) const {
    if (clock_ == LaneClock::trace) return trace_[member.frame];
    return clock_ == LaneClock::fixed ? member.base_dt_s
                                      : jittered_dt_s(member.base_dt_s, member.jitter, member.frame);
  }

  static void apply_event(MovingMember& member, const Action& action) {
    apply(action, member.world);
    if (const auto* const hitch = std::get_if<Hitch>(&action)) member.hitch_dt_s = hitch->dt_s;
  }

  void store(const MovingMember& member) const {
    MemberResult& result = *member.result;
    result.final = member.world.state;
    if (detail_ == Detail::final) return;
    result.speed_max_px_per_s = std::sqrt(result.speed_max_px_per_s);
    const auto since_s = member.rest.at_rest_since_s(member.timeline.time_s());
    result.at_rest_since_s = since_s.value_or(std::numeric_limits<double>::quiet_NaN());
  }

  LanePlayer player_;
  const Sweep& sweep_;
  SweepMembers scenarios_;
  LaneClock clock_;
  Detail detail_;
  bool has_own_frames_;
  const double* trace_ = nullptr;
  std::vector<MovingMember> members_;
  std::vector<Action> actions_;             // Of a member after the other.
  std::vector<std::int64_t> event_frames_;  // Of all members alike, or of a member after the other.
  std::vector<Leg> legs_;
};

EnsemblePlayer::EnsemblePlayer(const Core& core, const Sweep& sweep, const KernelSet* kernels)
    : core_(with_parameters(core, sweep.base.parameters).value()), sweep_(sweep) {
  if (!core_.paper_match.constants || needs_replay(sweep)) return;
  if (kernels == nullptr) kernels = &kernel_sets().front();
  batch_ = std::make_unique<Batch>(sweep, *kernels, *core_.paper_match.constants);
}
EnsemblePlayer::~EnsemblePlayer() = default;

StepTally EnsemblePlayer::play(const WorkPart& part, std::int64_t first_row,
                               std::span<MemberResult> results) {
  StepTally tally;
  if (!batch_) {
    SweepMembers members(sweep_);
    for (MemberResult& result : results) {
      const Scenario& scenario = members.scenario(part.member(first_row++));
      tally +=
          play_member(with_parameters(core_, scenario.parameters).value(), scenario, sweep_.keep, result);
    }
    return tally;
  }
  constexpr std::size_t kBatch = 1024;  // Stays in the second-level cache.
  for (std::size_t first = 0; first < results.size(); first += kBatch) {
    const auto part_of_results = results.subspan(first, std::min(kBatch, results.size() - first));
    tally += batch_->play(part, first_row + static_cast<std::int64_t>(first), part_of_results);
  }
  return tally;
}

}  // namespace hyrax
