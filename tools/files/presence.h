// What stands at a path, asked without an exception.
#pragma once

#include <string>

namespace hyrax {

/// Whether something is there, or may be: where the system does not let us know, reading it will say why.
[[nodiscard]] bool is_there(const std::string& path);

/// Whether a folder is there; whether a file is, and no folder, device or pipe; whether a device or pipe is.
/// Links are followed.
[[nodiscard]] bool is_folder(const std::string& path);
[[nodiscard]] bool is_regular_file(const std::string& path);
[[nodiscard]] bool is_device_or_pipe(const std::string& path);

}  // namespace hyrax
