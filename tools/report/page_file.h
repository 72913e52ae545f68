// The report pages: templates without data, and a page written from one.
#pragma once

#include <string>
#include <string_view>

#include "tools/files/json.h"

namespace hyrax {

/// Each page carries only what it shows.
enum class PageKind {
  runs,   ///< Replays trajectories: the core as WebAssembly, charts over time.
  sweeps  ///< Results, and the members of sweeps, which it replays.
};

/// The page with an empty place for its data; empty if this program was built without it (the CMake option
/// HYRAX_PAGE).
[[nodiscard]] std::string_view page_template(PageKind kind);

/// fingerprint_of the core that the page of runs replays, as text; empty if the program has no pages.
[[nodiscard]] std::string_view page_core_fingerprint();

/// Throws Failure(cannot_access) if this program was built without the pages, and says how to build them.
void require_page();

/// A text as an HTML element with a line end; empty for none. Its own line ends stay.
[[nodiscard]] std::string html_line(std::string_view tag, std::string_view text);

/// @param still HTML: of runs what a browser without JavaScript shows instead of the page, of sweeps the
/// results. @param sheet of several runs: comes first.
/// ERRORS: as require_page's; Failure(cannot_access) if `path` cannot be written.
void write_page_file(const std::string& path, PageKind kind, const Json& data, const std::string& still,
                     const std::string& sheet = {});

}  // namespace hyrax
