// Work that may crash, not end, or need another layout in memory: done in a child process, so that it cannot
// harm this one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hyrax {

/// What a child process may use; nothing: as much as this one.
struct ChildLimits {
  std::optional<double> wall_s = {};
  std::optional<std::uint64_t> processor_s = {};
  std::optional<std::uint64_t> memory_bytes = {};  ///< More than is in use already.
  bool is_silent = true;                           ///< What it prints on standard error is dropped.
};

struct WorkEnd {
  /// What the work returned. Nothing: it ended its process, or a signal did.
  std::optional<std::string> result;
  int signal = 0;

  /// Whether a limit of time was the reason.
  [[nodiscard]] bool is_timed_out() const;
  /// "signal 11 (SIGSEGV)"; empty: none ended it.
  [[nodiscard]] std::string signal_text() const;
};

/// Whether in_child guards this process: not on Windows, which has no fork. There the work is done in this
/// process: it has no limits, and what ends it ends this process.
[[nodiscard]] bool guards_work();

/// Does the work in a copy of this process, which ends with it or before it. Costs a fork: some milliseconds.
/// The copy has no ignored or blocked signals: what crashes ends it, whoever started this program.
/// @param what begins the messages.
/// REQUIRES: this process has no other thread, since the copy would wait forever for a lock that one holds;
/// the work throws nothing (it ends the copy by a signal).
/// ERRORS: Failure(cannot_access) if there is no child process, or its exit status is unknown, as in a
/// process that ignores SIGCHLD.
[[nodiscard]] WorkEnd in_child(const std::string& what, const ChildLimits& limits,
                               const std::function<std::string()>& work);

/// Starts this program again, as a process that shares no memory with this one: code, stack and heap lie
/// elsewhere (address-space layout randomisation), on other pages of memory. Costs the start of a program.
/// @param arguments the first is the program's name. @return as its result what it printed on standard
/// output, if its exit code is 0. ERRORS: as in_child. REQUIRES: standard output is open.
[[nodiscard]] WorkEnd in_new_process(const std::string& what, std::vector<std::string> arguments);

/// What another program, the first word, looked for in PATH, printed on standard output, if its exit code was
/// 0; it says nothing else.
[[nodiscard]] std::optional<std::string> printed_by(std::vector<std::string> words);

/// In the work, where it is guarded: from now on it may take so long, whatever its limit was.
void limit_wall_time(double limit_s);

}  // namespace hyrax
