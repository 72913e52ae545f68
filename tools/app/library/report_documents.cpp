#include "tools/app/library/report_documents.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/app/command_line/print.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

// XML 1.0 allows neither control characters, except some white space, nor U+FFFE, U+FFFF and invalid UTF-8,
// not even escaped: they become text.
std::string xml_text(std::string_view text) {
  std::string xml;
  for (std::size_t at = 0, bytes = 0; at < text.size(); at += bytes) {
    const auto [length, code] = utf8_character(text, at);
    bytes = length;
    if (code < 0)
      xml += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[at]));
    else if (code == '\n' || code == '\t')
      xml += fmt::format("&#{};", code);  // Unescaped, an attribute turns it into a space.
    else if (code < 0x20 || code == 0x7f || code == 0xFFFE || code == 0xFFFF)
      xml += fmt::format("\\u{:04x}", code);
    else if (code == '&' || code == '<' || code == '>' || code == '"')
      xml += fmt::format("&#{};", code);
    else
      xml += text.substr(at, length);
  }
  return xml;
}

std::string test_case(const ReportEntry& entry) {
  const std::string open =
      fmt::format("  <testcase classname=\"hyrax-sim.check\" name=\"{}\" time=\"{:.6f}\"",
                  xml_text(entry.name), entry.seconds);
  if (entry.exit_code == ExitCode::agreed) return open + "/>\n";
  const bool is_named = entry.sentence.starts_with(fmt::format("{}:", entry.kind));
  const std::string kind = is_named ? "" : fmt::format("{}: ", entry.kind);
  return open + fmt::format(">\n    <{0} message=\"{1}{2}\">{3}</{0}>\n  </testcase>\n",
                            entry.exit_code == ExitCode::disagreed ? "failure" : "error", kind,
                            xml_text(entry.sentence), xml_text(entry.details));
}

// Text of a workflow command; in a property `:` and `,` end it.
std::string workflow_text(std::string_view text, bool is_property) {
  constexpr std::string_view kEscaped = "%\r\n:,";
  std::string escaped;
  for (const char c : text) {
    const std::size_t place = kEscaped.find(c);
    if (place == std::string_view::npos || (place > 2 && !is_property))
      escaped += c;
    else
      escaped += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return escaped;
}

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
  std::string text;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    text.append("    ").append(lines.substr(begin, end - begin)).append("\n");
    begin = end + 1;
  }
  return text;
}

}  // namespace

void print(const Paragraph& paragraph) {
  if (!paragraph.subject.empty())
    print_text("{}{}{}\n", paragraph.subject, VerdictWord{paragraph.verdict, paragraph.is_good},
               paragraph.predicate);
  print_text("{}", paragraph.lines);
}

std::string junit_text(const std::vector<ReportEntry>& entries) {
  double seconds = 0.0;
  std::ptrdiff_t failures = 0, errors = 0;
  std::string cases;
  for (const ReportEntry& entry : entries) {
    seconds += entry.seconds;
    failures += entry.exit_code == ExitCode::disagreed ? 1 : 0;
    errors += entry.exit_code == ExitCode::disagreed || entry.exit_code == ExitCode::agreed ? 0 : 1;
    cases += test_case(entry);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"hyrax-sim check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\">\n"
      "{}</testsuite>\n",
      entries.size(), failures, errors, seconds, cases);
}

std::string github_annotations(const std::vector<ReportEntry>& entries) {
  std::string text;
  for (const auto& [name, kind, exit_code, sentence, details, file, seconds, line] : entries) {
    if (exit_code == ExitCode::agreed) continue;
    // Of a core, what has changed, too: no scenario's entry says it.
    const std::string said =
        kind == "core" ? details.substr(0, details.find_last_not_of('\n') + 1) : sentence;
    text += fmt::format("::error {}{}title={}::{}{}\n",
                        file.empty() ? "" : fmt::format("file={},", workflow_text(file, true)),
                        line == 0 ? "" : fmt::format("line={},", line),
                        workflow_text(fmt::format("hyrax-sim check: {}", kind), true),
                        line == 0 || kind == "core" ? "" : workflow_text(name + ": ", false),
                        workflow_text(said, false));
  }
  return text;
}

std::string markdown_text(const std::vector<ReportEntry>& entries, const std::vector<Paragraph>& paragraphs,
                          const std::string& counts) {
  const bool is_green = std::ranges::all_of(entries, &std::string::empty, &ReportEntry::sentence);
  std::string text =
      fmt::format("## hyrax-sim check: {}\n\n{}\n", is_green ? "agreed" : "not agreed", counts);
  for (const Paragraph& paragraph : paragraphs) {
    if (!paragraph.subject.empty()) text += fmt::format("\n### {}\n", code_span(paragraph.sentence()));
    if (!paragraph.lines.empty()) text += "\n" + code_block(printable_lines(paragraph.lines));
  }
  text += "\n";
  for (const auto& [name, kind, exit_code, sentence, details, file, seconds, line] : entries)
    if (exit_code != ExitCode::agreed)
      text += fmt::format("- {}: {}: {}\n", code_span(name), kind, code_span(sentence));
  return text;
}

}  // namespace hyrax
