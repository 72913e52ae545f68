// What the end of this program must not leave behind, and what a signal prints.
#pragma once

#include <string>

#include <sys/types.h>

namespace hyrax {

/// From now on, SIGINT, SIGTERM and SIGHUP remove this file, or this folder with what is in it, before they
/// end the program. A signal that is ignored, as by nohup, stays ignored. `path` must stay unchanged until
/// keep_on_signal(path). At most 16 paths; those beyond are left to their owners.
void remove_on_signal(const std::string& path);
/// Takes back remove_on_signal(path): the same object, not an equal one.
void keep_on_signal(const std::string& path);

/// From now on those signals kill this process group first. At most 256 groups.
void kill_group_on_signal(int group);
/// Takes it back. Before its leader is reaped: another group may get the number then.
void spare_group_on_signal(int group);

/// Until say_on_signal(nullptr), those signals print this text on standard error before they end the program.
/// It must stay unchanged until the next call. Only the thread that calls may take signals.
void say_on_signal(const char* text);

/// fork(), but the child process is killed when this one ends, even by SIGKILL: a copy would keep what this
/// one has open and locked. As fork, -1 with errno if there is none.
[[nodiscard]] pid_t fork_until_end();

/// Removes all that a signal would. For a handler that ends the program: allocates nothing.
void clean_up_for_signal() noexcept;

}  // namespace hyrax
