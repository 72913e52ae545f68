#include "tools/report/result_page.h"

#include <algorithm>

#include "tools/files/build_info.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"
#include "tools/report/svg.h"

namespace hyrax {

Json result_json(const ShownResult& result) {
  Json::Object json = {
      {"title", result.title},
      {"subtitle", result.subtitle},
      {"judgement", result.judgement},
      {"verdict", result.verdict},
      {"tables", list_of(result.tables, [](const Table& table) { return table_json(table); })},
      {"figures", list_of(result.figures, figure_json)},
      {"origin", result.origin}};
  if (!result.members.is_null()) json.emplace_back("sweep", result.members);
  return json;
}

namespace {

// Title, verdict and figures.
std::string still_html(const std::vector<ShownResult>& results) {
  std::string html;
  const auto add = [&html](const std::string& tag, const std::string* text) {
    if (text != nullptr && !text->empty())
      html += "<" + tag + ">" + escaped(*text, true) + "</" + tag + ">\n";
  };
  for (const ShownResult& result : results) {
    add("h1", &result.title);
    add("p", &result.subtitle);
    for (const char* const key : {"broken", "text"})
      if (const auto* const lines = result.verdict.get<Json::Array>(key))
        for (const Json& line : *lines) add("pre", line.get<std::string>());
    add("p", &result.judgement);
    for (const Figure& figure : result.figures)
      html += "<h2>" + escaped(figure.title) + "</h2>\n<p>" + escaped(figure.subtitle) + "</p>\n" +
              figure_html(figure);
  }
  return html;
}

}  // namespace

void write_result_page(const std::string& path, const std::string& command,
                       const std::vector<ShownResult>& results) {
  const bool replays = !std::ranges::all_of(results, &Json::is_null, &ShownResult::members);
  write_page_file(path, replays ? PageKind::sweeps : PageKind::results,
                  Json::Object{{"format", "hyrax-results/1"},
                               {"program", "hyrax-sim " + std::string(build_info().version)},
                               {"command", command},
                               {"results", list_of(results, result_json)}},
                  still_html(results));
}

}  // namespace hyrax
