#include <filesystem>

#include "tools/hyrax-compare/card_output.h"
#include "tools/report/result_page.h"

namespace hyrax {

void write_card_page(const std::string& path, const std::string& command, const Card& card,
                     const CardTitle& title) {
  const CardText lines = card_lines(card);
  Table table{"card",
              compared_text(card),
              {column_of("line", "", "what is measured", lines, &CardLine::name),
               column_of("measured", "", "with its interval", lines, &CardLine::text)}};
  const auto name = [](const std::string& file) { return std::filesystem::path(file).filename().string(); };
  ShownResult result{
      .title = name(title.candidate) == name(title.base)
                   ? name(title.base) + ": candidate against base"
                   : name(title.candidate) + " against " + name(title.base),
      .subtitle = compared_text(card),
      .verdict = {.text = {consequence_of(card), std::move(table)}, .broken = {}},
      .tables = card_tables(card),
      .figures = card_figures(card),
      .origin = {{"candidate", title.candidate}, {"base", title.base}, {"seed", std::to_string(card.seed)}}};
  write_result_page(path, command, {result_json(result)});
}

}  // namespace hyrax
