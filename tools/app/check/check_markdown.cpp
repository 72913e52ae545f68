// The report of `check` in Markdown.
#include <fmt/format.h>

#include <algorithm>

#include "tools/app/check/check_report.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

// A code span, in which no character of the text has a meaning: its fence is longer than any in the text.
std::string code_span(std::string_view text) {
  const std::string line = printable(text);
  std::size_t longest = 0, run = 0;
  for (const char c : line) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  const char* const pad = line.empty() || line.front() == '`' || line.back() == '`' ? " " : "";
  return fence + pad + line + pad + fence;
}

// Indented, so that no character of the lines has a meaning.
std::string code_block(std::string_view lines) {
  std::string text = "    ";
  for (const char c : lines) text += c == '\n' ? "\n    " : std::string(1, c);
  return text + "\n";
}

// The target of a link: in angle brackets a name may hold blanks and parentheses.
std::string link_target(const std::string& name) {
  std::string target;
  for (const char c : name) {
    if (c == '<' || c == '>' || c == '\\') target += '\\';
    target += c;
  }
  return "<" + target + ">";
}

std::string picture_text(const GroupPicture& picture) {
  std::string text;
  if (!picture.svg.empty())
    text += fmt::format("![both paths of the worst scenario, and their distance]({})\n\n",
                        link_target(picture.svg));
  if (!picture.html.empty())
    text += fmt::format("[The same run, played step by step]({})\n\n", link_target(picture.html));
  if (!picture.missing.empty()) text += code_span(picture.missing) + "\n\n";
  return text;
}

std::string group_section(const DifferenceGroup& group, std::size_t checked, const GroupPicture& picture) {
  std::string text =
      fmt::format("### {}\n\n{}\n\n{}\n\n", name_of(group.cause.kind),
                  code_span(cause_sentence(group, checked).text()), code_span(consequence_sentence(group)));
  text += picture_text(picture);
  for (const PairVerdict* const scenario : group.scenarios)
    text += fmt::format("- {}: {}\n", code_span(scenario->path), code_span(scenario_consequence(*scenario)));
  return text + "\n";
}

}  // namespace

std::string check_markdown(const CheckReport& report, const std::vector<GroupPicture>& pictures) {
  const bool is_green =
      report.count(CheckStatus::agreed) == static_cast<std::int64_t>(report.verdicts().size()) &&
      other_failures(report).empty();
  std::string text = fmt::format("## hyrax-sim check: {}\n\n{}\n\n", is_green ? "agreed" : "not agreed",
                                 counts_sentence(report));
  const auto checked = static_cast<std::size_t>(report.scenario_count());
  for (std::size_t group = 0; group < report.groups().size(); ++group)
    text += group_section(report.groups()[group], checked,
                          group < pictures.size() ? pictures[group] : GroupPicture{});
  for (const OtherFailure& other : other_failures(report))
    text += fmt::format("### {}\n\n{}\n", other.kind, code_block(printable_lines(other.text)));
  for (const CheckVerdict& verdict : report.verdicts())
    if (verdict.status != CheckStatus::agreed && report.group_of(verdict) == nullptr)
      text += fmt::format("- {}: {}: {}\n", code_span(verdict.path), name_of(verdict.status),
                          code_span(verdict_sentence(report, verdict)));
  return text;
}

}  // namespace hyrax
