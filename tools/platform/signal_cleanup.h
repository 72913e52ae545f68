// What the end of this program must not leave behind.
#pragma once

#include <csignal>
#include <string>

namespace hyrax {

/// From now on, SIGINT, SIGTERM and SIGHUP remove this file before they end the program. A signal that is
/// ignored, as by nohup, stays ignored. `path` must stay unchanged until keep_on_signal(path). At most 16
/// paths; those beyond are left to their owners.
void remove_on_signal(const std::string& path);
/// Takes back remove_on_signal(path): the same object, not an equal one.
void keep_on_signal(const std::string& path);

/// Holds these signals back from this thread as long as it lives: from before a file is made until
/// remove_on_signal.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

}  // namespace hyrax
