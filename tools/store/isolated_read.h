// Reads a file of unknown origin in a child process first, so that it cannot harm this one.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hyrax {

/// Reads the file in a child process, with limits on time and memory in proportion to its size.
/// HDF5 1.10 checks little of what it reads: a damaged file can crash it, keep it in an endless loop, or make
/// it allocate any amount of memory. If the child survives, this process can read the same way.
/// Costs a fork: some milliseconds.
/// @param read must read all that this process will read; a Failure that it throws is ignored, since reading
/// here throws it again.
/// REQUIRES: this process has no other thread: the child would wait forever for a lock that one holds.
/// ERRORS: Failure(bad_input) "PATH: is damaged: ..." if the child did not survive; Failure(cannot_access) if
/// the file cannot be read, there is no child process, or its exit status is unknown, as in a process that
/// ignores SIGCHLD.
void read_isolated(const std::string& path, const std::function<void()>& read);

/// Reads many files in one child process, so that they cost one fork. If it survives, read_isolated does not
/// read them again as long as their size and time of change stay the same; else it reads each by itself.
/// @param read as that of read_isolated, of one path; it may call read_isolated.
/// REQUIRES: this process has no other thread.
void read_isolated_together(const std::vector<std::string>& paths,
                            const std::function<void(const std::string& path)>& read);

}  // namespace hyrax
