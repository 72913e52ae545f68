// The report of `check` as JSON and as Markdown.
#include "tools/app/check/check_report.h"
#include "tools/app/comparison/comparison_text.h"
#include "tools/app/expect/judged_run.h"

namespace hyrax {
namespace {

Json entry_json(const CheckVerdict& verdict) {
  Json::Object entry = result_of(verdict, name_of(verdict.status),
                                 verdict.has_golden && verdict.status != CheckStatus::failed);
  if (!verdict.broken.empty()) entry.emplace_back("expect", list_of(verdict.broken, expectation_json));
  if (!verdict.error.empty()) entry.emplace_back("error", verdict.error);
  return entry;
}

}  // namespace

Json::Object result_of(const PairVerdict& scenario, std::string_view status, bool is_compared) {
  Json::Object entry = comparison_json(scenario.comparison);
  if (!is_compared)
    for (auto& [key, value] : entry) value = nullptr;
  entry.insert(entry.begin(), {{"scenario", scenario.path}, {"status", status}});
  return entry;
}

Json check_json(const CheckReport& report) {
  return Json::Object{
      {"checked", report.scenario_count()},
      {"agreed", report.count(CheckStatus::agreed)},
      {"disagreed", report.count(CheckStatus::disagreed)},
      {"missing", report.count(CheckStatus::missing)},
      {"failed", report.count(CheckStatus::failed)},
      {"unreferenced", report.count(CheckStatus::unreferenced)},
      {"results", list_of(report.verdicts, entry_json)},
      {"cores", list_of(report.cores.verdicts(), [](const auto* core) { return core_json(*core); })},
      {"groups", list_of(report.groups, group_json)}};
}

std::string check_markdown(const CheckReport& report) {
  std::vector<ReportSection> sections;
  for (const Paragraph& paragraph : report.paragraphs)
    sections.push_back({paragraph.subject.empty() ? "" : paragraph.sentence(), paragraph.lines});
  return markdown_text(report.entries, sections, report.counts);
}

}  // namespace hyrax
