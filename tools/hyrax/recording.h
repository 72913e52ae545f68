// Recordings, written to the disk by a thread as they grow.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tools/files/scenario_writer.h"
#include "tools/hyrax/tape.h"

namespace hyrax {

/// Writes scenarios in a thread, so that no frame waits for a disk. Files are replaced atomically, also in a
/// crash or a power cut. Only files that it wrote itself are replaced or removed.
class ScenarioSaver {
 public:
  /// @param text_of makes the text of a scenario; what it throws is a failure of that file only.
  explicit ScenarioSaver(std::function<std::string(const Scenario&)> text_of = scenario_file_text);
  /// Writes what is queued.
  ~ScenarioSaver();

  /// Queues the file. If one for the same path is last in the queue, it is replaced.
  void save(const std::string& path, Scenario scenario);
  /// Writes the file now. ERRORS: Failure(cannot_access), also if a file of that name exists that it did not
  /// write.
  void write(const std::string& path, const Scenario& scenario);
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
    Scenario scenario;
  };

  void work(const std::stop_token& stop);

  std::function<std::string(const Scenario&)> text_of_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> jobs_;
  std::set<std::string> written_;
  bool is_busy_ = false;
  std::optional<std::string> failure_;
  std::jthread thread_;  // The last member: it ends before what it uses.
};

/// The path if no file has it, else NAME-2.json or the next free number.
[[nodiscard]] std::string free_path(const std::string& path);

/// A recording. However the program ends, at most what came after the last `save` is lost, and each file
/// replays as it is. After kPartFrames frames the recording continues in a new part, NAME-2.json or the next
/// free number, so that each save is short. `finish` joins all parts into one file. Other files are neither
/// replaced nor removed.
class Recording {
 public:
  static constexpr std::int64_t kSavesPerSecond = 2;  ///< So that every frame is on the disk within a second.
  static constexpr std::int64_t kPartFrames = 16'384;  ///< Four and a half minutes of motion at 60 Hz.
  static constexpr std::int64_t kFramesMax = std::int64_t{1} << 20;  ///< About five hours; then `next`.

  /// @param path of the file, UTF-8. Refers to the saver.
  Recording(const std::string& path, const Keyframe& start, ScenarioSaver& saver)
      : Recording(path, path, start, saver) {}
  /// The recording that continues this one, in a new file beside the first.
  [[nodiscard]] Recording next(const Keyframe& start) const {
    return {first_path_, free_path(first_path_), start, saver_};
  }

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Whether it has kFramesMax frames.
  [[nodiscard]] bool is_full() const { return all_.frames() >= kFramesMax; }

  void add_input(const Action& action);
  /// @param now the state after the frame. REQUIRES: !is_full().
  void add_frame(const Keyframe& now);
  /// Queues the last part. Nothing is written of a recording without frames.
  void save();
  /// Writes the complete file, and removes the parts. ERRORS: Failure(cannot_access), which
  /// names the parts: they are then kept. It may be tried again, also after more frames.
  void finish();

 private:
  Recording(const std::string& first_path, const std::string& path, const Keyframe& start,
            ScenarioSaver& saver)
      : first_path_(first_path), path_(path), saver_(saver), all_(start), part_(start), part_paths_{path} {}

  std::string first_path_;  // Of this one and of those that continue it.
  std::string path_;
  ScenarioSaver& saver_;
  Tape all_;
  Tape part_;
  std::size_t part_number_ = 1;
  std::vector<std::string> part_paths_;
  bool is_saved_ = true;
};

/// A scenario's name from a file's: its stem, with other characters than those of a name replaced by `-`.
[[nodiscard]] std::string scenario_name_of(const std::string& path);

}  // namespace hyrax
