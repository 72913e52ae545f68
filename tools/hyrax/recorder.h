// The recordings that menu and command line start and end.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "tools/hyrax/pet.h"

namespace hyrax {

/// Starts, saves and finishes recordings, on behalf of the menu and the command line. Times are ticks of the
/// pet's clock.
/// REQUIRES: save and continue_in_new_file, while the pet's session is recording; start and start_new, while
/// it is not.
class Recorder {
 public:
  /// Functions of the system.
  struct System {
    std::function<void(const std::string& sentence)> notify;       ///< Shows a sentence to the user.
    std::function<std::string(const std::string& name)> new_path;  ///< Of a file that is not there.
  };

  /// Refers to pet and saver.
  Recorder(Pet& pet, ScenarioSaver& saver, std::int64_t ticks_per_s, System system)
      : pet_(pet),
        saver_(saver),
        system_(std::move(system)),
        saves_(ticks_per_s, Recording::kSavesPerSecond) {}

  /// ERRORS: Failure(bad_input) if the file exists; Failure(cannot_access) if it cannot be written.
  void start(const std::string& path, std::int64_t ticks);
  /// Starts a recording in a new file, and notifies the user. ERRORS: as start.
  void start_new(std::int64_t ticks);
  /// Finishes the recording, if there is one. ERRORS: Failure(cannot_access); it has ended nevertheless.
  void finish();
  /// Finishes the recording and notifies the user; if it cannot be written, it continues.
  void save();
  /// Saves the last minutes in a new file, and notifies the user. ERRORS: Failure(cannot_access).
  void save_just_happened();
  /// Finishes the file of the recording, continues in a new one beside it, and notifies the user, or of a
  /// failure of the finished file.
  void continue_in_new_file();
  /// Saves the recording if the last save was long enough ago, and notifies the user of a failure.
  void save_if_due(std::int64_t ticks);

 private:
  [[nodiscard]] std::optional<Recording>& recording() { return pet_.session().recording(); }

  Pet& pet_;
  ScenarioSaver& saver_;
  System system_;
  Repeated saves_;
  std::string last_failure_;
};

}  // namespace hyrax
