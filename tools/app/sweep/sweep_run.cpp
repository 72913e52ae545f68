#include "tools/app/sweep/sweep_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include "sim/scenario/frame_clock.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/command_line/workers.h"
#include "tools/files/path.h"

namespace hyrax {
namespace {

// Rows that are computed together: about a tenth of a second, so that threads wait little for each other.
std::int64_t chunk_rows(const Sweep& sweep) {
  constexpr std::int64_t kSteps = 1 << 26;
  constexpr std::int64_t kLeast = 64;
  constexpr std::int64_t kMost = 16384;
  return std::clamp(kSteps / (step_count(sweep.base) + 1), kLeast, kMost);
}

// Consecutive rows of the part.
struct Chunk {
  std::vector<MemberResult> results;
  StepTally tally;
  bool is_ready = false;
};

// Chunks in order, computed by so many threads, that of the caller included. Few are held at a time, in the
// same memory.
class ChunkPool {
 public:
  ChunkPool(const Core& core, const Sweep& sweep, const WorkPart& part, std::int64_t threads)
      : core_(core),
        sweep_(sweep),
        part_(part),
        rows_(part.rows(sweep.members)),
        chunk_rows_(chunk_rows(sweep)),
        player_(core, sweep),
        held_(static_cast<std::size_t>(2 * threads)) {
    threads_ = start_workers(threads - 1, [this](const std::stop_token& stop) { work(stop); });
  }
  ~ChunkPool() {
    const std::scoped_lock lock(mutex_);  // No thread is between its test and its wait.
    for (std::jthread& thread : threads_) thread.request_stop();
    changed_.notify_all();
  }

  // The next chunk, until the next call; null after the last one. Until it is there, the caller computes
  // those that no other thread does.
  [[nodiscard]] const Chunk* take() {
    std::unique_lock lock(mutex_);
    if (std::exchange(is_lent_, false)) {
      held(taken_++).is_ready = false;
      changed_.notify_all();
    }
    if (taken_ == chunks()) return nullptr;
    while (!held(taken_).is_ready && !fault_) {
      if (!may_begin()) {
        changed_.wait(lock);
        continue;
      }
      const std::int64_t chunk = begun_++;
      lock.unlock();
      compute(player_, chunk);
      lock.lock();
      held(chunk).is_ready = true;
    }
    if (fault_) std::rethrow_exception(fault_);
    is_lent_ = true;
    return &held(taken_);
  }

 private:
  [[nodiscard]] std::int64_t chunks() const { return (rows_ + chunk_rows_ - 1) / chunk_rows_; }
  [[nodiscard]] Chunk& held(std::int64_t chunk) {
    return held_[static_cast<std::size_t>(chunk) % held_.size()];
  }
  [[nodiscard]] bool may_begin() const { return begun_ < std::min(chunks(), taken_ + std::ssize(held_)); }

  void work(const std::stop_token& stop) {
    try {
      EnsemblePlayer player(core_, sweep_);
      while (const auto chunk = next(stop)) {
        compute(player, *chunk);
        const std::scoped_lock lock(mutex_);
        held(*chunk).is_ready = true;
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

  void compute(EnsemblePlayer& player, std::int64_t chunk) {
    const std::int64_t first = chunk * chunk_rows_;
    Chunk& into = held(chunk);
    into.results.resize(static_cast<std::size_t>(std::min(chunk_rows_, rows_ - first)));
    into.tally = player.play(part_, first, into.results);
  }

  const Core& core_;
  const Sweep& sweep_;
  const WorkPart part_;
  const std::int64_t rows_;
  const std::int64_t chunk_rows_;
  EnsemblePlayer player_;  // Of the caller.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Chunk> held_;  // Chunk k in place k modulo their number.
  std::int64_t begun_ = 0;
  std::int64_t taken_ = 0;  // Those that the caller is done with.
  bool is_lent_ = false;    // Whether it has the next one.
  std::exception_ptr fault_;
  std::vector<std::jthread> threads_;  // The last member: they end before what they use.
};

}  // namespace

StepTally compute_sweep(const Core& core, const Sweep& sweep, const EnsembleHead& head,
                        const std::string& output, std::int64_t threads) {
  EnsembleWriter writer(output, head, sweep);
  ChunkPool pool(core, sweep, head.part, threads);
  Progress progress("members", head.part.rows(head.members));
  StepTally tally;
  std::vector<Table> rows = ensemble_tables(sweep);
  while (const Chunk* const chunk = pool.take()) {
    set_ensemble_rows(sweep, head.part, writer.rows_done(), chunk->results, rows);
    writer.write(rows);
    tally += chunk->tally;
    progress.show(writer.rows_done());
  }
  writer.finish();
  return tally;
}

std::string part_path(const std::string& path, const WorkPart& part) {
  const FileName name = file_name(path);
  return fmt::format("{}{}.part-{}-of-{}{}", name.folder, name.stem, part.index, part.count, name.extension);
}

}  // namespace hyrax
