// What both recorders for one's own program share: the file, and when it is saved.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "tools/recorder/recording.h"

namespace hyrax {

/// Records as hyrax.exe does: about twice a second a thread saves what came, so that at most the last second
/// is lost however the program ends, and each file replays as it is. No file of the user's is replaced. What
/// goes wrong does not stop the program: see failure().
template <class AnyTape>
class ProgramRecorder {
 public:
  ProgramRecorder(const ProgramRecorder&) = delete;
  ProgramRecorder& operator=(const ProgramRecorder&) = delete;
  ~ProgramRecorder() { finish(); }

  /// Writes the complete file, in the place of its parts, and ends the recording.
  void finish() {
    if (recording_) attempt([&] { recording_->finish(); });
    recording_.reset();
  }
  [[nodiscard]] bool is_recording() const { return recording_.has_value(); }
  /// Of the file, UTF-8: where the given one existed, NAME-2.json or the next free number.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// What went wrong last, in a sentence; nothing: all is well.
  [[nodiscard]] const std::optional<std::string>& failure() const { return failure_; }

 protected:
  using Saver = SaverOf<typename AnyTape::Document>;
  using Start = typename AnyTape::Start;

  ProgramRecorder(const std::string& path,
                  std::function<std::string(const typename AnyTape::Document&)> text_of)
      : path_(free_path(path)), saver_(std::move(text_of)) {}

  void start(const Start& now) {
    attempt([&] {
      const AtomicFile probe(path_);  // Fails now if the file cannot be written.
      recording_.emplace(path_, now, saver_);
    });
  }
  /// Ends the recording, or has none begin; `what` is why.
  void stop(const std::string& what) {
    finish();
    failure_ = path_ + ": the recording ended: " + what;
  }
  void add_input(const typename AnyTape::Input& input) {
    if (recording_) recording_->add_input(input);
  }
  void add_frame(const Start& now) {
    recording_->add_frame(now);
    if (recording_->is_full()) {
      attempt([&] { recording_->finish(); });
      recording_.emplace(recording_->next(now));
      path_ = recording_->path();
    }
    const auto time = std::chrono::steady_clock::now();
    if (time < due_) return;
    due_ = time + std::chrono::milliseconds(1000 / RecordingOf<AnyTape>::kSavesPerSecond);
    recording_->save();
    if (auto failure = saver_.take_failure()) failure_ = std::move(failure);
  }

 private:
  void attempt(const auto& work) {
    try {
      work();
    } catch (const std::exception& error) {
      failure_ = error.what();
    }
  }

  std::string path_;
  std::optional<std::string> failure_;
  Saver saver_;
  std::optional<RecordingOf<AnyTape>> recording_;
  std::chrono::steady_clock::time_point due_ = {};
};

}  // namespace hyrax
