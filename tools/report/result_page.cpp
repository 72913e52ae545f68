#include "tools/report/result_page.h"

#include "tools/files/build_info.h"
#include "tools/report/figure_json.h"
#include "tools/report/page_file.h"

namespace hyrax {

Json result_json(const ShownResult& result) {
  Json::Array tables, figures;
  for (const Table& table : result.tables) tables.push_back(table_json(table));
  for (const Figure& figure : result.figures) figures.push_back(figure_json(figure));
  Json::Object origin;
  for (const auto& [name, value] : result.origin) origin.emplace_back(name, value);
  return Json::Object{{"title", result.title},         {"subtitle", result.subtitle},
                      {"judgement", result.judgement}, {"verdict", verdict_json(result.verdict)},
                      {"tables", std::move(tables)},   {"figures", std::move(figures)},
                      {"origin", std::move(origin)}};
}

void write_result_page(const std::string& path, const std::string& command, Json::Array results) {
  write_page_file(path, PageKind::results,
                  Json::Object{{"format", "hyrax-results/1"},
                               {"program", "hyrax-sim " + std::string(build_info().version)},
                               {"command", command},
                               {"results", std::move(results)}});
}

}  // namespace hyrax
