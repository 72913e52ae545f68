#include "sim/study/needs/needs.h"

#include <array>

#include "sim/cause/watched_core.h"
#include "sim/compare/comparison.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "sim/study/methods/problem.h"
#include "sim/trace/step_program.h"
#include "sim/trajectory/row.h"
#include "sim/trajectory/run_summary.h"

namespace hyrax {
namespace {

struct RunRow {
  ScriptFrame frame;
  double t_s = 0.0;  // At its end.
};

// The rows of a run, and its contacts.
struct Rows {
  std::vector<RunRow> all;
  std::vector<Contact> contacts;

  // @param t_s at the frame's end.
  void add(const ScriptFrame& frame, double t_s) {
    const std::uint8_t before = all.empty() ? std::uint8_t{0} : all.back().frame.contact;
    all.push_back({frame, t_s});
    for (const Wall wall : kWalls)
      if (touches(frame.contact, wall) && !touches(before, wall))
        contacts.push_back({.step = std::ssize(all), .last_step = std::ssize(all), .wall = wall});
  }
  [[nodiscard]] double end_s() const { return all.empty() ? 0.0 : all.back().t_s; }

  // The row of that number if it is at that time, else the last one at it; between two rows the sprite moves
  // straight on. REQUIRES: t_s of at most end_s().
  [[nodiscard]] ScriptFrame at(double t_s, std::size_t index) const {
    if (index < all.size() && all[index].t_s == t_s) return all[index].frame;
    const auto later = std::ranges::upper_bound(all, t_s, {}, &RunRow::t_s);
    if (later == all.end() || (later != all.begin() && std::prev(later)->t_s == t_s))
      return std::prev(later)->frame;
    ScriptFrame frame = later->frame;
    const double part = 1.0 - (later->t_s - t_s) / frame.dt_s;
    frame.to.x_px = frame.from.x_px + part * (frame.to.x_px - frame.from.x_px);
    frame.to.y_px = frame.from.y_px + part * (frame.to.y_px - frame.from.y_px);
    return frame;
  }
  // Number of the row that is nearest to a time.
  [[nodiscard]] std::int64_t step_at(double t_s) const {
    const auto later = std::ranges::lower_bound(all, t_s, {}, &RunRow::t_s);
    const bool is_before =
        later == all.end() || (later != all.begin() && t_s - std::prev(later)->t_s < later->t_s - t_s);
    return later - all.begin() + (is_before ? 0 : 1);
  }
};

template <class PartSet>
Rows play_rows(const Core& core, const Script& script, const PartSet& parts) {
  Rows rows;
  Timeline time;
  play(script, core.constants.value(), parts, [&](const ScriptFrame& frame) {
    time.play(frame.dt_s);
    rows.add(frame, time.time_s());
  });
  return rows;
}

// Of two runs of one length in s, which may have different frames, the contacts of the second where the first
// has rows at these times.
std::vector<Contact> contacts_by_time(const Rows& complete, const Rows& without) {
  std::vector<Contact> contacts = without.contacts;
  for (Contact& contact : contacts) {
    const auto index = static_cast<std::size_t>(contact.step - 1);
    const double t_s = without.all[index].t_s;
    if (index < complete.all.size() && complete.all[index].t_s == t_s) continue;
    contact.step = contact.last_step = complete.step_at(t_s);
  }
  return contacts;
}

// At the times of the complete run's rows.
PathDifference difference_of(const Rows& complete, const Rows& without) {
  PathDifference difference;
  for (std::size_t row = 0; row < complete.all.size(); ++row) {
    const RunRow& a = complete.all[row];
    const ScriptFrame b = without.at(std::min(a.t_s, without.end_s()), row);
    if (a.frame.contact == b.contact && same_bits(a.frame.to, b.to)) {
      difference.end_px = 0.0;
      continue;
    }
    if (difference.is_same_bits) difference.first_step = static_cast<std::int64_t>(row) + 1;
    difference.is_same_bits = false;
    difference.end_px = distance_px(a.frame.to, b.to);
    difference.path_px = std::max(difference.path_px, difference.end_px);
  }
  difference.contacts_moved = contact_changes(complete.contacts, contacts_by_time(complete, without)).total();
  return difference;
}

bool comes_to_rest(const Script& script, const Rows& rows) {
  RestAnchor anchor{script.start.state.x_px, script.start.state.y_px, 0.0};
  for (const RunRow& row : rows.all)
    if (anchor.moves_to(row.frame.to.x_px, row.frame.to.y_px)) anchor.t_s = row.t_s;
  return anchor.at_rest_since_s(rows.end_s()).has_value();
}

std::vector<PartNeed> parts_of(const Script& script) {
  std::vector<PartNeed> parts;
  for (std::size_t part = 0; part < kModelPartCount; ++part)
    parts.push_back({.part = std::string(kModelPartNames[part]), .model_part = static_cast<ModelPart>(part)});
  if (script.is_jittered) parts.push_back({.part = "jitter", .model_part = {}});
  for (std::size_t input = 0; input < script.inputs.size(); ++input)
    parts.push_back({.part = script.inputs[input], .model_part = {}, .input = input});
  return parts;
}

// What leaving out a part saves is the difference of two runs; of different paths it would say more about
// these than about the part. The last one is without all parts that are not needed.
void take_times(const Core& core, ScenarioNeeds& needs, const Script& script, const CostOptions& options,
                const CostMeter& measure_costs) {
  if (needs.steps == 0) return;
  Works works{timed_run(core, script, ModelParts())};
  std::vector<PartNeed*> timed_parts;
  ModelParts needed;
  for (PartNeed& part : needs.parts) {
    if (!part.model_part) continue;
    if (is_unneeded(part.need)) needed.leave_out(*part.model_part);
    if (!part.difference.is_same_bits) continue;
    ModelParts without_it;
    without_it.leave_out(*part.model_part);
    works.push_back(timed_run(core, script, without_it));
    timed_parts.push_back(&part);
  }
  works.push_back(timed_run(core, script, needed));
  const Costs measured = costs_of(measure_costs(works, options));
  const auto steps = static_cast<double>(std::min(needs.steps, kFramesTimedMax));
  const Cost& complete = measured.costs.front();
  const auto per_step = [steps](const Cost& run) {
    const MedianEstimate& ns = run.time_ns;
    return MedianEstimate{ns.median / steps, ns.low / steps, ns.high / steps};
  };
  needs.probe = measured.probe;
  needs.step_ns = per_step(complete);
  needs.unneeded_out_ns = per_step(measured.costs.back());
  for (std::size_t index = 0; index < timed_parts.size(); ++index)
    timed_parts[index]->saved_ns_per_step = difference_of(complete, measured.costs[index + 1], steps).time_ns;
}

// The run without all of these.
PathDifference difference_without(const Core& core, const Script& script, const Rows& complete,
                                  const std::vector<PartNeed*>& left_out) {
  std::vector<bool> inputs(script.inputs.size());
  bool jitter = false;
  ModelParts parts;
  for (const PartNeed* const each : left_out)
    if (each->model_part)
      parts.leave_out(*each->model_part);
    else if (each->input)
      inputs[*each->input] = true;
    else
      jitter = true;
  return difference_of(complete, play_rows(core, without(script, inputs, jitter), parts));
}

// Small differences add up, and one part may replace another. So if leaving out all unneeded parts moves the
// path by more than the tolerance, they are left out one by one, the smallest difference first, and one that
// moves the path too far is put back.
void leave_out_unneeded(const Core& core, ScenarioNeeds& needs, const Script& script, const Rows& complete,
                        double within_px) {
  std::vector<PartNeed*> unneeded;
  for (PartNeed& part : needs.parts)
    if (is_unneeded(part.need)) unneeded.push_back(&part);
  needs.without_all_unneeded = difference_without(core, script, complete, unneeded);
  if (needs.without_all_unneeded.path_px <= within_px) return;
  std::ranges::stable_sort(unneeded, {}, [](const PartNeed* part) { return part->difference.path_px; });
  std::vector<PartNeed*> left_out;
  for (PartNeed* const part : unneeded) {
    left_out.push_back(part);
    if (difference_without(core, script, complete, left_out).path_px <= within_px) continue;
    left_out.pop_back();
    part->need = Need::needed_jointly;
  }
  needs.without_all_unneeded = difference_without(core, script, complete, left_out);
}

void count_paths(const Core& core, ScenarioNeeds& needs, const Scenario& scenario,
                 const std::shared_ptr<const StepProgram>& step) {
  const auto note = [&](const StepInput& input, std::span<TracedBody> bodies) {
    bodies.front().update(input);
    needs.paths_taken.insert(bodies.front().path());
  };
  Replay run(watched(core, {step}, note), scenario);
  run.play_to(needs.steps);
  static_cast<void>(run.finish());
}

void find_methods(const Core& core, ScenarioNeeds& needs, const Scenario& scenario,
                  const NeedsOptions& options, const CostMeter& measure_costs) {
  const ScenarioProblem made = problem_of(scenario);
  needs.why_no_methods = made.why_not;
  if (!made.problem) return;
  const SpeedErrorOptions speed{
      .rates_hz = options.rates_hz, .cost = options.cost, .errors_asked_px = {options.within_px}};
  needs.methods = study_speed_error(core, {*made.problem}, frame_methods(core), speed, measure_costs);
}

}  // namespace

std::string_view name_of(Need need) {
  constexpr std::array<std::string_view, 4> kNames = {"needed", "needed with others left out",
                                                      "below the tolerance", "not exercised"};
  return kNames[static_cast<std::size_t>(need)];
}

Need need_of(const PathDifference& difference, double within_px) {
  if (difference.is_same_bits) return Need::not_exercised;
  return difference.path_px <= within_px ? Need::below : Need::needed;
}

ScenarioNeeds study_needs(const Core& core, const Scenario& scenario, const NeedsOptions& options,
                          const CostMeter& measure_costs) {
  const Script script = script_of(scenario);
  const Rows complete = play_rows(core, script, AllParts());
  ScenarioNeeds needs;
  needs.scenario = scenario.name;
  needs.steps = static_cast<std::int64_t>(script.frames_s.size());
  needs.is_cut = script.is_cut;
  needs.comes_to_rest = comes_to_rest(script, complete);
  needs.parts = parts_of(script);
  for (PartNeed& part : needs.parts) {
    part.difference = difference_without(core, script, complete, {&part});
    part.need = need_of(part.difference, options.within_px);
  }
  leave_out_unneeded(core, needs, script, complete, options.within_px);
  if (options.core_step) count_paths(core, needs, scenario, options.core_step);
  take_times(core, needs, script, options.cost, measure_costs);
  if (!options.rates_hz.empty()) find_methods(core, needs, scenario, options, measure_costs);
  return needs;
}

}  // namespace hyrax
