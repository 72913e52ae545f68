#include <fmt/format.h>

#include <algorithm>

#include "tools/hyrax-sim/check_verdict.h"
#include "tools/hyrax-sim/difference_text.h"
#include "tools/hyrax-sim/run_report.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

std::int64_t count(const std::vector<CheckVerdict>& verdicts, Status status) {
  return std::count_if(verdicts.begin(), verdicts.end(), [&](const auto& v) { return v.status == status; });
}

// What is wrong, and which command lines show more.
std::string details(const CheckVerdict& verdict) {
  if (verdict.status == Status::failed) return "  " + verdict.error + "\n";
  std::string text;
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  if (verdict.status == Status::missing)
    return text +
           fmt::format("  no golden file at {}\n  to make one: hyrax-sim bless {} --reason TEXT\n",
                       verdict.golden_path.empty() ? "any place known; see --golden" : verdict.golden_path,
                       verdict.path);
  if (verdict.comparison.agrees) return text;
  return text + difference_text(verdict.comparison) +
         fmt::format(
             "  to see more     hyrax-sim run {} -o now.h5; hyrax-sim diff {} now.h5\n"
             "  if it is meant  hyrax-sim bless {} --reason TEXT\n",
             verdict.path, verdict.golden_path, verdict.path);
}

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        // XML 1.0 has no way to write other control characters.
        xml += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return xml;
}

std::string test_case(const CheckVerdict& verdict) {
  const std::string open =
      fmt::format("  <testcase classname=\"hyrax-sim.check\" name=\"{}\" time=\"{:.6f}\"",
                  escaped(verdict.path), verdict.seconds);
  if (verdict.status == Status::agreed) return open + "/>\n";
  const char* const element = verdict.status == Status::disagreed ? "failure" : "error";
  return open + fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n", element,
                            name_of(verdict.status), escaped(details(verdict)));
}

}  // namespace

std::string check_text(const std::vector<CheckVerdict>& verdicts) {
  std::string text;
  for (const CheckVerdict& verdict : verdicts)
    if (verdict.status != Status::agreed)
      text += fmt::format("{}: {}\n{}", verdict.path, name_of(verdict.status), details(verdict));
  return text + fmt::format("{} checked: {} agreed, {} disagreed, {} without golden file, {} failed\n",
                            verdicts.size(), count(verdicts, Status::agreed),
                            count(verdicts, Status::disagreed), count(verdicts, Status::missing),
                            count(verdicts, Status::failed));
}

Json check_json(const std::vector<CheckVerdict>& verdicts) {
  Json::Array results;
  for (const CheckVerdict& verdict : verdicts) {
    const Comparison& comparison = verdict.comparison;
    Json::Object entry{{"scenario", verdict.path},
                       {"status", name_of(verdict.status)},
                       {"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
                       {"first_divergence", divergence_json(comparison.first)}};
    if (!verdict.broken.empty()) {
      Json::Array broken;
      for (const Expectation& expectation : verdict.broken) broken.push_back(expectation_json(expectation));
      entry.emplace_back("expect", std::move(broken));
    }
    if (!verdict.error.empty()) entry.emplace_back("error", verdict.error);
    results.emplace_back(std::move(entry));
  }
  return Json::Object{{"checked", static_cast<std::int64_t>(verdicts.size())},
                      {"agreed", count(verdicts, Status::agreed)},
                      {"disagreed", count(verdicts, Status::disagreed)},
                      {"missing", count(verdicts, Status::missing)},
                      {"failed", count(verdicts, Status::failed)},
                      {"results", std::move(results)}};
}

std::string check_junit(const std::vector<CheckVerdict>& verdicts) {
  double seconds = 0.0;
  for (const CheckVerdict& verdict : verdicts) seconds += verdict.seconds;
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"hyrax-sim check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\">\n",
      verdicts.size(), count(verdicts, Status::disagreed),
      count(verdicts, Status::missing) + count(verdicts, Status::failed), seconds);
  for (const CheckVerdict& verdict : verdicts) text += test_case(verdict);
  return text + "</testsuite>\n";
}

}  // namespace hyrax
