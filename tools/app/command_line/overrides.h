// Values that --set replaces in a scenario.
#pragma once

#include <string>
#include <vector>

#include "tools/files/scenario_reader.h"

namespace hyrax {

/// @param command names the command in messages, as "hyrax-sim run".
/// ERRORS: Failure(bad_input) for a text that is not POINTER=VALUE.
[[nodiscard]] std::vector<Override> overrides_of(const std::string& command,
                                                 const std::vector<std::string>& texts);

}  // namespace hyrax
