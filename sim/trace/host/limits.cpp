#include "sim/trace/host/limits.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <exception>
#include <new>

#include "sim/trace/host/recorder.h"

extern "C" {                       // The sanitizers' libraries chose these names.
[[gnu::weak]] void __asan_init();  // NOLINT(bugprone-reserved-identifier)
[[gnu::weak]] void __tsan_init();  // NOLINT(bugprone-reserved-identifier)
}

namespace hyrax::trace {
namespace {

constexpr rlim_t kBytesMax = rlim_t{1} << 30;

std::array<char, 4096> why_path{};
alignas(16) std::array<char, 65536> signal_stack{};  // Endless recursion leaves none.

[[noreturn]] void end_because(const char* why) {
  const int file = open(why_path.data(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  [[maybe_unused]] const auto written = write(file, why, std::strlen(why));
  _exit(0);
}

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

void end_by_exception() {
  try {
    std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    end_because("over its limits: more than 1 GB of memory");
  } catch (...) {
    end_because("over its limits: throws an exception");
  }
}

void limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
  const rlimit limit{value, value + (resource == RLIMIT_CPU ? 5 : 0)};
  setrlimit(resource, &limit);
}

}  // namespace

bool limits_memory() { return __asan_init == nullptr && __tsan_init == nullptr; }

void limit_process(const std::string& why_file, unsigned cpu_s_max) {
  if (why_file.size() >= why_path.size()) end_because("over its limits: a path of more than 4,095 bytes");
  std::strcpy(why_path.data(), why_file.c_str());
  set_stop_handler([](const char* why) { end_because(why); });
  std::set_terminate(end_by_exception);
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
