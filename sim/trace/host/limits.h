// A process that may run another person's header.
#pragma once

#include <string>

namespace hyrax::trace {

/// Whether limit_process limits memory: sanitizers reserve more addresses than there is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#elif defined(__has_feature)
inline constexpr bool kLimitsMemory = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
inline constexpr bool kLimitsMemory = true;
#endif

/// From now on this process has limits of time and memory. If it meets one, throws, crashes or calls stop(),
/// it writes the reason to `why_file` and ends with exit code 0.
void limit_process(const std::string& why_file, unsigned cpu_s_max = 10);

}  // namespace hyrax::trace
