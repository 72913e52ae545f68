// Commands about scenario files that play none, for any core.
#pragma once

#include <functional>
#include <string>

#include "tools/app/command_line/options.h"

namespace hyrax {

/// What validate says of a good file.
struct GoodScenario {
  std::string name = {};
  std::int64_t steps = 0;
  std::size_t events = 0;
};

/// ERRORS: Failure where `run` refuses the file.
using ReadScenario = std::function<GoodScenario(const Core& core, const std::string& path)>;
[[nodiscard]] Command validate_command_of(ReadScenario read);
[[nodiscard]] Command schema_command_of(std::function<std::string()> schema);

}  // namespace hyrax
