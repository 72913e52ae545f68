#include "tools/report/page_file.h"

#include <fmt/format.h>

#include <cassert>

#include "tools/files/failure.h"
#include "tools/files/text_file.h"
#include "tools/report/svg.h"

namespace hyrax {
namespace {

constexpr std::string_view kDataPlace = "{\"hyrax\":\"report data\"}";
constexpr std::string_view kStillPlace = "<!--without JavaScript-->";
constexpr std::string_view kSheetPlace = "<!--sheet-->";

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

std::string_view page_core_fingerprint() {
  constexpr std::string_view kBegin = " data-fingerprint=\"";
  const std::string_view page = page_template(PageKind::runs);
  const std::size_t place = page.find(kBegin);
  if (place == std::string_view::npos) return {};
  const std::size_t begin = place + kBegin.size();
  return page.substr(begin, page.find('"', begin) - begin);
}

void require_page() {
  if (page_template(PageKind::runs).empty())
    throw Failure(ExitCode::cannot_access,
                  "the report page is not part of this program; to build it in: tools/run SCENARIO --report "
                  "FILE.html, or cmake with -DHYRAX_PAGE=ON");
}

std::string html_line(std::string_view tag, std::string_view text) {
  return text.empty() ? "" : fmt::format("<{0}>{1}</{0}>\n", tag, escaped(text, true));
}

void write_page_file(const std::string& path, PageKind kind, const Json& data, const std::string& still,
                     const std::string& sheet) {
  require_page();
  std::string page(page_template(kind));
  const auto put = [&page](std::string_view at, const std::string& text) {
    const std::size_t place = page.find(at);
    assert(place != std::string::npos);
    page.replace(place, at.size(), text);
  };
  put(kDataPlace, script_text(data));
  put(kStillPlace, still);
  if (!sheet.empty()) put(kSheetPlace, sheet);
  write_text_file(path, page);
}

}  // namespace hyrax
