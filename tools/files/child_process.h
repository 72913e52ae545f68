// A program that is started, waited for and, if it takes too long, ended.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyrax {

struct ChildEnd {
  int exit_code = 0;  ///< 128 + the signal's number if a signal ended it, as a shell says it.
  bool is_timed_out = false;
  std::string out;  ///< What it printed first on standard output ...
  std::string err;  ///< ... and on standard error.
};

/// Starts a program and waits for its end. After `limit_s` it and what it started are killed; what it left
/// running when it ended is killed, too, and all of it if a signal ends this process. The input is a file in
/// memory, and all output is read: neither side waits for the other, however long they are.
/// @param arguments the program, searched for in PATH if it is a bare name, and its arguments.
/// @param input what the program reads.
/// @param limit_s no limit if empty.
/// @param out_bytes_max of its output so many bytes are kept, the first ones; of its messages the first 64
/// KiB. ERRORS: Failure(cannot_access) "PROGRAM: cannot be started: REASON".
[[nodiscard]] ChildEnd run_child(const std::vector<std::string>& arguments, std::string_view input,
                                 std::optional<double> limit_s, std::size_t out_bytes_max = 64 << 20);

/// "exit code 3", "signal 11 (exit code 139)", "no end within 10 s".
[[nodiscard]] std::string end_text(const ChildEnd& end, double limit_s);

}  // namespace hyrax
