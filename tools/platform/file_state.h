// What the system says of files: whether they can be used, which they are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace hyrax {

/// The error number with which reading a file, or making one in a folder, would fail; 0: it would not, or not
/// for a reason that shows before.
[[nodiscard]] int error_of_reading(const std::string& path);
[[nodiscard]] int error_of_writing_in(const std::string& folder);

/// Removes a file, or a link. @return the error number; 0: it is gone, or there was none.
[[nodiscard]] int error_of_removing(const std::string& path);

/// Two paths of one file have the same, links followed. Nothing: there is no file.
[[nodiscard]] std::optional<std::pair<std::uint64_t, std::uint64_t>> identity_of(const std::string& path);

/// Whether another program holds it locked, by the kind of lock that HDF5 takes. One that cannot be locked at
/// all is not.
[[nodiscard]] bool is_locked(const std::string& path);

}  // namespace hyrax
