#include <fmt/format.h>

#include <algorithm>

#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/hyrax-sim/command_line/shell_command.h"
#include "tools/hyrax-sim/golden/check_verdict.h"
#include "tools/hyrax-sim/golden/difference_text.h"
#include "tools/hyrax-sim/runs/scenario_run.h"

namespace hyrax {
namespace {

using Status = CheckVerdict::Status;

std::int64_t count(const std::vector<CheckVerdict>& verdicts, Status status) {
  return std::count_if(verdicts.begin(), verdicts.end(), [&](const auto& v) { return v.status == status; });
}

std::int64_t scenario_count(const std::vector<CheckVerdict>& verdicts) {
  return static_cast<std::int64_t>(verdicts.size()) - count(verdicts, Status::unreferenced);
}

std::string missing_text(const CheckVerdict& verdict) {
  if (!verdict.golden)
    return "  no golden file: no folder `scenarios` above it; --golden DIR names the folder to look in\n";
  const auto& [h5_path, txt_path] = *verdict.golden;
  std::string text = fmt::format("  no golden file at {}\n", printable(h5_path));
  if (is_there(h5_path) || is_there(txt_path))
    text += fmt::format("  {} exists, but {} is missing\n", printable(is_there(h5_path) ? h5_path : txt_path),
                        printable(is_there(h5_path) ? txt_path : h5_path));
  return text;
}

// What is wrong, and the commands that show more.
std::string details(const CheckVerdict& verdict, bool lists_all = false) {
  if (verdict.status == Status::failed) return "  " + verdict.error + "\n";
  if (verdict.status == Status::unreferenced)
    return "  no scenario for this golden file: the scenario was deleted, moved or renamed\n";
  if (verdict.status == Status::agreed) return "";
  std::string text;
  for (const Expectation& broken : verdict.broken)
    text += fmt::format("  expect     {}\n", expectation_text(broken));
  const std::string bless = bless_command_for(verdict.path, verdict.golden_folder);
  if (verdict.status == Status::missing)
    return text + missing_text(verdict) + fmt::format("  to create it: {}\n", bless);
  if (verdict.comparison.agrees) return text;
  return text + difference_text(verdict.comparison, lists_all) +
         fmt::format(
             "  to see more     {}; {}\n"
             "  to accept it    {}\n",
             shell_command({"hyrax-sim", "run", as_argument(verdict.path), "-o", "now.h5"}),
             shell_command({"hyrax-sim", "diff", as_argument(verdict.golden->h5_path), "now.h5"}), bless);
}

// XML 1.0 allows neither control characters, except some white space, nor U+FFFE, U+FFFF and invalid UTF-8,
// not even escaped: they become text.
std::string escaped(std::string_view text) {
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

std::string test_case(const CheckVerdict& verdict) {
  const std::string open =
      fmt::format("  <testcase classname=\"hyrax-sim.check\" name=\"{}\" time=\"{:.6f}\"",
                  escaped(verdict.path), verdict.seconds);
  if (verdict.status == Status::agreed) return open + "/>\n";
  const bool is_failure = verdict.exit_code == ExitCode::disagreed;
  const char* const element = is_failure ? "failure" : "error";
  return open + fmt::format(">\n    <{0} message=\"{1}\">{2}</{0}>\n  </testcase>\n", element,
                            name_of(verdict.status), escaped(details(verdict)));
}

// Whether rows of the golden file were compared.
bool is_compared(const CheckVerdict& verdict) {
  return verdict.has_golden && verdict.status != Status::failed;
}

}  // namespace

void print_check(const std::vector<CheckVerdict>& verdicts, const Printing& printing) {
  for (const CheckVerdict& verdict : verdicts) {
    const bool is_good = verdict.status == Status::agreed;
    if (is_good ? printing.is_verbose() : !printing.is_quiet())
      print_text("{}: {}\n{}", printable(verdict.path), VerdictWord{name_of(verdict.status), is_good},
                 details(verdict, printing.is_verbose()));
    if (verdict.status == Status::failed && printing.is_quiet()) print_error(verdict.error);
  }
  print_text("{} checked: {} agreed, {} disagreed, {} without golden file, {} failed",
             scenario_count(verdicts), count(verdicts, Status::agreed), count(verdicts, Status::disagreed),
             count(verdicts, Status::missing), count(verdicts, Status::failed));
  const std::int64_t unreferenced = count(verdicts, Status::unreferenced);
  print_text("{}\n", unreferenced > 0 ? fmt::format("; {} unreferenced", unreferenced) : "");
}

Json check_json(const std::vector<CheckVerdict>& verdicts) {
  Json::Array results;
  for (const CheckVerdict& verdict : verdicts) {
    const Comparison& comparison = verdict.comparison;
    Json::Object entry{{"scenario", verdict.path},
                       {"status", name_of(verdict.status)},
                       {"class", comparison.difference ? Json(name_of(*comparison.difference)) : Json()},
                       {"max_px", is_compared(verdict) ? max_px_json(comparison) : Json()},
                       {"contacts_moved", is_compared(verdict) ? Json(comparison.contacts.total()) : Json()},
                       {"first_divergence", divergence_json(comparison.first)}};
    if (!verdict.broken.empty()) {
      Json::Array broken;
      for (const Expectation& expectation : verdict.broken) broken.push_back(expectation_json(expectation));
      entry.emplace_back("expect", std::move(broken));
    }
    if (!verdict.error.empty()) entry.emplace_back("error", verdict.error);
    results.emplace_back(std::move(entry));
  }
  return Json::Object{{"checked", scenario_count(verdicts)},
                      {"agreed", count(verdicts, Status::agreed)},
                      {"disagreed", count(verdicts, Status::disagreed)},
                      {"missing", count(verdicts, Status::missing)},
                      {"failed", count(verdicts, Status::failed)},
                      {"unreferenced", count(verdicts, Status::unreferenced)},
                      {"results", std::move(results)}};
}

std::string check_junit(const std::vector<CheckVerdict>& verdicts) {
  double seconds = 0.0;
  for (const CheckVerdict& verdict : verdicts) seconds += verdict.seconds;
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"hyrax-sim check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\">\n",
      verdicts.size(), count(verdicts, Status::disagreed) + count(verdicts, Status::unreferenced),
      count(verdicts, Status::missing) + count(verdicts, Status::failed), seconds);
  for (const CheckVerdict& verdict : verdicts) text += test_case(verdict);
  return text + "</testsuite>\n";
}

}  // namespace hyrax
