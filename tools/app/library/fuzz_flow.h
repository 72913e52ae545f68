// `fuzz` for any core: random scenarios, played on all processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/sweep.h"
#include "tools/app/command_line/options.h"
#include "tools/app/command_line/part.h"
#include "tools/app/command_line/print.h"
#include "tools/files/json.h"

namespace hyrax {

struct FuzzRequest {
  static constexpr std::uint64_t kSeed = 1;
  static constexpr double kTime_s = 60.0;
  std::optional<std::uint64_t> seed;
  std::optional<double> time_s;
  std::optional<std::int64_t> runs;  ///< Of all parts.
  std::vector<std::string> without;  ///< Names of rules that may be broken.
  std::string part;
  std::optional<std::int64_t> parts;
  std::string folder = ".";
  Printing printing;

  [[nodiscard]] std::uint64_t first_seed() const { return seed.value_or(kSeed); }
  [[nodiscard]] bool allows(std::string_view rule) const {
    return std::ranges::find(without, rule) != without.end();
  }
};
/// @param kind of rule, as "an invariant".
void declare_fuzz(Options& options, FuzzRequest& request, const std::string& kind,
                  const std::vector<std::string>& rules);

/// Refuses what does not go together, chooses the part and prints the seed.
[[nodiscard]] WorkPart begin_fuzz(const FuzzRequest& request);

/// Where a failing scenario is written, in the folder, which is made: NAME.json, or where that exists with a
/// number, which the name gets.
[[nodiscard]] std::string failure_path(const FuzzRequest& request, std::string& name);

/// What was found, and written, of a run that breaks a rule.
struct FuzzFinding {
  std::string sentence = {};
  std::string lines = {};  ///< Complete.
  Json::Object json = {};
};
/// What else is said of all runs.
struct FuzzNote {
  std::string lines = {};  ///< Complete.
  Json::Object json = {};
};
/// Prints it, or that rules of this kind, as "invariant", hold.
[[nodiscard]] ExitCode end_fuzz(const FuzzRequest& request, const WorkPart& part, const std::string& kind,
                                std::int64_t runs, double elapsed_s, std::uint64_t failing_run,
                                const std::optional<FuzzFinding>& finding, FuzzNote note);

/// Plays runs in batches, which workers take in turn, until one fails; shows progress. With a number of runs
/// the outcome does not depend on how many processors there are.
template <class Failure>
class Fuzzer {
 public:
  using Play = std::function<std::optional<Failure>(std::uint64_t run)>;

  Fuzzer(const FuzzRequest& request, WorkPart part, Play play)
      : request_(request), part_(part), play_(std::move(play)) {
    if (request.runs) end_row_ = rows_ = part.rows(*request.runs);
  }

  void run() {
    std::vector<std::jthread> workers = start_workers(processors() - 1, [this] { work([] {}); });
    Progress progress("runs", rows_);
    work([&] { show(progress); });
    workers.clear();
    if (error_) std::rethrow_exception(error_);
    played_s_ = elapsed_s();
  }

  [[nodiscard]] std::int64_t played() const { return played_; }
  [[nodiscard]] double played_s() const { return played_s_; }
  /// The first one, in order of the runs, and its number.
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }
  [[nodiscard]] std::uint64_t failing_run() const { return run_of(end_row_); }

 private:
  using SteadyClock = std::chrono::steady_clock;
  static constexpr std::int64_t kBatch = 64;

  [[nodiscard]] double elapsed_s() const {
    return std::chrono::duration<double>(SteadyClock::now() - start_).count();
  }
  [[nodiscard]] double time_s() const { return request_.time_s.value_or(FuzzRequest::kTime_s); }
  [[nodiscard]] bool is_over() const { return !request_.runs && elapsed_s() >= time_s(); }
  [[nodiscard]] std::uint64_t run_of(std::int64_t row) const {
    return static_cast<std::uint64_t>(part_.member(row));
  }

  void show(Progress& progress) const {
    if (request_.runs) return progress.show(played_);
    const double passed_s = elapsed_s();
    progress.show_text(fmt::format("{} runs, {:.3g} per second, {:.0f} s left", played_.load(),
                                   static_cast<double>(played_) / passed_s,
                                   std::max(0.0, time_s() - passed_s)));
  }

  void work(const auto& report) {
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

  // Runs before one that fails go on: one of them may fail as well.
  void play(std::int64_t first, std::int64_t last) {
    for (std::int64_t row = first; row < last; ++row) {
      std::optional<Failure> failure = play_(run_of(row));
      ++played_;
      if (!failure) continue;
      const std::lock_guard lock(mutex_);
      if (row >= end_row_) return;
      end_row_ = row;
      failure_ = std::move(failure);
      return;
    }
  }

  const FuzzRequest& request_;
  WorkPart part_;
  Play play_;
  std::int64_t rows_ = std::numeric_limits<std::int64_t>::max() / 2;  // Runs of this part.
  SteadyClock::time_point start_ = SteadyClock::now();
  double played_s_ = 0.0;
  std::atomic<std::int64_t> next_row_ = 0;
  std::atomic<std::int64_t> end_row_ = rows_;  // Of the first failure.
  std::atomic<std::int64_t> played_ = 0;
  std::mutex mutex_;
  std::optional<Failure> failure_;
  std::exception_ptr error_;
};

/// Plays, and reports. @param find writes the failing scenario of a run: a FuzzFinding. @param note is asked
/// behind all runs.
template <class Failure>
[[nodiscard]] ExitCode fuzz(
    const FuzzRequest& request, const std::string& kind, typename Fuzzer<Failure>::Play play,
    const auto& find, const std::function<FuzzNote()>& note = [] { return FuzzNote(); }) {
  const WorkPart part = begin_fuzz(request);
  Fuzzer<Failure> fuzzer(request, part, std::move(play));
  fuzzer.run();
  std::optional<FuzzFinding> finding;
  if (fuzzer.failure()) finding = find(fuzzer.failing_run(), *fuzzer.failure());
  return end_fuzz(request, part, kind, fuzzer.played(), fuzzer.played_s(), fuzzer.failing_run(), finding,
                  note());
}

}  // namespace hyrax
