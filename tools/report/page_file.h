// Writes a report page: the template of its kind with its data.
#pragma once

#include <string>
#include <string_view>

#include "tools/files/json.h"
#include "tools/report/page_template.h"

namespace hyrax {

/// Throws Failure(cannot_access) if this program was built without the pages, and says how to build them.
void require_page();

/// A text as HTML shows it.
[[nodiscard]] std::string html_text(std::string_view text);

/// @param still HTML that a browser without JavaScript shows instead of the page.
/// ERRORS: as require_page's; Failure(cannot_access) if `path` cannot be written.
void write_page_file(const std::string& path, PageKind kind, const Json& data, const std::string& still);

}  // namespace hyrax
