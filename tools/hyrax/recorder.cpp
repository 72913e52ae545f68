#include "tools/hyrax/recorder.h"

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"

namespace hyrax {

void Recorder::start(const std::string& path, std::int64_t ticks) {
  const AtomicFile probe(path);  // Fails now if the file cannot be written.
  pet_.session().start_recording(path, saver_);
  saves_.done(ticks);
}

void Recorder::start_new(std::int64_t ticks) {
  start(system_.new_path("recording"), ticks);
  system_.notify("Recording to " + pet_.session().recording().path());
}

void Recorder::finish() {
  if (pet_.session().is_recording()) pet_.session().finish_recording();
}

void Recorder::save() {
  const std::string path = pet_.session().recording().path();
  finish();
  system_.notify("Saved as " + path);
}

void Recorder::save_just_happened() {
  const Tape tape = pet_.session().just_happened();
  if (tape.frames() == 0) return;
  const std::string path = system_.new_path("just-happened");
  saver_.write(path, tape.scenario(scenario_name_of(path)));
  system_.notify("Saved as " + path);
}

void Recorder::save_if_due(std::int64_t ticks) {
  if (!pet_.session().is_recording()) return;
  Recording& recording = pet_.session().recording();
  if (recording.is_full()) return continue_in_new_file();
  if (!saves_.is_due(ticks) && !pet_.is_asleep()) return;
  saves_.done(ticks);
  recording.save();
  const auto failure = saver_.take_failure();
  if (failure && *failure != last_failure_) system_.notify(last_failure_ = *failure);
}

void Recorder::continue_in_new_file() {
  try {
    pet_.session().continue_recording();
    system_.notify("The recording continues in " + pet_.session().recording().path());
  } catch (const Failure& failure) {
    system_.notify(failure.what());
  }
}

}  // namespace hyrax
