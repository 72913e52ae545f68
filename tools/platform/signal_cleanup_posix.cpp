#include "tools/platform/signal_cleanup.h"

#include <array>
#include <atomic>
#include <csignal>

#include <unistd.h>

namespace hyrax {
namespace {

std::array<std::atomic<const char*>, 16> removed_paths{};
static_assert(std::atomic<const char*>::is_always_lock_free);

void replace_one(const char* from, const char* to) {
  for (std::atomic<const char*>& each : removed_paths)
    if (const char* expected = from; each.compare_exchange_strong(expected, to)) return;
}

// Allocates nothing.
void end_by(int signal) {
  for (const std::atomic<const char*>& removed : removed_paths)
    if (const char* const path = removed.load()) unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// A signal that is ignored is never handled, not for a moment either.
void handle_signals() {
  for (const int signal : kSignals) {
    struct sigaction now {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(signal, end_by);
  }
}

}  // namespace

void remove_on_signal(const std::string& path) {
  replace_one(nullptr, path.c_str());
  handle_signals();
}

void keep_on_signal(const std::string& path) { replace_one(path.c_str(), nullptr); }

SignalsHeld::SignalsHeld() {
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : kSignals) sigaddset(&held, signal);
  pthread_sigmask(SIG_BLOCK, &held, &before_);
}

}  // namespace hyrax
