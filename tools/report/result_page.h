// A page of results: the answer, the picture that decides it, then what it rests on. It is whole without
// JavaScript; only the members of sweeps need some.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/result/result.h"
#include "tools/files/json.h"
#include "tools/report/contact_sheet.h"

namespace hyrax {

/// One result, as a study, a sweep, a drift or a check hands it on.
struct ShownResult {
  std::string title;          ///< The answer.
  std::string subtitle = {};  ///< What was asked.
  Verdict verdict = {};       ///< Its text, without the answer, and the rules that are broken.
  std::string judgement =
      {};  ///< Where no rule is broken: "No rule of the study is broken."; empty: nothing.
  std::vector<RunPanel> panels = {};  ///< A sheet, first.
  std::vector<Table> tables = {};     ///< Folded. REQUIRES: no column of tables.
  std::vector<Figure> figures = {};   ///< The first decides; the others are folded.
  std::vector<std::pair<std::string, std::string>> origin = {};  ///< How it was made: names and values.
  Json members = {};  ///< A sweep's, which the page replays; null: none.
};

/// Writes one HTML file with these results. It needs no network and no other file; every text in it stays
/// text. Result K, from 0, has the id "result-K", to which panels may lead.
/// @param command what made the page.
/// ERRORS: Failure(cannot_access) if `path` cannot be written, or there are members and this program was
/// built without the pages that replay.
void write_result_page(const std::string& path, const std::string& command,
                       const std::vector<ShownResult>& results);

}  // namespace hyrax
