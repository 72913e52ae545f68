#include "tools/hyrax-compare/card_report.h"

#include <filesystem>

#include <fmt/format.h>

#include "tools/files/table_text.h"

namespace hyrax {
namespace {

const Table& lines_of(const Result& card) { return std::get<Table>(card.verdict.text.front()); }

}  // namespace

std::string card_text(const Result& card, const BeforeAfter<std::string>& headers) {
  const std::string lines = aligned_text(lines_of(card));
  return fmt::format("{} against {}\n  {}\n{}  {:<15} {}\n", headers.after, headers.before,
                     lines_of(card).long_name, lines.substr(lines.find('\n') + 1), "consequence",
                     card.verdict.brief);
}

std::string card_json(const Result& card, const BeforeAfter<std::string>& headers) {
  Json::Object object{{"candidate", headers.after}, {"base", headers.before}};
  add_members(object, card.summary);
  return to_text(std::move(object), 2) + "\n";
}

ShownResult shown_card(const Result& card, const BeforeAfter<std::string>& headers) {
  const std::string candidate = std::filesystem::path(headers.after).filename().string();
  const std::string base = std::filesystem::path(headers.before).filename().string();
  return {.title = candidate == base ? base + ": candidate against base" : candidate + " against " + base,
          .subtitle = lines_of(card).long_name,
          .verdict = verdict_json({.text = {card.verdict.brief, lines_of(card)}}),
          .tables = card.tables,
          .figures = card.figures,
          .origin = {{"candidate", headers.after}, {"base", headers.before}}};
}

}  // namespace hyrax
