// The JSON Schema of a core's scenarios.
#pragma once

#include "sim/described/description.h"
#include "tools/files/json.h"

namespace hyrax {

/// For editors. It refuses what the reader refuses, except for rules that no schema can express.
[[nodiscard]] Json schema_json(const Description& description);

}  // namespace hyrax
