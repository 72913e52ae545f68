#include "sim/trace/host/limits.h"

#include <signal.h>
#include <sys/resource.h>

#include <array>

extern "C" {                       // The sanitizers' libraries chose these names.
[[gnu::weak]] void __asan_init();  // NOLINT(bugprone-reserved-identifier)
[[gnu::weak]] void __tsan_init();  // NOLINT(bugprone-reserved-identifier)
}

namespace hyrax::trace {
namespace {

constexpr rlim_t kBytesMax = rlim_t{1} << 30;

alignas(16) std::array<char, 65536> signal_stack{};  // Endless recursion leaves none.

void end_by_signal(int signal) {
  switch (signal) {
    case SIGXCPU:
      end_because("over its limits: takes too long");
    case SIGXFSZ:
      end_because("over its limits: writes files");
    case SIGSEGV:
    case SIGBUS:
      end_because("over its limits: recursion without end, or memory that is not its own");
    default:
      end_because("over its limits: ends the program");
  }
}

void limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
  const rlimit limit{value, value + (resource == RLIMIT_CPU ? 5 : 0)};
  setrlimit(resource, &limit);
}

}  // namespace

bool limits_memory() { return __asan_init == nullptr && __tsan_init == nullptr; }

void limit_resources(unsigned cpu_s_max) {
  const stack_t stack{.ss_sp = signal_stack.data(), .ss_flags = 0, .ss_size = signal_stack.size()};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = end_by_signal;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGXCPU, SIGXFSZ, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    sigaction(signal, &action, nullptr);
  limit(RLIMIT_CPU, cpu_s_max);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, kBytesMax);
  if (limits_memory()) limit(RLIMIT_AS, kBytesMax);
}

}  // namespace hyrax::trace
