// The state hash in the text of a scenario file.
#pragma once

#include <string>
#include <string_view>

namespace hyrax {

/// The text with `expect.state_hash` set to `hash`, added where it is missing; every other byte is as it was.
/// REQUIRES: the text of a scenario that to_scenario accepts.
[[nodiscard]] std::string with_state_hash(std::string_view text, std::string_view hash);

}  // namespace hyrax
