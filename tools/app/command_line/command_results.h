// What a command did with scenarios, one by one.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "tools/files/failure.h"
#include "tools/files/json.h"
#include "tools/files/printable.h"

namespace hyrax {

/// The exit code and the JSON entries of a command. A failure of one scenario is printed and does not end the
/// others.
class CommandResults {
 public:
  /// Does the work; a failure becomes the entry {"scenario", "status": "failed", "error"}.
  template <class Work>
  void attempt(const std::string& path, const Work& work) {
    const auto failure = failure_of(path, work);
    if (!failure) return;
    add_failure(*failure);
    entries_.push_back(Json::Object{{"scenario", path}, {"status", "failed"}, {"error", failure->what()}});
  }

  /// Does work that follows on the last entry; a failure is added to that entry.
  template <class Work>
  void attempt_after(const Work& work, const std::string& path = "hyrax-sim") {
    const auto failure = failure_of(path, work);
    if (!failure) return;
    add_failure(*failure);
    if (entries_.empty()) return;
    Json::Object& entry = *entries_.back().get<Json::Object>();
    const auto status = std::ranges::find(entry, "status", &Json::Object::value_type::first);
    if (status != entry.end())
      status->second = "failed";
    else
      entry.emplace_back("status", "failed");
    entry.emplace_back("error", failure->what());
  }

  void add(Json entry) { entries_.push_back(std::move(entry)); }
  void add(ExitCode exit_code) { exit_code_ = more_serious(exit_code_, exit_code); }

  [[nodiscard]] ExitCode exit_code() const { return exit_code_; }
  /// {KEY: [entries]}; there are none any more.
  [[nodiscard]] Json take_json(const char* key) { return Json::Object{{key, std::move(entries_)}}; }

 private:
  void add_failure(const Failure& failure) {
    add(failure.exit_code());
    print_error(failure.what());
  }

  Json::Array entries_;
  ExitCode exit_code_ = ExitCode::agreed;
};

}  // namespace hyrax
