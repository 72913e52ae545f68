// Where the contacts of this program's core come from.
#pragma once

#include <string_view>

namespace hyrax {

class Kernel;

/// The core with the contacts of its recorded step (contact_kernel.h). What the build records says whether
/// core_kernel() is this one (tools/cmake/record_core.cmake): of a core whose step is the paper's no program
/// links any of it. Else all do, hyrax.exe and the page's core too: a state hash covers the contacts, and
/// what one of them plays or records must have that of the others.
[[nodiscard]] const Kernel& core_with_recorded_contacts();

/// Why the contacts of this program's core follow from its rows; empty: from its step.
[[nodiscard]] std::string_view why_contacts_from_rows();

}  // namespace hyrax
