// What a signal that ends the program must not leave behind.
#pragma once

#include <string>

namespace hyrax {

/// From now on, SIGINT, SIGTERM and SIGHUP remove this file, or this folder with what is in it, before they
/// end the program. A signal that is ignored, as by nohup, stays ignored. `path` must stay unchanged until
/// keep_on_signal(path). At most 16 paths; those beyond are left to their owners.
void remove_on_signal(const std::string& path);
/// Takes back remove_on_signal(path): the same object, not an equal one.
void keep_on_signal(const std::string& path);

/// Removes all that a signal would. For a handler that ends the program: allocates nothing.
void clean_up_for_signal() noexcept;

}  // namespace hyrax
