// The `expect` of a scenario document.
#pragma once

#include "sim/scenario/scenario.h"
#include "tools/files/json_reader.h"

namespace hyrax {

/// What is wrong is told to its place and left out.
[[nodiscard]] Expect read_expect(const JsonPlace& here);

}  // namespace hyrax
