#include "tools/report/page_file.h"

#include <cassert>

#include "tools/files/failure.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr std::string_view kDataPlace = "{\"hyrax\":\"report data\"}";

// Inside a script element nothing but `<` can end it or begin a comment.
std::string script_text(const Json& data) {
  std::string text;
  for (const char c : to_text(data)) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

}  // namespace

void require_page() {
  if (page_template(PageKind::runs).empty())
    throw Failure(ExitCode::cannot_access,
                  "the report page is not part of this program; to build it in: tools/run SCENARIO --report "
                  "FILE.html, or "
                  "cmake with -DHYRAX_PAGE=ON");
}

void write_page_file(const std::string& path, PageKind kind, const Json& data) {
  require_page();
  std::string page(page_template(kind));
  const std::size_t place = page.find(kDataPlace);
  assert(place != std::string::npos);
  page.replace(place, kDataPlace.size(), script_text(data));
  write_text_file(path, page);
}

}  // namespace hyrax
