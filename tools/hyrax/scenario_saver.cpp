#include "tools/hyrax/scenario_saver.h"

#include <cstdio>
#include <exception>

#include "tools/files/atomic_file.h"
#include "tools/files/failure.h"

namespace hyrax {

ScenarioSaver::ScenarioSaver(std::function<std::string(const Scenario&)> text_of)
    : text_of_(std::move(text_of)), thread_([this] { work(); }) {}

ScenarioSaver::~ScenarioSaver() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

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
  const bool is_new = made_.insert(path).second;
  lock.unlock();
  try {
    is_new ? file.commit_as_new() : file.commit();
  } catch (const Failure&) {
    lock.lock();
    if (is_new) made_.erase(path);
    throw;
  }
}

bool ScenarioSaver::has_made(const std::string& path) {
  const std::lock_guard lock(mutex_);
  return made_.contains(path);
}

void ScenarioSaver::remove(const std::string& path) {
  const std::lock_guard lock(mutex_);
  if (made_.erase(path) > 0) std::remove(path.c_str());
}

void ScenarioSaver::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty() && !is_busy_; });
}

std::optional<std::string> ScenarioSaver::take_failure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, std::nullopt);
}

void ScenarioSaver::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !jobs_.empty() || is_ending_; });
    if (jobs_.empty()) return;
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    is_busy_ = true;
    lock.unlock();
    std::optional<std::string> failure;
    try {
      write(job.path, job.scenario);
    } catch (const Failure& refused) {
      failure = refused.what();
    } catch (const std::exception& error) {  // As of too little memory: the program goes on.
      failure = job.path + ": cannot be written: " + error.what();
    }
    lock.lock();
    is_busy_ = false;
    if (failure) failure_ = failure;
    changed_.notify_all();
  }
}

}  // namespace hyrax
