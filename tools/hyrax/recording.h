// A recording that stands on the disk as it grows.
#pragma once

#include <string>
#include <vector>

#include "tools/hyrax/scenario_saver.h"
#include "tools/hyrax/tape.h"

namespace hyrax {

/// Whoever ends the program, however, loses at most what came after the last `save`, and finds files that
/// each replay as they are. What is written at once stays short: after kPartFrames frames the file is left
/// as it is, and the next part goes on beside it, as NAME-2.json or the next number that no file has.
/// `finish` makes one file of all parts. Files of others are neither replaced nor removed.
class Recording {
 public:
  static constexpr std::int64_t kPartFrames = 16'384;  ///< Four and a half minutes of motion at 60 Hz.
  static constexpr std::int64_t kFramesMax = std::int64_t{1} << 20;  ///< Some five hours of it.

  /// @param path of the file, UTF-8. Refers to the saver. ERRORS: Failure(bad_input) if the file exists.
  Recording(const std::string& path, const Keyframe& start, ScenarioSaver& saver);
  /// The recording that goes on after this one, in a file beside its first one.
  [[nodiscard]] Recording next(const Keyframe& start) const;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Whether it takes no further frame.
  [[nodiscard]] bool is_full() const { return whole_.frames() >= kFramesMax; }

  void add_input(const Action& action);
  /// @param now the state after the frame. REQUIRES: !is_full().
  void add_frame(const Keyframe& now);
  /// Hands the last part to the saver. Of a recording without a frame nothing is written.
  void save();
  /// Writes the one whole file, and takes the parts away. ERRORS: Failure(cannot_access), the parts stay.
  void finish();

 private:
  std::string first_path_;  // Of this one, and of those that go on after it.
  std::string path_;
  ScenarioSaver& saver_;
  Tape whole_;
  Tape part_;
  std::size_t part_number_ = 1;
  std::vector<std::string> part_paths_;
  bool is_saved_ = true;
};

/// The path if no file has it, else NAME-2.json or the next number that no file has.
[[nodiscard]] std::string free_path(const std::string& path);

/// A scenario's name from a file's: its stem, what a name may not hold replaced by `-`.
[[nodiscard]] std::string scenario_name_of(const std::string& path);

}  // namespace hyrax
