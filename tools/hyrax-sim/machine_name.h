// What this machine's processor calls itself.
#pragma once

#include <string>

namespace hyrax {

/// "unknown processor" where the system does not tell.
[[nodiscard]] std::string machine_name();

}  // namespace hyrax
