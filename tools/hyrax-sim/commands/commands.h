// All commands: a new one is a file of its own, a line here and a line in main.
#pragma once

#include "tools/hyrax-sim/command_line/options.h"

namespace hyrax {

[[nodiscard]] Command run_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command bless_command();
[[nodiscard]] Command diff_command();
[[nodiscard]] Command drift_command();
[[nodiscard]] Command study_command();
[[nodiscard]] Command new_command();
[[nodiscard]] Command validate_command();
[[nodiscard]] Command schema_command();
[[nodiscard]] Command info_command();

}  // namespace hyrax
