// A page of results: verdicts, tables and figures, of whatever found them.
#pragma once

#include <string>
#include <vector>

#include "tools/report/figure_json.h"

namespace hyrax {

/// One result, as a study, a sweep or a comparison hands it on.
struct ShownResult {
  std::string title = {};
  std::string subtitle = {};   ///< What it is, in a sentence.
  std::string judgement = {};  ///< In a few words, as "no rule is broken"; empty: what is broken is counted.
  Json verdict = verdict_json({});  ///< Nothing broken: the judgement is shown as good.
  std::vector<Table> tables = {};   ///< REQUIRES: no column of tables.
  std::vector<Figure> figures = {};
  Json::Object origin = {};  ///< How it was made: names and values.
  Json members = {};         ///< A sweep's, which the page replays; null: none.
};

/// A result as the page reads it.
[[nodiscard]] Json result_json(const ShownResult& result);

/// Writes one HTML file with these results. Without JavaScript it shows their titles, verdicts and figures.
/// It needs no network and no other file; every text in it stays text.
/// @param command what made the page.
/// ERRORS: Failure(cannot_access) if this program was built without the page, or `path` cannot be written.
void write_result_page(const std::string& path, const std::string& command,
                       const std::vector<ShownResult>& results);

}  // namespace hyrax
