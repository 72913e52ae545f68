#include "tools/app/search/fuzz.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>

#include "sim/search/random_scenario.h"
#include "sim/search/run_check.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/command_line/workers.h"

namespace hyrax {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::int64_t kBatch = 64;

// Runs in batches, which workers take in turn: what they share.
class Fuzzer {
 public:
  Fuzzer(const Core& core, const FuzzLimits& limits) : core_(core), limits_(limits) {
    if (limits.runs) end_row_ = rows_ = limits.part.rows(*limits.runs);
  }

  FuzzOutcome run() {
    std::vector<std::jthread> workers = start_workers(processors() - 1, [this] { work([] {}); });
    Progress progress("runs", rows_);
    work([&] { show(progress); });
    workers.clear();
    if (error_) std::rethrow_exception(error_);
    return {.runs = played_, .elapsed_s = elapsed_s(), .failure = std::move(failure_)};
  }

 private:
  [[nodiscard]] double elapsed_s() const {
    return std::chrono::duration<double>(SteadyClock::now() - start_).count();
  }
  [[nodiscard]] bool is_over() const { return !limits_.runs && elapsed_s() >= limits_.time_s; }

  void show(Progress& progress) const {
    if (limits_.runs) return progress.show(played_);
    const double passed_s = elapsed_s();
    progress.show_text(fmt::format("{} runs, {:.3g} per second, {:.0f} s left", played_.load(),
                                   static_cast<double>(played_) / passed_s,
                                   std::max(0.0, limits_.time_s - passed_s)));
  }

  template <class Report>
  void work(const Report& report) {
    try {
      while (!is_over()) {
        const std::int64_t first = next_row_.fetch_add(kBatch);
        if (first >= end_row_) return;
        play(first, std::min(first + kBatch, rows_));
        report();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      end_row_ = 0;
    }
  }

  void play(std::int64_t first, std::int64_t last) {
    for (std::int64_t row = first; row < last; ++row) {
      RandomRun random = random_run(core_, limits_.seed, run_of(row));
      const CheckedRun run = check_run(core_, random.scenario, random.stops);
      ++played_;
      for (const Invariant broken : broken_invariants(random.scenario, run.measures))
        if (std::ranges::find(limits_.without, text_of(broken).name) == limits_.without.end())
          return take(row, std::move(random.scenario), broken,
                      run.measures[static_cast<std::size_t>(broken)]);
    }
  }

  [[nodiscard]] std::uint64_t run_of(std::int64_t row) const {
    return static_cast<std::uint64_t>(limits_.part.member(row));
  }

  // Runs before this one go on: one of them may fail as well.
  void take(std::int64_t row, Scenario scenario, Invariant broken, const InvariantMeasure& measure) {
    const std::lock_guard lock(mutex_);
    if (row >= end_row_) return;
    end_row_ = row;
    failure_ = {.run = run_of(row),
                .scenario = std::move(scenario),
                .broken = broken,
                .found = fmt::format("{:.3g} {} at step {}", measure.slack, text_of(broken).unit,
                                     measure.worst_step)};
  }

  const Core& core_;
  const FuzzLimits& limits_;
  std::int64_t rows_ = std::numeric_limits<std::int64_t>::max() / 2;  // Runs of this part.
  SteadyClock::time_point start_ = SteadyClock::now();
  std::atomic<std::int64_t> next_row_ = 0;
  std::atomic<std::int64_t> end_row_ = rows_;  // Of the first failure.
  std::atomic<std::int64_t> played_ = 0;
  std::mutex mutex_;
  std::optional<FuzzFailure> failure_;
  std::exception_ptr error_;
};

}  // namespace

std::vector<std::string> fuzzed_rules() {
  std::vector<std::string> rules;
  for (std::size_t index = 0; index < static_cast<std::size_t>(Invariant::comes_to_rest); ++index)
    if (static_cast<Invariant>(index) != Invariant::no_time) rules.emplace_back(kInvariantTexts[index].name);
  return rules;
}

FuzzOutcome fuzz(const Core& core, const FuzzLimits& limits) { return Fuzzer(core, limits).run(); }

}  // namespace hyrax
