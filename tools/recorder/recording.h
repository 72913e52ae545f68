// Recordings, written to the disk by a thread as they grow.
#pragma once

#include <cassert>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tools/files/failure.h"
#include "tools/files/scenario_writer.h"
#include "tools/platform/atomic_file.h"
#include "tools/platform/path.h"
#include "tools/recorder/tape.h"

namespace hyrax {

/// Writes scenarios in a thread, so that no frame waits for a disk. Files are replaced atomically, also in a
/// crash or a power cut. Only files that it wrote itself are replaced or removed.
/// @tparam Document a scenario.
template <class Document>
class SaverOf {
 public:
  /// @param text_of makes the text of a scenario; what it throws is a failure of that file only.
  explicit SaverOf(std::function<std::string(const Document&)> text_of)
      : text_of_(std::move(text_of)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

  /// Queues the file. If one for the same path is last in the queue, it is replaced.
  void save(const std::string& path, Document scenario);
  /// Writes the file now. ERRORS: Failure(cannot_access), also if a file of that name exists that it did not
  /// write.
  void write(const std::string& path, const Document& scenario);
  /// Whether it wrote the file, or is writing it.
  [[nodiscard]] bool has_written(const std::string& path);
  /// Removes a file that it wrote; others are kept.
  void remove(const std::string& path);
  /// Returns when the queue is empty.
  void wait();
  /// The message of the last failure since the last call; a later save may have succeeded.
  [[nodiscard]] std::optional<std::string> take_failure();

 private:
  struct Job {
    std::string path;
    Document scenario;
  };

  void work(const std::stop_token& stop);

  std::function<std::string(const Document&)> text_of_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> jobs_;
  std::set<std::string> written_;
  bool is_busy_ = false;
  std::optional<std::string> failure_;
  std::jthread thread_;  // The last member: it writes what is queued, and ends before what it uses.
};

class ScenarioSaver : public SaverOf<Scenario> {
 public:
  using SaverOf<Scenario>::SaverOf;
  ScenarioSaver() : SaverOf<Scenario>(scenario_file_text) {}
};

/// NAME-2.json for number 2; the path itself for 1.
[[nodiscard]] std::string numbered_path(const std::string& path, std::size_t number);
/// The path if no file has it, else NAME-2.json or the next free number.
[[nodiscard]] std::string free_path(const std::string& path);

/// A recording. However the program ends, at most what came after the last `save` is lost, and each file
/// replays as it is. After kPartFrames frames the recording continues in a new part, NAME-2.json or the next
/// free number, so that each save is short. `finish` joins all parts into one file. Other files are neither
/// replaced nor removed.
/// @tparam AnyTape keeps the frames: Tape (tape.h), or CoreTape (core_recorder.h).
template <class AnyTape>
class RecordingOf {
 public:
  using Start = typename AnyTape::Start;
  using Saver = SaverOf<typename AnyTape::Document>;

  static constexpr std::int64_t kSavesPerSecond = 2;  ///< So that every frame is on the disk within a second.
  static constexpr std::int64_t kPartFrames = 16'384;  ///< Four and a half minutes of motion at 60 Hz.
  static constexpr std::int64_t kFramesMax = std::int64_t{1} << 20;  ///< About five hours; then `next`.

  /// @param path of the file, UTF-8. Refers to the saver.
  RecordingOf(const std::string& path, const Start& start, Saver& saver)
      : RecordingOf(path, path, start, saver) {}
  /// The recording that continues this one, in a new file beside the first.
  [[nodiscard]] RecordingOf next(const Start& start) const {
    return {first_path_, free_path(first_path_), start, saver_};
  }

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Whether it has kFramesMax frames.
  [[nodiscard]] bool is_full() const { return all_.frames() >= kFramesMax; }

  void add_input(const typename AnyTape::Input& input);
  /// @param now the state after the frame. REQUIRES: !is_full().
  void add_frame(const Start& now);
  /// Queues the last part. Nothing is written of a recording without frames.
  void save();
  /// Writes the complete file, and removes the parts. ERRORS: Failure(cannot_access), which
  /// names the parts: they are then kept. It may be tried again, also after more frames.
  void finish();

 private:
  RecordingOf(const std::string& first_path, const std::string& path, const Start& start, Saver& saver)
      : first_path_(first_path), path_(path), saver_(saver), all_(start), part_(start), part_paths_{path} {}

  std::string first_path_;  // Of this one and of those that continue it.
  std::string path_;
  Saver& saver_;
  AnyTape all_;
  AnyTape part_;
  std::size_t part_number_ = 1;
  std::vector<std::string> part_paths_;
  bool is_saved_ = true;
};
using Recording = RecordingOf<Tape>;

/// A scenario's name from a file's: its stem, with other characters than those of a name replaced by `-`.
[[nodiscard]] std::string scenario_name_of(const std::string& path);

template <class Document>
void SaverOf<Document>::save(const std::string& path, Document scenario) {
  {
    const std::lock_guard lock(mutex_);
    if (!jobs_.empty() && jobs_.back().path == path) jobs_.pop_back();
    jobs_.push_back({path, std::move(scenario)});
  }
  changed_.notify_all();
}

template <class Document>
void SaverOf<Document>::write(const std::string& path, const Document& scenario) {
  const std::string text = text_of_(scenario);
  AtomicFile file(path);
  file.write(text);
  std::unique_lock lock(mutex_);
  const bool is_new = written_.insert(path).second;
  lock.unlock();
  try {
    is_new ? file.commit_as_new() : file.commit();
  } catch (const Failure&) {
    lock.lock();
    if (is_new) written_.erase(path);
    throw;
  }
}

template <class Document>
bool SaverOf<Document>::has_written(const std::string& path) {
  const std::lock_guard lock(mutex_);
  return written_.contains(path);
}

template <class Document>
void SaverOf<Document>::remove(const std::string& path) {
  const std::lock_guard lock(mutex_);
  if (written_.erase(path) > 0) remove_file(path);
}

template <class Document>
void SaverOf<Document>::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty() && !is_busy_; });
}

template <class Document>
std::optional<std::string> SaverOf<Document>::take_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

template <class Document>
void SaverOf<Document>::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    if (!changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) return;
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    is_busy_ = true;
    lock.unlock();
    std::optional<std::string> failure;
    try {
      write(job.path, job.scenario);
    } catch (const Failure& refused) {
      failure = refused.what();
    } catch (const std::exception& error) {  // Such as out of memory: the program continues.
      failure = job.path + ": cannot be written: " + error.what();
    }
    lock.lock();
    is_busy_ = false;
    if (failure) failure_ = failure;
    changed_.notify_all();
  }
}

template <class AnyTape>
void RecordingOf<AnyTape>::add_input(const typename AnyTape::Input& input) {
  all_.add_input(input);
  part_.add_input(input);
}

template <class AnyTape>
void RecordingOf<AnyTape>::add_frame(const Start& now) {
  assert(!is_full());
  all_.add_frame(now.row);
  part_.add_frame(now.row);
  is_saved_ = false;
  if (part_.frames() < kPartFrames) return;
  save();
  part_ = AnyTape(now);
  part_paths_.push_back(numbered_path(path_, ++part_number_));
}

template <class AnyTape>
void RecordingOf<AnyTape>::save() {
  if (is_saved_) return;
  std::string& path = part_paths_.back();
  while (is_there(path) && !saver_.has_written(path)) path = numbered_path(path_, ++part_number_);
  saver_.save(path, part_.scenario(scenario_name_of(path)));
  is_saved_ = true;
}

template <class AnyTape>
void RecordingOf<AnyTape>::finish() {
  save();  // All frames are kept if the complete file cannot be written.
  saver_.wait();
  if (all_.frames() == 0) return;
  try {
    saver_.write(path_, all_.scenario(scenario_name_of(path_)));
  } catch (const Failure& failure) {
    std::string kept;
    for (const std::string& path : part_paths_)
      if (saver_.has_written(path)) kept += (kept.empty() ? "; what was saved is in " : ", ") + path;
    throw Failure(failure.exit_code(), failure.what() + kept);
  }
  for (const std::string& path : part_paths_)
    if (path != path_) saver_.remove(path);
}

}  // namespace hyrax
