// What the build recorded of this program's core.
#pragma once

#include <string_view>

namespace hyrax {

/// Embedded by the build, from the header that sim/replay/kernel.cpp (or a core of one's own) compiles.
struct CoreRecord {
  std::string_view header;          ///< Its bytes.
  std::string_view step;            ///< Its canonical text (sim/trace/step_text.h); empty: not complete.
  std::string_view why_incomplete;  ///< As "more than 4,096 paths"; empty: complete.
};
[[nodiscard]] const CoreRecord& core_record();

}  // namespace hyrax
