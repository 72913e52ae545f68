#include "tools/report/result_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "base_css.h"
#include "look_css.h"
#include "pictures_js.h"
#include "results_css.h"
#include "sim/result/number_text.h"
#include "tools/files/build_info.h"
#include "tools/files/table_text.h"
#include "tools/files/text_file.h"
#include "tools/report/figure_svg.h"
#include "tools/report/page_file.h"
#include "tools/report/svg.h"

namespace hyrax {
namespace {

constexpr std::size_t kRowsShown = 500;

std::string folded(std::string_view summary, const std::string& html) {
  return fmt::format("<details class=\"data\"><summary>{}</summary>\n{}</details>\n", escaped(summary), html);
}

std::string table_html(const Table& table, std::string_view name) {
  std::string head, lines;
  std::vector<std::vector<std::string>> columns;
  for (const Column& column : table.columns) {
    columns.push_back(printed_values(column));
    const std::string text = printed_head(column);
    head += fmt::format("<{}{} title=\"{}\">{}", text.empty() ? "td" : "th scope=\"col\"",
                        is_text(column) ? " class=\"text\"" : "", escaped(column.long_name), escaped(text));
  }
  const std::size_t shown = std::min(row_count(table), kRowsShown);
  for (std::size_t row = 0; row < shown; ++row) {
    lines += "<tr>";
    for (std::size_t column = 0; column < columns.size(); ++column)
      lines += fmt::format("<td{}>{}", is_text(table.columns[column]) ? " class=\"text\"" : "",
                           escaped(columns[column][row]));
    lines += "\n";
  }
  std::string html = fmt::format(
      "<div class=\"table\" tabindex=\"0\" role=\"group\" "
      "aria-label=\"{}\"><table><thead><tr>{}</tr></thead>\n"
      "<tbody>\n{}</tbody></table></div>\n",
      escaped(name), head, lines);
  if (shown < row_count(table))
    html += html_line("p", fmt::format("The first {} of {}.", shown, counted(row_count(table), "row")));
  return html;
}

// Sentences, and each table folded under the sentence before it.
std::string findings_html(const decltype(Verdict::text)& text) {
  std::string html, before;
  for (const auto& part : text) {
    if (const auto* const table = std::get_if<Table>(&part)) {
      const std::string name =
          before.empty() ? table->long_name : before.substr(0, before.find_last_not_of(':') + 1);
      html += folded(name, table_html(*table, name));
      before.clear();
      continue;
    }
    html += html_line("p", before);
    before = std::get<std::string>(part);
    before.erase(0, before.find_first_not_of(" \n"));
  }
  return html + html_line("p", before);
}

// With its title, unless that stands above it already.
std::string figure_element(const Figure& figure, std::string_view above) {
  std::string html = "<figure class=\"figure\">\n" +
                     html_line("h2", figure.title == above ? "" : figure.title) +
                     html_line("p", figure.subtitle) + html_line("p", figure.note) + figure_html(figure);
  for (const std::string& remark : figure.remarks) html += html_line("p", remark);
  return html + "</figure>\n";
}

std::string rules_html(const ShownResult& result) {
  const std::vector<std::string>& broken = result.verdict.broken;
  if (broken.empty() && result.judgement.empty()) return "";
  if (broken.empty()) return "<p class=\"good\">" + escaped(result.judgement) + "</p>\n";
  std::string html = fmt::format("<section class=\"bad\"><p>{}</p>\n<ul>\n", counted(broken.size(), "fault"));
  for (const std::string& sentence : broken) html += html_line("li", sentence);
  return html + "</ul></section>\n";
}

std::string result_html(const ShownResult& result, std::size_t place, const std::string& command) {
  std::string html = fmt::format("<article class=\"result\" id=\"result-{}\">\n", place) +
                     html_line("h1", result.title) + html_line("p", result.subtitle);
  if (!result.panels.empty()) html += contact_sheet_html(result.panels, false);
  if (!result.figures.empty()) html += figure_element(result.figures.front(), result.title);
  html += "<section class=\"findings\">\n" + findings_html(result.verdict.text);
  for (std::size_t index = 1; index < result.figures.size(); ++index)
    html += folded(result.figures[index].title,
                   figure_element(result.figures[index], result.figures[index].title));
  for (const Table& table : result.tables)
    html += folded(fmt::format("{}: {}, {}", table.name, table.long_name, counted(row_count(table), "row")),
                   table_html(table, table.long_name));
  html += "</section>\n" + rules_html(result) + "<dl class=\"origin\">\n";
  auto origin = result.origin;
  origin.insert(origin.begin(),
                {{"command", command}, {"program", "hyrax-sim " + std::string(build_info().version)}});
  for (const auto& [name, value] : origin) html += html_line("dt", name) + html_line("dd", value);
  return html + "</dl>\n</article>\n";
}

constexpr std::string_view kPage =
    R"(<!doctype html>
<html lang="en" data-replay="none" data-ready="">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:">
<title>{}</title>
<style>{}{}{}</style>
</head>
<body>
<main>
{}</main>
<script>{}</script>
</body>
</html>
)";

}  // namespace

void write_result_page(const std::string& path, const std::string& command,
                       const std::vector<ShownResult>& results) {
  std::string html;
  for (std::size_t place = 0; place < results.size(); ++place)
    html += result_html(results[place], place, command);
  if (std::ranges::all_of(results, &Json::is_null, &ShownResult::members))
    return write_text_file(path, fmt::format(kPage, escaped(results.empty() ? "" : results.front().title),
                                             kLookCss, kBaseCss, kResultsCss, html, kPicturesJs));
  write_page_file(
      path, PageKind::sweeps,
      Json::Object{{"format", "hyrax-sweeps/1"},
                   {"program", "hyrax-sim " + std::string(build_info().version)},
                   {"command", command},
                   {"sweeps", list_of(results, [](const ShownResult& each) { return each.members; })}},
      html);
}

}  // namespace hyrax
