// What `bless` says of a report.
#pragma once

#include <string>

#include "tools/app/library/blessing.h"

namespace hyrax {

/// Why nothing is written, with the option that would allow it where there is one; empty: it is written.
[[nodiscard]] std::string refusal_sentence(const BlessReport& report);

/// Of a report that was written: that some, but not all of it was; else empty.
[[nodiscard]] std::string unfinished_sentence(const BlessReport& report);

/// What changes, old against new, by cause, and against the accepted cores.
void print_plans(const BlessReport& report, const BlessWords& words, const Printing& printing);

/// What was written, or would be.
void print_done(const BlessReport& report, bool is_dry_run);

[[nodiscard]] Json bless_json(const BlessReport& report, Json::Array groups);

}  // namespace hyrax
