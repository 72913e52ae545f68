// The report of `check` for programs: JSON, JUnit XML, annotations.
#include <fmt/format.h>

#include <algorithm>

#include "tools/app/check/check_report.h"
#include "tools/app/diff/difference_text.h"
#include "tools/app/expect/judged_run.h"
#include "tools/files/printable.h"

namespace hyrax {
namespace {

Json result_json(const CheckVerdict& verdict) {
  Json::Object entry = result_of(verdict, name_of(verdict.status),
                                 verdict.has_golden && verdict.status != CheckStatus::failed);
  if (!verdict.broken.empty()) entry.emplace_back("expect", list_of(verdict.broken, expectation_json));
  if (!verdict.error.empty()) entry.emplace_back("error", verdict.error);
  return entry;
}

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

std::string test_case(std::string_view name, double seconds, ExitCode exit_code, std::string_view message,
                      std::string_view details) {
  const std::string open = fmt::format(
      "  <testcase classname=\"hyrax-sim.check\" name=\"{}\" time=\"{:.6f}\"", xml_text(name), seconds);
  if (exit_code == ExitCode::agreed) return open + "/>\n";
  return open + fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n",
                            exit_code == ExitCode::disagreed ? "failure" : "error", xml_text(message),
                            xml_text(details));
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

std::string annotation(const std::string& file, std::string_view kind, const std::string& message) {
  return fmt::format(
      "::error {}title={}::{}\n", file.empty() ? "" : fmt::format("file={},", workflow_text(file, true)),
      workflow_text(fmt::format("hyrax-sim check: {}", kind), true), workflow_text(message, false));
}

std::string annotation(const CheckVerdict& verdict) {
  return annotation(verdict.path, name_of(verdict.status), verdict_sentence(verdict));
}

}  // namespace

Json::Object result_of(const PairVerdict& scenario, std::string_view status, bool is_compared) {
  const Comparison& comparison = scenario.comparison;
  return {{"scenario", scenario.path},
          {"status", status},
          {"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
          {"max_px", is_compared ? max_px_json(comparison) : Json()},
          {"contacts_moved", is_compared ? Json(comparison.contacts.total()) : Json()},
          {"first_divergence", divergence_json(comparison.first)}};
}

Json check_json(const CheckReport& report) {
  return Json::Object{
      {"checked", report.scenario_count()},
      {"agreed", report.count(CheckStatus::agreed)},
      {"disagreed", report.count(CheckStatus::disagreed)},
      {"missing", report.count(CheckStatus::missing)},
      {"failed", report.count(CheckStatus::failed)},
      {"unreferenced", report.count(CheckStatus::unreferenced)},
      {"results", list_of(report.verdicts, result_json)},
      {"cores", list_of(report.cores.verdicts(), [](const auto* core) { return core_json(*core); })},
      {"groups", list_of(report.groups, group_json)}};
}

std::string check_junit(const CheckReport& report) {
  double seconds = 0.0;
  std::vector<ExitCode> exit_codes;
  std::string cases;
  for (const CheckVerdict& verdict : report.verdicts) {
    seconds += verdict.seconds;
    exit_codes.push_back(verdict.exit_code);
    cases += test_case(verdict.path, verdict.seconds, verdict.exit_code,
                       fmt::format("{}: {}", name_of(verdict.status), verdict_sentence(verdict)),
                       verdict_details(verdict));
  }
  for (const auto& [kind, file, text, exit_code] : other_failures(report)) {
    exit_codes.push_back(exit_code);
    cases +=
        test_case(file.empty() ? text : file, 0.0, exit_code, text.substr(0, text.find('\n')), text + "\n");
  }
  const auto failures = std::ranges::count(exit_codes, ExitCode::disagreed);
  const auto errors = std::ssize(exit_codes) - failures - std::ranges::count(exit_codes, ExitCode::agreed);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"hyrax-sim check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\">\n"
      "{}</testsuite>\n",
      exit_codes.size(), failures, errors, seconds, cases);
}

std::string github_annotations(const CheckReport& report) {
  std::string text;
  for (const DifferenceGroup& group : report.groups)
    for (const PairVerdict* const scenario : group.scenarios) text += annotation(verdict_on(*scenario));
  for (const CheckVerdict& verdict : report.verdicts)
    if (verdict.status != CheckStatus::agreed && verdict.group == nullptr) text += annotation(verdict);
  for (const OtherFailure& other : other_failures(report))
    text += annotation(other.file, other.kind, other.text);
  return text;
}

}  // namespace hyrax
