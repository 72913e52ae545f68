// A program that is started, waited for and, if it takes too long, ended.
#pragma once

#include <string>
#include <vector>

namespace hyrax {

/// How a program ended.
struct ChildEnd {
  int exit_code = 0;  ///< 128 + the signal's number if a signal ended it, as a shell says it.
  bool is_timed_out = false;
  std::string out;  ///< What it printed on standard output ...
  std::string err;  ///< ... and on standard error.
};

/// Starts a program without input and waits for its end. After `limit_s` it and what it started are killed;
/// what it left running when it ended is killed, too.
/// @param arguments the program, searched for in PATH if it is a bare name, and its arguments.
/// ERRORS: Failure(cannot_access) "PROGRAM: cannot be started: REASON".
[[nodiscard]] ChildEnd run_child(const std::vector<std::string>& arguments, double limit_s);

/// "exit code 3", "signal 11 (exit code 139)", "no end within 10 s".
[[nodiscard]] std::string end_text(const ChildEnd& end, double limit_s);

/// A new folder in $TMPDIR or /tmp, removed with what is in it.
class TemporaryFolder {
 public:
  /// ERRORS: Failure(cannot_access).
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Writes a file of that name in it; returns its path. ERRORS: Failure(cannot_access).
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

}  // namespace hyrax
