// The report pages without their data.
#pragma once

#include <string_view>

namespace hyrax {

/// Each page carries only what it shows.
enum class PageKind {
  runs,     ///< Replays trajectories: the core as WebAssembly, charts over time.
  results,  ///< Verdicts, tables and figures: of studies.
  sweeps    ///< The same, and the members of sweeps, which it replays.
};

/// The page with an empty place for its data; empty if this program was built without it (the CMake option
/// HYRAX_PAGE).
[[nodiscard]] std::string_view page_template(PageKind kind);

/// fingerprint_of the core that the page of runs replays, as text. REQUIRES: the program has that page.
[[nodiscard]] std::string_view page_core_fingerprint();

}  // namespace hyrax
