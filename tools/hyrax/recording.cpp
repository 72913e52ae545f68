#include "tools/hyrax/recording.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <utility>

#include "tools/files/failure.h"
#include "tools/platform/atomic_file.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

char name_character(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  const bool is_allowed = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
  return is_allowed ? c : '-';
}

std::string numbered_path(const std::string& path, std::size_t number) {
  if (number == 1) return path;
  const FileName name = file_name(path);
  std::string numbered(name.folder);
  numbered.append(name.stem).append("-").append(std::to_string(number)).append(name.extension);
  return numbered;
}

}  // namespace

ScenarioSaver::ScenarioSaver(std::function<std::string(const Scenario&)> text_of)
    : text_of_(std::move(text_of)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

ScenarioSaver::~ScenarioSaver() = default;

void ScenarioSaver::save(const std::string& path, Scenario scenario) {
  {
    const std::lock_guard lock(mutex_);
    if (!jobs_.empty() && jobs_.back().path == path) jobs_.pop_back();
    jobs_.push_back({path, std::move(scenario)});
  }
  changed_.notify_all();
}

void ScenarioSaver::write(const std::string& path, const Scenario& scenario) {
  const std::string text = text_of_(scenario);
  AtomicFile file(path);
  file.write(text);
  std::unique_lock lock(mutex_);
  const bool is_new = written_.insert(path).second;
  lock.unlock();
  try {
    is_new ? file.commit_as_new() : file.commit();
  } catch (const Failure&) {
    lock.lock();
    if (is_new) written_.erase(path);
    throw;
  }
}

bool ScenarioSaver::has_written(const std::string& path) {
  const std::lock_guard lock(mutex_);
  return written_.contains(path);
}

void ScenarioSaver::remove(const std::string& path) {
  const std::lock_guard lock(mutex_);
  if (written_.erase(path) > 0) remove_file(path);
}

void ScenarioSaver::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty() && !is_busy_; });
}

std::optional<std::string> ScenarioSaver::take_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

void ScenarioSaver::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    if (!changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) return;
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    is_busy_ = true;
    lock.unlock();
    std::optional<std::string> failure;
    try {
      write(job.path, job.scenario);
    } catch (const Failure& refused) {
      failure = refused.what();
    } catch (const std::exception& error) {  // Such as out of memory: the program continues.
      failure = job.path + ": cannot be written: " + error.what();
    }
    lock.lock();
    is_busy_ = false;
    if (failure) failure_ = failure;
    changed_.notify_all();
  }
}

void Recording::add_input(const Action& action) {
  all_.add_input(action);
  part_.add_input(action);
}

void Recording::add_frame(const Keyframe& now) {
  assert(!is_full());
  all_.add_frame(now.row);
  part_.add_frame(now.row);
  is_saved_ = false;
  if (part_.frames() < kPartFrames) return;
  save();
  part_ = Tape(now);
  part_paths_.push_back(numbered_path(path_, ++part_number_));
}

void Recording::save() {
  if (is_saved_) return;
  std::string& path = part_paths_.back();
  while (is_there(path) && !saver_.has_written(path)) path = numbered_path(path_, ++part_number_);
  saver_.save(path, part_.scenario(scenario_name_of(path)));
  is_saved_ = true;
}

void Recording::finish() {
  save();  // All frames are kept if the complete file cannot be written.
  saver_.wait();
  if (all_.frames() == 0) return;
  try {
    saver_.write(path_, all_.scenario(scenario_name_of(path_)));
  } catch (const Failure& failure) {
    std::string kept;
    for (const std::string& path : part_paths_)
      if (saver_.has_written(path)) kept += (kept.empty() ? "; what was saved is in " : ", ") + path;
    throw Failure(failure.exit_code(), failure.what() + kept);
  }
  for (const std::string& path : part_paths_)
    if (path != path_) saver_.remove(path);
}

std::string free_path(const std::string& path) {
  std::size_t number = 1;
  while (is_there(numbered_path(path, number))) ++number;
  return numbered_path(path, number);
}

std::string scenario_name_of(const std::string& path) {
  std::string name;
  for (const char c : file_name(path).stem) name += name_character(c);
  name.resize(std::min<std::size_t>(name.size(), kNameLengthMax));
  return name.empty() ? "recording" : name;
}

}  // namespace hyrax
