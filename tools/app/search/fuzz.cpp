#include "tools/app/search/broken_rule.h"

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

// Runs in batches, which workers take in turn: what they share.
class Fuzzer {
 public:
  Fuzzer(const Core& core, const FuzzLimits& limits, const OtherProgram* other)
      : core_(core),
        limits_(limits),
        other_(other),
        batch_(other == nullptr ? 64 : static_cast<std::int64_t>(other->batch())) {
    if (limits.runs) end_row_ = rows_ = limits.part.rows(*limits.runs);
  }

  FuzzOutcome run() {
    std::vector<std::jthread> workers = start_workers(processors() - 1, [this] { work([] {}); });
    Progress progress("runs", rows_);
    work([&] { show(progress); });
    workers.clear();
    if (error_) std::rethrow_exception(error_);
    return {.runs = played_,
            .not_compared = not_compared_,
            .elapsed_s = elapsed_s(),
            .failure = std::move(failure_)};
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
        const std::int64_t first = next_row_.fetch_add(batch_);
        if (first >= end_row_) return;
        play(first, std::min(first + batch_, rows_));
        report();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      end_row_ = 0;
    }
  }

  void play(std::int64_t first, std::int64_t last) {
    std::vector<Scenario> scenarios;
    std::vector<Digest> hashes;
    for (std::int64_t row = first; row < last; ++row) {
      RandomRun random = random_run(core_, limits_.seed, run_of(row));
      const CheckedRun run = check_run(core_, random.scenario, random.stops);
      ++played_;
      if (auto broken = broken_invariant(random.scenario, run))
        return take(row, std::move(random.scenario), std::move(*broken));
      if (other_ == nullptr) continue;
      scenarios.push_back(std::move(random.scenario));
      hashes.push_back(run.summary.state_hash);
    }
    if (!scenarios.empty()) compare(first, scenarios, hashes);
  }

  void compare(std::int64_t first, std::vector<Scenario>& scenarios, const std::vector<Digest>& hashes) {
    const std::vector<std::string> others = other_->state_hashes(scenarios);
    not_compared_ += std::count(others.begin(), others.end(), "");
    for (std::size_t index = 0; index < others.size(); ++index)
      if (auto broken = different_hash(hashes[index], others[index]))
        return take(first + static_cast<std::int64_t>(index), std::move(scenarios[index]),
                    std::move(*broken));
  }

  [[nodiscard]] std::uint64_t run_of(std::int64_t row) const {
    return static_cast<std::uint64_t>(limits_.part.member(row));
  }

  // Runs before this one go on: one of them may fail as well.
  void take(std::int64_t row, Scenario scenario, BrokenRule broken) {
    const std::lock_guard lock(mutex_);
    if (row >= end_row_) return;
    end_row_ = row;
    failure_ = {run_of(row), std::move(scenario), std::move(broken)};
  }

  const Core& core_;
  const FuzzLimits& limits_;
  const OtherProgram* other_;
  std::int64_t batch_;
  std::int64_t rows_ = std::numeric_limits<std::int64_t>::max() / 2;  // Runs of this part.
  SteadyClock::time_point start_ = SteadyClock::now();
  std::atomic<std::int64_t> next_row_ = 0;
  std::atomic<std::int64_t> end_row_ = rows_;  // Of the first failure.
  std::atomic<std::int64_t> played_ = 0;
  std::atomic<std::int64_t> not_compared_ = 0;
  std::mutex mutex_;
  std::optional<FuzzFailure> failure_;
  std::exception_ptr error_;
};

}  // namespace

FuzzOutcome fuzz(const Core& core, const FuzzLimits& limits, const OtherProgram* other) {
  return Fuzzer(core, limits, other).run();
}

}  // namespace hyrax
