// What the report page is given of runs, of a part of a sweep, and of a study.
#include <gtest/gtest.h>

#include <cstring>
#include <regex>

#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/app/sweep/sweep_run.h"
#include "tools/files/sweep_reader.h"
#include "tools/store/table_file.h"

namespace hyrax {
namespace {

std::vector<double> doubles_of(const std::string& base64) {
  static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : base64.substr(0, base64.find('='))) {
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(digit));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

// Doubles described, long numbers cut, and without what a build or a folder decides.
std::string shown(const Json& json, const TempFolder& folder) {
  std::string rest = to_text(json, 3), text;
  const std::regex doubles("\"([A-Za-z0-9+/]{36,}=*)\"");
  for (std::smatch found; std::regex_search(rest, found, doubles); rest = found.suffix())
    text += found.prefix().str() + described(doubles_of(found[1]));
  text += rest;
  for (const auto& [found, instead] :
       {std::pair("[0-9.]+e-1[0-9]", "rounding"),
        {"(\\.[0-9]{6})[0-9]+", "$1"},
        {"\"(program|compiler|flags|target|instruction_set|self_test)\": \"[^\"]*\"",
         "\"$1\": of the build"}})
    text = std::regex_replace(text, std::regex(found), instead);
  return std::regex_replace(text, std::regex(folder.at("")), "") + "\n";
}

std::string runs_shown(const TempFolder& folder) {
  Scenario scenario = eventful_fling();
  scenario.description = "All kinds of input.";
  scenario.expect.emplace();
  scenario.expect->in_bounds = false;
  scenario.expect->contacts.right = Interval{0.0, 99.0};
  const Scenario faster = fling_at(60.0, 7);
  Scenario decimated = faster;
  decimated.record_every = 3;
  for (const auto& [name, played] : {std::pair("eventful.h5", scenario),
                                     {"short.h5", faster},
                                     {"decimated.h5", decimated},
                                     {"long.h5", fling_at(60.0, 5300)}})
    static_cast<void>(write_run(shipped_core(), folder.at(name), played, {}));
  return shown(report_data(shipped_core(), {.files = {folder.at("eventful.h5"), folder.at("decimated.h5"),
                                                      folder.at("long.h5")},
                                            .against = folder.at("short.h5"),
                                            .output = "page.html",
                                            .command = "a command",
                                            .cause = "a cause"}),
               folder);
}

std::string sweep_shown(const TempFolder& folder) {
  const SweepFile file = parse_sweep(R"({"format": "hyrax-sweep/1", "members": 12, "seed": 3, "base": {
      "format": "hyrax-scenario/1", "name": "base", "window": {"width_px": 1000, "height_px": 500},
      "sprite": {"width_px": 100, "height_px": 40}, "start": {"x_px": 300, "y_px": 200, "vx_px_per_s": 700},
      "clock": {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.1, "seed": 7}}, "steps": 200,
      "events": [{"step": 9, "fling": {"vx_px_per_s": 5, "vy_px_per_s": 6}}]},
      "vary": {"/start/vx_px_per_s": {"uniform": [-900, 900]}, "/start/x_px": {"grid": [0, 800, 3]},
      "/clock/jitter/seed": {"choice": [18446744073709551615, 1]}},
      "keep": ["final", "contacts", "at_rest", "state_hash"]})",
                                     "sweep");
  SweepJob job{.head = {.sweep_text = file.text, .members = 12, .part = {1, 2}, .is_part = true},
               .output = folder.at("sweep.h5")};
  job.head.physics = shipped_core().name;
  static_cast<void>(compute_sweep(shipped_core(), file.sweep, job));
  return shown(result_of_file(shipped_core(), job.output), folder);
}

std::string study_shown(const TempFolder& folder, const std::string& broken) {
  const auto text = [](const char* name, const std::string& json) {
    return Column{.name = name, .long_name = "as JSON", .values = std::vector<std::string>{json}};
  };
  const Table table{
      .name = "numbers",
      .long_name = "some numbers",
      .columns = {{.name = "a", .unit = "px", .long_name = "first", .values = std::vector{1.0, 2.0}}}};
  const Table report{.name = kReportTable,
                     .long_name = "for the page",
                     .columns = {text("verdict", R"({"text": ["a sentence"], "broken": [)" + broken + "]}"),
                                 text("figures", "[]")}};
  write_study_file(folder.at("study.h5"), {"a-study", "what it is about"}, {table, report});
  return shown(result_of_file(shipped_core(), folder.at("study.h5")), folder);
}

TEST(ReportData, IsWhatWasApproved) {
  const TempFolder folder;
  expect_approved("tests/unit/tools/app/report.txt",
                  "Runs against another\n" + runs_shown(folder) + "A part of a sweep\n" +
                      sweep_shown(folder) + "A study\n" + study_shown(folder, "") +
                      "A study with a broken rule\n" + study_shown(folder, "\"a rule\""));
}

TEST(ReportData, HasTheFirstInputsAndEveryResize) {
  std::vector<Input> inputs(5'001, {1, Fling{}});
  inputs.push_back({2, Resize{Size{9, 9}, {}}});
  EXPECT_EQ(inputs_json(inputs).get<Json::Array>()->size(), 5'001U);
}

}  // namespace
}  // namespace hyrax
