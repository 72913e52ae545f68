#include "tools/app/sweep/sweep_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <map>
#include <mutex>

#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/command_line/workers.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

// Rows that are computed together: about a tenth of a second, so that little is lost if the process ends.
std::int64_t chunk_rows(const Sweep& sweep) {
  constexpr std::int64_t kSteps = 1 << 26;
  constexpr std::int64_t kLeast = 64;
  constexpr std::int64_t kMost = 16384;
  return std::clamp(kSteps / (step_count(sweep.base) + 1), kLeast, kMost);
}

// Rows first .. first + results.size() - 1 of the part.
struct Chunk {
  std::vector<MemberResult> results;
  StepTally tally;
};

// Chunks in order, computed by so many threads, that of the caller included. Few are held at a time.
class ChunkPool {
 public:
  ChunkPool(const Core& core, const Sweep& sweep, const WorkPart& part, std::int64_t first_row,
            std::int64_t rows, std::int64_t threads)
      : core_(core),
        sweep_(sweep),
        part_(part),
        first_row_(first_row),
        rows_(rows),
        chunk_rows_(chunk_rows(sweep)),
        player_(core, sweep) {
    held_max_ = 2 * threads;
    sigset_t all{};
    sigset_t before{};
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);  // Only the caller takes signals.
    threads_ = start_workers(threads - 1, [this](const std::stop_token& stop) { work(stop); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  ~ChunkPool() {
    const std::scoped_lock lock(mutex_);  // No thread is between its test and its wait.
    for (std::jthread& thread : threads_) thread.request_stop();
    changed_.notify_all();
  }

  // The next chunk; nothing after the last one. Until it is there, the caller computes those that no other
  // thread does.
  [[nodiscard]] std::optional<Chunk> take() {
    if (taken_ == chunks()) return std::nullopt;
    std::unique_lock lock(mutex_);
    while (!ready_.contains(taken_) && !fault_) {
      if (!may_begin()) {
        changed_.wait(lock);
        continue;
      }
      const std::int64_t chunk = begun_++;
      lock.unlock();
      Chunk computed = compute(player_, chunk);
      lock.lock();
      ready_.emplace(chunk, std::move(computed));
    }
    if (fault_) std::rethrow_exception(fault_);
    Chunk chunk = std::move(ready_.extract(taken_++).mapped());
    lock.unlock();
    changed_.notify_all();
    return chunk;
  }

 private:
  [[nodiscard]] std::int64_t chunks() const { return (rows_ - first_row_ + chunk_rows_ - 1) / chunk_rows_; }
  [[nodiscard]] bool may_begin() const { return begun_ < std::min(chunks(), taken_ + held_max_); }

  void work(const std::stop_token& stop) {
    try {
      EnsemblePlayer player(core_, sweep_);
      while (const auto chunk = next(stop)) {
        Chunk computed = compute(player, *chunk);
        const std::scoped_lock lock(mutex_);
        ready_.emplace(*chunk, std::move(computed));
        changed_.notify_all();
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      fault_ = std::current_exception();
      changed_.notify_all();
    }
  }

  [[nodiscard]] std::optional<std::int64_t> next(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stop.stop_requested() || begun_ == chunks() || may_begin(); });
    if (stop.stop_requested() || begun_ == chunks()) return std::nullopt;
    return begun_++;
  }

  [[nodiscard]] Chunk compute(EnsemblePlayer& player, std::int64_t chunk) const {
    const std::int64_t first = first_row_ + chunk * chunk_rows_;
    Chunk computed;
    computed.results.resize(static_cast<std::size_t>(std::min(chunk_rows_, rows_ - first)));
    computed.tally = player.play(part_, first, computed.results);
    return computed;
  }

  const Core& core_;
  const Sweep& sweep_;
  const WorkPart part_;
  const std::int64_t first_row_;
  const std::int64_t rows_;
  const std::int64_t chunk_rows_;
  EnsemblePlayer player_;  // Of the caller.
  std::int64_t held_max_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::int64_t, Chunk> ready_;
  std::int64_t begun_ = 0;
  std::int64_t taken_ = 0;
  std::exception_ptr fault_;
  std::vector<std::jthread> threads_;  // The last member: they end before what they use.
};

}  // namespace

SweepOutcome compute_sweep(const Core& core, const Sweep& sweep, const SweepJob& job) {
  PartialResult partial(job.output, job.head, sweep, job.existing);
  EnsembleWriter writer(partial.partial(), job.output, job.head, sweep);
  SweepOutcome outcome;
  outcome.rows = job.head.part.rows(job.head.members);
  outcome.rows_resumed = writer.rows_done();
  {
    partial.note_done(writer.rows_done());
    ChunkPool pool(core, sweep, job.head.part, writer.rows_done(), outcome.rows, job.threads);
    Progress progress("members", outcome.rows - outcome.rows_resumed);
    while (const auto chunk = pool.take()) {
      writer.write(ensemble_tables(sweep, job.head.part, writer.rows_done(), chunk->results));
      partial.note_done(writer.rows_done());
      outcome.tally += chunk->tally;
      progress.show(writer.rows_done() - outcome.rows_resumed);
    }
  }
  writer.finish();
  partial.commit();
  return outcome;
}

std::string part_path(const std::string& path, const WorkPart& part) {
  const FileName name = file_name(path);
  return fmt::format("{}{}.part-{}-of-{}{}", name.folder, name.stem, part.index, part.count, name.extension);
}

}  // namespace hyrax
