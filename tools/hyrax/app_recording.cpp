// How the program keeps what happens.
#include <shlobj.h>

#include "tools/files/atomic_file.h"
#include "tools/hyrax/app.h"
#include "tools/hyrax/report.h"

namespace hyrax {
namespace {

// Twice a second: what a save holds is on the disk before it is a second old.
constexpr std::int64_t kSavesPerSecond = 2;

// "Documents\Hyrax", made if need be; the current folder where the user has no documents.
std::wstring recordings_folder() {
  PWSTR documents = nullptr;
  if (FAILED(SHGetKnownFolderPath(FOLDERID_Documents, 0, nullptr, &documents))) return L".";
  const std::wstring folder = std::wstring(documents) + L"\\Hyrax";
  CoTaskMemFree(documents);
  CreateDirectoryW(folder.c_str(), nullptr);
  return folder;
}

// A new file named by the time of day, as in just-happened-20261121-134455.json.
std::string new_path(const wchar_t* name) {
  SYSTEMTIME time{};
  GetLocalTime(&time);
  wchar_t stamp[32];
  wsprintfW(stamp, L"-%04d%02d%02d-%02d%02d%02d.json", time.wYear, time.wMonth, time.wDay, time.wHour,
            time.wMinute, time.wSecond);
  return free_path(to_utf8(recordings_folder() + L"\\" + name + stamp));
}

}  // namespace

void App::start_recording(const std::string& path) {
  const AtomicFile probe(path);  // So that a place where nothing can be written is told now.
  pet_.session().start_recording(path, saver_);
  next_save_ticks_ = clock_ticks() + clock_ticks_per_s() / kSavesPerSecond;
}

void App::start_new_recording() {
  start_recording(new_path(L"recording"));
  tell("Recording to " + pet_.session().recording().path());
}

void App::finish_recording() {
  if (pet_.session().is_recording()) pet_.session().finish_recording();
}

void App::save_recording() {
  const std::string path = pet_.session().recording().path();
  finish_recording();
  tell("Saved as " + path);
}

void App::continue_recording() {
  try {
    pet_.session().continue_recording();
    tell("The recording continues in " + pet_.session().recording().path());
  } catch (const Failure& failure) {
    tell(failure.what());
  }
}

// The icon is gone while the window is closed with a message box still open.
void App::tell(const std::string& sentence) const {
  if (tray_) tray_->tell(sentence);
}

void App::save_just_happened() {
  const Tape tape = pet_.session().just_happened();
  if (tape.frames() == 0) return;
  const std::string path = new_path(L"just-happened");
  saver_.save(path, tape.scenario(scenario_name_of(path)));
  saver_.wait();
  tell(saver_.take_failure().value_or("Saved as " + path));
}

void App::save_if_due() {
  if (!pet_.session().is_recording()) return;
  Recording& recording = pet_.session().recording();
  if (recording.is_full()) return continue_recording();
  if (clock_ticks() < next_save_ticks_ && !pet_.is_asleep()) return;
  next_save_ticks_ = clock_ticks() + clock_ticks_per_s() / kSavesPerSecond;
  recording.save();
  const auto failure = saver_.take_failure();
  if (failure && *failure != told_) tell(told_ = *failure);
}

}  // namespace hyrax
