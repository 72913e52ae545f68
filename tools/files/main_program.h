// What every program's main does around its work.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/files/failure.h"

namespace hyrax {

/// Runs a program's work on the words of its command line; what it throws becomes a message on standard error
/// and an exit code, and so does standard output that cannot be written. @param name begins its messages.
/// @return the exit code for main.
[[nodiscard]] int run_program(const std::string& name, int argument_count, char** arguments,
                              const std::function<ExitCode(const std::vector<std::string>&)>& work);

}  // namespace hyrax
