// Reading a file that may be made to harm its reader: in a child process first.
#pragma once

#include <functional>
#include <string>

namespace hyrax {

/// Reads the file in a child process, under limits on time and memory in proportion to its size.
/// HDF5 1.10 checks little of what it is given: a damaged file can crash it, keep it busy for ever,
/// or make it ask for any amount of memory. What a child survived, this process can read the same way.
/// Costs a fork: some milliseconds.
/// @param read must do to the file all that is to be done here; what it throws as a Failure is left
/// for the reading here to find again.
/// REQUIRES: this process has no other thread: the child would wait for ever for a lock that one holds.
/// ERRORS: Failure(bad_input) "PATH: is damaged: ..." where the child did not survive;
/// Failure(cannot_access) where no child can be made, or where its outcome is not known, as in a process
/// that ignores SIGCHLD.
void read_on_trial(const std::string& path, const std::function<void()>& read);

}  // namespace hyrax
