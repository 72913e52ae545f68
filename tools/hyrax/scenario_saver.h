// Writes scenarios beside the program's other work.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "sim/scenario/scenario.h"
#include "tools/files/scenario_writer.h"

namespace hyrax {

/// A thread that makes text of scenarios and puts it on the disk, so that no frame waits for a disk. Each
/// file is replaced whole: whoever opens it finds the old one or the new one, at any moment, after a
/// crash and after a power cut. Only files that it made itself are replaced or removed.
class ScenarioSaver {
 public:
  /// @param text_of makes the text of a scenario; whatever it throws is a failure of that file alone.
  explicit ScenarioSaver(std::function<std::string(const Scenario&)> text_of = scenario_file_text);
  ScenarioSaver(const ScenarioSaver&) = delete;
  ScenarioSaver& operator=(const ScenarioSaver&) = delete;
  /// Writes what is left.
  ~ScenarioSaver();

  /// Writes the file as soon as the disk lets it. One for the same path that still waits is left out.
  void save(const std::string& path, Scenario scenario);
  /// Writes the file now. ERRORS: Failure(cannot_access), also where another's file has that name.
  void write(const std::string& path, const Scenario& scenario);
  /// Whether it made the file, or is about to.
  [[nodiscard]] bool has_made(const std::string& path);
  /// Removes a file that it made; another's stays.
  void remove(const std::string& path);
  /// Returns when all is written.
  void wait();
  /// Sentences on what could not be written since the last call; a later save may have mended it.
  [[nodiscard]] std::optional<std::string> take_failure();

 private:
  struct Job {
    std::string path;
    Scenario scenario;
  };

  void work();

  std::function<std::string(const Scenario&)> text_of_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  std::set<std::string> made_;
  bool is_busy_ = false;
  bool is_ending_ = false;
  std::optional<std::string> failure_;
  std::thread thread_;
};

}  // namespace hyrax
