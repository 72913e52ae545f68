// Reads a file of unknown origin in a child process first, so that it cannot harm this one.
#pragma once

#include <functional>
#include <string>

namespace hyrax {

/// Reads the file in a child process, with limits on time and memory in proportion to its size.
/// HDF5 1.10 checks little of what it reads: a damaged file can crash it, keep it in an endless loop, or make
/// it allocate any amount of memory. If the child survives, this process can read the same way.
/// Costs a fork: some milliseconds.
/// @param read must read all that this process will read; a Failure that it throws is ignored, since reading
/// here throws it again.
/// REQUIRES: this process has no other thread: the child would wait forever for a lock that one holds.
/// ERRORS: Failure(bad_input) "PATH: is damaged: ..." if the child did not survive; Failure(cannot_access) if
/// there is no child process, or its exit status is unknown, as in a process that ignores SIGCHLD.
void read_isolated(const std::string& path, const std::function<void()>& read);

}  // namespace hyrax
