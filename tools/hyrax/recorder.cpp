#include "tools/hyrax/app.h"

#include <shlobj.h>

#include <utility>

#include "tools/files/atomic_file.h"
#include "tools/hyrax/report.h"

namespace hyrax {
namespace {

// "Documents\Hyrax", created if needed; the current folder if the user has no documents.
std::wstring recordings_folder() {
  PWSTR documents = nullptr;
  if (FAILED(SHGetKnownFolderPath(FOLDERID_Documents, 0, nullptr, &documents))) return L".";
  const std::wstring folder = std::wstring(documents) + L"\\Hyrax";
  CoTaskMemFree(documents);
  CreateDirectoryW(folder.c_str(), nullptr);
  return folder;
}

// A new file named by the local time, as just-happened-20261121-134455.json.
std::string new_path(const wchar_t* name) {
  SYSTEMTIME time{};
  GetLocalTime(&time);
  wchar_t stamp[32];
  wsprintfW(stamp, L"-%04d%02d%02d-%02d%02d%02d.json", time.wYear, time.wMonth, time.wDay, time.wHour,
            time.wMinute, time.wSecond);
  return free_path(to_utf8(recordings_folder() + L"\\" + name + stamp));
}

}  // namespace

Recorder::Recorder(Pet& pet, std::function<void(const std::string&)> notify)
    : pet_(pet), notify_(std::move(notify)) {}

void Recorder::start(const std::string& path) {
  const AtomicFile probe(path);  // Fails now if the file cannot be written.
  pet_.session().start_recording(path, saver_);
  saves_.done(clock_ticks());
}

void Recorder::start_new() {
  start(new_path(L"recording"));
  notify_("Recording to " + pet_.session().recording().path());
}

void Recorder::finish() {
  if (pet_.session().is_recording()) pet_.session().finish_recording();
}

void Recorder::save() {
  const std::string path = pet_.session().recording().path();
  finish();
  notify_("Saved as " + path);
}

void Recorder::save_just_happened() {
  const Tape tape = pet_.session().just_happened();
  if (tape.frames() == 0) return;
  const std::string path = new_path(L"just-happened");
  saver_.save(path, tape.scenario(scenario_name_of(path)));
  saver_.wait();
  notify_(saver_.take_failure().value_or("Saved as " + path));
}

void Recorder::save_if_due() {
  if (!pet_.session().is_recording()) return;
  Recording& recording = pet_.session().recording();
  if (recording.is_full()) return continue_in_new_file();
  if (!saves_.is_due(clock_ticks()) && !pet_.is_asleep()) return;
  saves_.done(clock_ticks());
  recording.save();
  const auto failure = saver_.take_failure();
  if (failure && *failure != last_failure_) notify_(last_failure_ = *failure);
}

void Recorder::continue_in_new_file() {
  try {
    pet_.session().continue_recording();
    notify_("The recording continues in " + pet_.session().recording().path());
  } catch (const Failure& failure) {
    notify_(failure.what());
  }
}

}  // namespace hyrax
