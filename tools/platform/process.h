// This process: its signals and limits, and what it runs on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace hyrax {

/// At the start of a program: a file that may not grow further is an error like a full disk, which does not
/// end the process, and the exit status of a child process is not lost, whatever the parent process left
/// ignored.
void prepare_signals();

/// So many files beside a few others may be open at once, if the system allows it.
void allow_open_files(std::size_t count);

/// How many addresses this process may use; nothing: as many as there are.
[[nodiscard]] std::optional<std::uint64_t> address_space_bytes_max();

/// The processor time that this thread has used; on Windows, whose clock of it has ticks of 16 ms, a time
/// that passes.
[[nodiscard]] std::int64_t thread_time_ns();

[[nodiscard]] std::string processor_name();

/// Where programs keep what they can do without: $XDG_CACHE_HOME or ~/.cache, as the XDG Base Directory
/// Specification has it (a relative path counts as none), or %LOCALAPPDATA%. Empty: there is none.
[[nodiscard]] std::string cache_folder();

}  // namespace hyrax
