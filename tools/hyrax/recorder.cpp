#include "tools/hyrax/recorder.h"

#include <cassert>

#include "tools/files/failure.h"
#include "tools/platform/atomic_file.h"
#include "tools/platform/path.h"

namespace hyrax {

void Recorder::start(const std::string& path, std::int64_t ticks) {
  assert(!recording());
  const AtomicFile probe(path);  // Fails now if the file cannot be written.
  if (is_there(path)) refuse_input(path + ": exists already; name another file, or remove it first");
  recording().emplace(path, pet_.session().now(), saver_);
  saves_.done(ticks);
}

void Recorder::start_new(std::int64_t ticks) {
  const std::string path = system_.new_path("recording");
  start(path, ticks);
  system_.notify("Recording to " + path);
}

void Recorder::finish() {
  if (auto finished = std::exchange(recording(), std::nullopt)) finished->finish();
}

void Recorder::save() {
  try {
    recording()->finish();
  } catch (const Failure& failure) {
    return system_.notify(failure.what() + std::string("; the recording continues"));
  }
  system_.notify("Saved as " + std::exchange(recording(), std::nullopt)->path());
}

void Recorder::save_just_happened() {
  const Tape tape = pet_.session().just_happened();
  if (tape.frames() == 0) return;
  const std::string path = system_.new_path("just-happened");
  saver_.write(path, tape.scenario(scenario_name_of(path)));
  system_.notify("Saved as " + path);
}

void Recorder::continue_in_new_file() {
  Recording finished = *std::exchange(recording(), std::nullopt);
  std::string failure;
  try {
    finished.finish();  // First, to free the names of its parts.
  } catch (const Failure& refused) {
    failure = refused.what();
  }
  recording().emplace(finished.next(pet_.session().now()));
  system_.notify(failure.empty() ? "The recording continues in " + recording()->path() : failure);
}

void Recorder::save_if_due(std::int64_t ticks) {
  if (!recording()) return;
  if (recording()->is_full()) return continue_in_new_file();
  if (!saves_.is_due(ticks) && !pet_.is_asleep()) return;
  saves_.done(ticks);
  recording()->save();
  const auto failure = saver_.take_failure();
  if (failure && *failure != last_failure_) system_.notify(last_failure_ = *failure);
}

}  // namespace hyrax
