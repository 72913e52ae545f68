// A process that may run another person's header.
#pragma once

#include <string>

namespace hyrax::trace {

/// Whether limit_process limits memory: sanitizers, with which the header's part of the program may be
/// compiled, reserve more addresses than there is.
[[nodiscard]] bool limits_memory();

/// From now on this process has limits of time and memory. If it meets one, throws, crashes or calls stop(),
/// it writes the reason to `why_file` and ends with exit code 0.
void limit_process(const std::string& why_file, unsigned cpu_s_max = 10);

/// Of limit_process: what differs between systems. On Windows there are no limits; a crash is noticed.
void limit_resources(unsigned cpu_s_max);
/// Of limit_process: writes the reason, and ends this process.
[[noreturn]] void end_because(const char* why);

}  // namespace hyrax::trace
