// Starts, saves and finishes recordings, on behalf of the menu and the command line.
#pragma once

#include <functional>
#include <string>

#include "tools/hyrax/pet.h"

namespace hyrax {

/// REQUIRES: save, while the pet's session is recording; start and start_new, while it is not.
class Recorder {
 public:
  /// @param notify shows a sentence to the user. Refers to the pet.
  Recorder(Pet& pet, std::function<void(const std::string&)> notify);

  /// ERRORS: Failure(bad_input) if the file exists; Failure(cannot_access) if it cannot be written.
  void start(const std::string& path);
  /// Starts a recording in "Documents\Hyrax". ERRORS: as start.
  void start_new();
  /// Finishes the recording, if there is one. ERRORS: Failure(cannot_access).
  void finish();
  /// Finishes the recording and notifies the user. ERRORS: Failure(cannot_access).
  void save();
  /// Saves the last minutes as a file in "Documents\Hyrax".
  void save_just_happened();
  /// Saves the recording if the last save was long enough ago, and notifies the user of a failure.
  void save_if_due();

 private:
  void continue_in_new_file();

  Pet& pet_;
  std::function<void(const std::string&)> notify_;
  ScenarioSaver saver_;
  std::int64_t next_save_ticks_ = 0;
  std::string last_failure_;
};

}  // namespace hyrax
