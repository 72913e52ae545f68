#include "sim/search/run_check.h"

#include <algorithm>

#include "sim/replay/replay.h"
#include "sim/scenario/apply.h"
#include "sim/scenario/frame_clock.h"
#include "sim/scenario/schedule.h"
#include "sim/search/step_watch.h"

namespace hyrax {
namespace {

// Takes the digest of the rows that pass.
class DigestSink : public RowSink {
 public:
  [[nodiscard]] Wants wants() const override { return {.rows_every = 1}; }
  void row(const Row& row) override { hash_.add(row); }
  [[nodiscard]] Digest finish() { return hash_.value(); }

 private:
  StateHash hash_;
};

Digest resumed_digest(const Core& core, const Scenario& scenario, std::span<const std::int64_t> stops) {
  DigestSink sink;
  std::optional<Replay> run(std::in_place, core, scenario, sink);
  for (const std::int64_t stop : stops) {
    run->play_to(stop);
    const Keyframe stopped = run->keyframe();
    run->finish();
    run.emplace(core, scenario, stopped, sink);
  }
  run->play_to(run->steps());
  run->finish();
  return sink.finish();
}

bool is_ever_wider_than_window(const Scenario& scenario) {
  World world{.state = {}, .window = scenario.window, .sprite = scenario.sprite};
  bool is_wider = world.bounds().right_px < 0.0;
  for (const Event& event : scenario.events) {
    apply(event.action, world);
    is_wider |= world.bounds().right_px < 0.0;
  }
  return is_wider;
}

}  // namespace

std::vector<std::int64_t> usual_stops(const Scenario& scenario) {
  const std::int64_t steps = step_count(scenario);
  std::vector<std::int64_t> stops{steps / 3, 2 * steps / 3};
  const std::vector<std::int64_t> frames = schedule_events(scenario, steps).frames;
  const auto first = std::ranges::find_if(frames, [](std::int64_t frame) { return frame > 0; });
  if (first != frames.end()) stops.front() = *first;
  std::sort(stops.begin(), stops.end());
  return stops;
}

CheckedRun check_run(const Core& core, const Scenario& scenario, std::span<const std::int64_t> stops,
                     const std::function<void(std::int64_t)>& report_steps) {
  StepWatch watch(core, scenario, report_steps);
  CheckedRun run{.summary = replay(core, scenario, watch, {.skips_repetition = false, .checks_bounds = true}),
                 .measures = watch.measures(),
                 .last_speed_px_per_s = watch.last_speed_px_per_s(),
                 .knife_edges = watch.knife_edges()};
  if (report_steps) report_steps(run.summary.steps);
  const auto record_equal = [&run](Invariant invariant, const Digest& hash) {
    const double slack = hash == run.summary.state_hash ? 0.0 : -1.0;
    run.measures[static_cast<std::size_t>(invariant)].add(slack, run.summary.steps);
  };
  record_equal(Invariant::repeated, replay(core, scenario).state_hash);
  record_equal(Invariant::resumed, resumed_digest(core, scenario, stops));
  return run;
}

bool is_broken_by_listing(Invariant invariant, const Scenario& scenario) {
  return invariant == Invariant::no_time ||
         (invariant == Invariant::mirror && is_ever_wider_than_window(scenario));
}

std::vector<Invariant> broken_invariants(const Scenario& scenario, const InvariantMeasures& measures) {
  std::vector<Invariant> broken;
  for (std::size_t index = 0; index < kInvariantCount; ++index) {
    const auto invariant = static_cast<Invariant>(index);
    if (!measures[index].holds && !is_broken_by_listing(invariant, scenario)) broken.push_back(invariant);
  }
  return broken;
}

}  // namespace hyrax
