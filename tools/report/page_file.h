// Writes a report page: the template of its kind with its data.
#pragma once

#include <string>

#include "tools/files/json.h"
#include "tools/report/page_template.h"

namespace hyrax {

/// Throws Failure(cannot_access) if this program was built without the pages, and says how to build them.
void require_page();

/// ERRORS: as require_page's; Failure(cannot_access) if `path` cannot be written.
void write_page_file(const std::string& path, PageKind kind, const Json& data);

}  // namespace hyrax
