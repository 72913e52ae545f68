#include "tools/app/sweep/sweep_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <utility>

#include "tools/app/command_line/part.h"
#include "tools/app/command_line/print.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// Consecutive rows of the part.
struct Chunk {
  std::vector<Table> rows = {};
  std::int64_t count = 0;
  SweepTally tally = {};
  bool is_ready = false;
};

// Chunks in order, computed by so many threads, that of the caller included. Few are held at a time, in the
// same memory.
class ChunkPool {
 public:
  ChunkPool(const PlayableSweep& sweep, const WorkPart& part, std::int64_t threads)
      : sweep_(sweep),
        part_(part),
        rows_(part.rows(sweep.contents.plan.members)),
        player_(sweep.make_player()),
        held_(static_cast<std::size_t>(2 * threads), Chunk{.rows = sweep.contents.tables}) {
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
  [[nodiscard]] std::int64_t chunks() const { return (rows_ + sweep_.chunk_rows - 1) / sweep_.chunk_rows; }
  [[nodiscard]] Chunk& held(std::int64_t chunk) {
    return held_[static_cast<std::size_t>(chunk) % held_.size()];
  }
  [[nodiscard]] bool may_begin() const { return begun_ < std::min(chunks(), taken_ + std::ssize(held_)); }

  void work(const std::stop_token& stop) {
    try {
      const RowPlayer player = sweep_.make_player();
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

  void compute(const RowPlayer& player, std::int64_t chunk) {
    const std::int64_t first = chunk * sweep_.chunk_rows;
    Chunk& into = held(chunk);
    into.count = std::min(sweep_.chunk_rows, rows_ - first);
    into.tally = player(part_, first, into.count, into.rows);
    set_inputs(sweep_.contents.plan, part_, first, into.count, into.rows.back());
  }

  const PlayableSweep& sweep_;
  const WorkPart part_;
  const std::int64_t rows_;
  const RowPlayer player_;  // Of the caller.
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

SweepTally& SweepTally::operator+=(const SweepTally& other) {
  StepTally::operator+=(other);
  if (early_ends == 0) first_early_end = other.first_early_end;
  early_ends += other.early_ends;
  return *this;
}

SweepTally compute_sweep(const PlayableSweep& sweep, const EnsembleHead& head, const std::string& output,
                         std::int64_t threads) {
  EnsembleWriter writer(output, head, sweep.contents.tables);
  ChunkPool pool(sweep, head.part, threads);
  Progress progress("members", head.part.rows(head.members));
  SweepTally tally;
  while (const Chunk* const chunk = pool.take()) {
    writer.write(chunk->rows, chunk->count);
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
