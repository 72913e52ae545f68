// What a check found, for other programs: JUnit XML, annotations, Markdown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/files/failure.h"

namespace hyrax {

/// A scenario, golden file or folder, or a core that fails the check whatever the scenarios' verdicts are.
struct ReportEntry {
  std::string name;       ///< A path, or what the core's verdict is.
  std::string_view kind;  ///< "disagreed", "core".
  ExitCode exit_code;
  std::string sentence = {};  ///< What is wrong, in one line without the name; empty: it agrees.
  std::string details = {};   ///< All that is known of it: complete lines.
  std::string file = {};      ///< Which an annotation marks; empty: none.
  double seconds = 0.0;
  std::int64_t line = 0;  ///< Of `file`; 0: not known.
};

[[nodiscard]] std::string junit_text(const std::vector<ReportEntry>& entries);

/// Workflow commands of GitHub Actions, "::error file=PATH,title=TITLE::MESSAGE", a line for each entry that
/// does not agree.
[[nodiscard]] std::string github_annotations(const std::vector<ReportEntry>& entries);

/// What a report says of one thing, in whichever form it is made: a sentence, and lines below it.
struct Paragraph {
  std::string subject = {};    ///< "93 of 99 scenarios "; empty: there are only lines.
  std::string verdict = {};    ///< "differ": red on a terminal.
  std::string predicate = {};  ///< ": GRAVITY 1200 -> 1250; the accepted core gives all 93 golden files."
  std::string lines = {};      ///< Complete, indented by two.
  bool is_good = false;        ///< The verdict.
  [[nodiscard]] std::string sentence() const { return subject + verdict + predicate; }
};

void print(const Paragraph& paragraph);

[[nodiscard]] std::string markdown_text(const std::vector<ReportEntry>& entries,
                                        const std::vector<Paragraph>& paragraphs, const std::string& counts);

}  // namespace hyrax
