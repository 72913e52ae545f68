#include <csignal>

#include "sim/trace/host/limits.h"

namespace hyrax::trace {

bool limits_memory() { return false; }

void limit_resources(unsigned /*cpu_s_max*/) {
  const auto end_by_signal = [](int signal) {
    end_because(signal == SIGSEGV ? "over its limits: recursion without end, or memory that is not its own"
                                  : "over its limits: ends the program");
  };
  for (const int signal : {SIGSEGV, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, end_by_signal);
}

}  // namespace hyrax::trace
