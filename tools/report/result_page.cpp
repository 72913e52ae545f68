#include "tools/report/result_page.h"

#include <algorithm>

#include "tools/files/build_info.h"
#include "tools/report/figure_json.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"

namespace hyrax {

Json result_json(const ShownResult& result) {
  Json::Object origin;
  for (const auto& [name, value] : result.origin) origin.emplace_back(name, value);
  return Json::Object{
      {"title", result.title},
      {"subtitle", result.subtitle},
      {"judgement", result.judgement},
      {"verdict", verdict_json(result.verdict)},
      {"tables", list_of(result.tables, [](const Table& table) { return table_json(table); })},
      {"figures", list_of(result.figures, figure_json)},
      {"origin", std::move(origin)}};
}

namespace {

// Title, verdict and figures.
std::string still_html(const Json::Array& results) {
  std::string html;
  const auto add = [&html](const char* tag, const Json* text) {
    const auto* const given = text == nullptr ? nullptr : text->get<std::string>();
    if (given != nullptr && !given->empty())
      html += "<" + std::string(tag) + ">" + html_text(*given) + "</" + tag + ">\n";
  };
  for (const Json& result : results) {
    add("h1", result.find("title"));
    add("p", result.find("subtitle"));
    const Json* const verdict = result.find("verdict");
    for (const char* const key : {"broken", "text"}) {
      const Json* const lines = verdict == nullptr ? nullptr : verdict->find(key);
      const auto* const list = lines == nullptr ? nullptr : lines->get<Json::Array>();
      if (list == nullptr) continue;
      for (const Json& line : *list) add("pre", &line);
    }
    add("p", result.find("judgement"));
    const Json* const figures = result.find("figures");
    if (figures == nullptr) continue;
    for (const Figure& figure : figures_of(*figures, "figures"))
      html += "<h2>" + html_text(figure.title) + "</h2>\n<p>" + html_text(figure.subtitle) + "</p>\n" +
              figure_html(figure);
  }
  return html;
}

}  // namespace

bool has_members(const Json& result) { return result.find("sweep") != nullptr; }

void write_result_page(const std::string& path, const std::string& command, Json::Array results) {
  const bool replays = std::any_of(results.begin(), results.end(), has_members);
  const std::string still = still_html(results);
  write_page_file(path, replays ? PageKind::sweeps : PageKind::results,
                  Json::Object{{"format", "hyrax-results/1"},
                               {"program", "hyrax-sim " + std::string(build_info().version)},
                               {"command", command},
                               {"results", std::move(results)}},
                  still);
}

}  // namespace hyrax
