#include "sim/explain/step_replay.h"

#include <algorithm>
#include <functional>

#include "sim/motion/listing.h"
#include "sim/replay/kernel_of.h"
#include "sim/replay/replay.h"
#include "sim/replay/step_core.h"

namespace hyrax {
namespace {

struct StatementsStep {
  const StepStatements* statements = nullptr;

  void operator()(State& state, double dt_s, const Bounds& bounds) const {
    StatementRun(dt_s, bounds)(*statements, state);
  }
};

// By which the replay tells the walls, in strict arithmetic whatever the build: a flight as data.
class StatementFlight {
 public:
  StatementFlight(const StepStatements& flight, const Constants& constants, const Bounds& bounds)
      : flight_(&flight), walls_(constants, AllParts{}, bounds), bounds_(bounds) {}

  void fly(State& state, double dt_s) const { StatementRun(dt_s, bounds_)(*flight_, state); }
  std::uint8_t meet_walls_in_x(State& state) const { return walls_.meet_walls_in_x(state); }

 private:
  const StepStatements* flight_;
  ListingStep<AllParts> walls_;
  Bounds bounds_;
};

struct StatementCores {
  using Core = StepCore<StatementsStep>;

  StatementsStep step;
  const StepStatements* flight = nullptr;  // Without walls.
  Constants observed;

  [[nodiscard]] Core make(const State& state) const { return {step, state}; }
  [[nodiscard]] Constants constants() const { return observed; }
  [[nodiscard]] StatementFlight listing(const Bounds& bounds) const { return {*flight, observed, bounds}; }
};

bool is_flight(const Statement& statement) { return statement.form != Statement::Form::first_of; }

bool is_fused(const StepStatements& step) { return std::ranges::any_of(step, &Statement::is_fused); }

StepStatements flight_of(StepStatements step) {
  std::erase_if(step, std::not_fn(is_flight));
  return step;
}

// Compares a replay with a run, by rows or by blocks, until one differs. Times are not compared: they follow
// from the frame times, by the clock of this program.
class RunMatcher final : public RowSink {
 public:
  explicit RunMatcher(const StoredRun& run) : run_(run) {}

  [[nodiscard]] Wants wants() const override {
    return {.rows_every = run_.blocks.empty() ? 1 : 0, .blocks = !run_.blocks.empty()};
  }
  void rows(const Columns& batch) override {
    for (std::size_t index = 0; index < batch.size() && !differs_; ++index, ++at_)
      differs_ = at_ == run_.rows.size() || !is_same(run_.rows.row(at_), batch.row(index));
  }
  void block(const Block& block, std::int64_t count) override {
    while (count > 0 && !differs_) {
      differs_ = at_ == run_.blocks.size() || run_.blocks[at_].digest != block.digest;
      if (differs_) return;
      const std::int64_t both = std::min(count, run_.blocks[at_].count - used_);
      count -= both;
      used_ += both;
      if (used_ < run_.blocks[at_].count) continue;
      ++at_;
      used_ = 0;
    }
  }
  [[nodiscard]] bool differs() const { return differs_; }

 private:
  static bool is_same(const Row& a, const Row& b) {
    return same_bits(state_of(a), state_of(b)) && same_bits(a.dt_s, b.dt_s) && a.contact == b.contact;
  }

  const StoredRun& run_;
  std::size_t at_ = 0;     // The row, or the block, that comes next,
  std::int64_t used_ = 0;  // and how many repetitions of the block there were.
  bool differs_ = false;
};

bool is_hitch(const Input& input) { return std::holds_alternative<Hitch>(input.action); }

}  // namespace

Scenario playback_of(const StoredRun& golden) {
  Scenario playback = golden.scenario;
  playback.events.clear();
  const bool has_rows = golden.rows.size() > 1;
  for (const Input& input : golden.inputs)
    if (!has_rows || !is_hitch(input)) playback.events.push_back({input.frame, input.action});
  if (has_rows) {
    playback.clock = {RecordedSteps{{golden.rows.dt_s.begin() + 1, golden.rows.dt_s.end()}}, {}};
    playback.length = std::monostate();
    return playback;
  }
  if (const auto* const rate = std::get_if<FixedRate>(&playback.clock.base))
    playback.clock.base = FixedStep{1.0 / rate->rate_hz};
  playback.length = golden.steps;
  return playback;
}

namespace {

bool reproduces(const StatementCores& cores, const Scenario& scenario, const StoredRun& run) {
  const KernelOf<StatementCores> kernel(cores);
  RunMatcher matcher(run);
  Replay replay(scenario, matcher, {.kernel = &kernel});
  if (replay.steps() < run.steps) return false;
  std::int64_t piece = 16 * static_cast<std::int64_t>(kBlockRows);
  for (std::int64_t at = -1; at < run.steps && !matcher.differs(); piece *= 2) {
    if (replay.keyframe().row.step == at) break;  // The state is not finite any more.
    at = replay.keyframe().row.step;
    replay.play_to(std::min(run.steps, at + piece));
  }
  if (matcher.differs()) return false;
  const RunSummary summary = replay.finish();
  return summary.steps == run.steps && hex(summary.state_hash) == run.state_hash;
}

}  // namespace

bool reproduces(const StepStatements& step, const Constants& observed, const Scenario& scenario,
                const StoredRun& run) {
  const StepStatements listed_flight = flight_of(listing(observed));
  if (reproduces({{&step}, &listed_flight, observed}, scenario, run)) return true;
  if (!is_fused(step)) return false;
  // A build that fuses the step's multiply-adds fuses those by which its replay tells the walls, too.
  const StepStatements own_flight = flight_of(step);
  return reproduces({{&step}, &own_flight, observed}, scenario, run);
}

}  // namespace hyrax
