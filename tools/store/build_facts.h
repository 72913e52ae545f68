// What info says of a program: its build, this machine, its libraries.
#pragma once

#include "tools/files/json.h"

namespace hyrax {

/// Texts: version, compiler, flags, target, instruction_set, processor.
[[nodiscard]] Json::Object build_facts();
/// Texts: self_test, and the versions of what every program links.
[[nodiscard]] Json::Object library_facts();

}  // namespace hyrax
