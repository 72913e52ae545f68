// What the report pages are given of runs and of a part of a sweep; a run as `run` writes it, how
// far it is, and its file as the page shows it without JavaScript.
#include <gtest/gtest.h>

#include <cstring>
#include <regex>

#include "sim/core/listing_core.h"
#include "sim/core/shipped_core.h"
#include "sim/replay/fingerprint.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/sim/result/described.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/app/command_line/print.h"
#include "tools/app/play/play.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"
#include "tools/app/sweep/sweep_run.h"
#include "tools/files/sweep_reader.h"
#include "tools/report/page_file.h"

namespace hyrax {
namespace {

std::string page_of_test;

}  // namespace

// Replaces the page templates, which an everyday build lacks.
std::string_view page_template(PageKind /*kind*/) { return page_of_test; }

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
                                            .command = "a command"}),
               folder);
}

ShownResult sweep_page(const TempFolder& folder, const std::string& computed_by) {
  const SweepFile file = parse_sweep(R"({"format": "hyrax-sweep/1", "members": 12, "seed": 3, "base": {
      "format": "hyrax-scenario/1", "name": "base", "window": {"width_px": 1000, "height_px": 500},
      "sprite": {"width_px": 100, "height_px": 40}, "start": {"x_px": 300, "y_px": 200, "vx_px_per_s": 700},
      "clock": {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.1, "seed": 7}}, "steps": 200,
      "events": [{"step": 9, "fling": {"vx_px_per_s": 5, "vy_px_per_s": 6}}]},
      "vary": {"/start/vx_px_per_s": {"uniform": [-900, 900]}, "/start/x_px": {"grid": [0, 800, 3]},
      "/clock/jitter/seed": {"choice": [18446744073709551615, 1]}},
      "keep": ["final", "contacts", "at_rest", "state_hash"]})",
                                     "sweep");
  const EnsembleHead head{.sweep_text = file.text,
                          .members = 12,
                          .part = {1, 2},
                          .is_part = true,
                          .physics = std::string(shipped_core().name),
                          .core = computed_by};
  const std::string path = folder.at("sweep.h5");
  static_cast<void>(compute_sweep(paper_sweep(shipped_core(), file), head, path, 1));
  return sweep_result(shipped_core(), path);
}

std::string sweep_shown(const TempFolder& folder) {
  const ShownResult page = sweep_page(folder, shipped_core().record.checksum());
  std::string text = page.title + "\n" + page.subtitle + "\n" + described(page.verdict);
  for (const Table& table : page.tables) text += described(table);
  for (const Figure& figure : page.figures) text += described(figure);
  for (const auto& [name, value] : page.origin) text += name + ": " + value + "\n";
  return std::regex_replace(text, std::regex(folder.at("")), "") + shown(page.members, folder);
}

TEST(ReportData, IsWhatWasApproved) {
  const TempFolder folder;
  expect_approved("tests/unit/tools/app/report.txt", "Runs against another\n" + runs_shown(folder) +
                                                         "A part of a sweep\n" + sweep_shown(folder));
}

TEST(ReportData, OfASweepThatAnotherCoreComputedHasNoMembersToReplayAndSaysSo) {
  const TempFolder folder;
  ASSERT_NE(shipped_core().record.checksum(), "");
  for (const auto& [core, said] :
       {std::pair(std::string(32, '7'), "another core than this program's computed them"),
        {std::string(), "the file does not name the core that computed it"}}) {
    const ShownResult page = sweep_page(folder, core);
    EXPECT_NE(described(page.verdict).find(said), std::string::npos);
    EXPECT_TRUE(page.members.is_null());
  }
  EXPECT_FALSE(sweep_page(folder, shipped_core().record.checksum()).members.is_null());
}

// A program of tools/check has another core than its page, under the same name.
TEST(ReportData, OfAnotherCoreThanThePagesHasTheStepByWhichThePageReplays) {
  const TempFolder folder;
  static_cast<void>(write_run(shipped_core(), folder.at("run.h5"), fling_at(60.0, 9), {}));
  const auto data_of = [&](const Core& core) {
    return report_data(core, {.files = {folder.at("run.h5")}, .output = "page.html", .command = "c"});
  };
  const std::string shipped = hex(fingerprint_of(shipped_core()));
  Core incomplete = shipped_core();
  incomplete.record.step = {};
  incomplete.record.why_incomplete = "the step calls clock";
  for (const std::string& own : {shipped, std::string(32, '7')}) {
    page_of_test = "<html data-fingerprint=\"" + own + "\">";
    const bool is_another = own != shipped;
    EXPECT_EQ(data_of(shipped_core()).find("core_step")->is_null(), !is_another);
    EXPECT_TRUE(data_of(shipped_core()).find("no_replay")->is_null());
    EXPECT_EQ(
        to_text(*data_of(incomplete).find("no_replay")).find("the step calls clock") != std::string::npos,
        is_another);
    EXPECT_EQ(sweep_page(folder, shipped_core().record.checksum()).members.is_null(), is_another);
  }
  page_of_test.clear();
}

// The page's core has its own constants.
TEST(ReportData, OfARunWithParametersHasTheConstantsThatItIsPlayedWith) {
  const TempFolder folder;
  Scenario scenario = eventful_fling();
  const auto parameters_of = [&](const std::string& path) {
    const Core core = with_parameters(shipped_core(), scenario.parameters).value();
    static_cast<void>(write_run(core, path, scenario, {}));
    const Json data = report_data(shipped_core(), {.files = {path}, .output = "page.html", .command = "c"});
    return to_text(*data.find("runs")->get<Json::Array>()->front().find("parameters"));
  };
  const std::string own = parameters_of(folder.at("own.h5"));
  EXPECT_NE(own.find("\"values\": [1200, 0.6, 0.999, 0.8, "), own.npos) << own;
  EXPECT_NE(own.find("\"given\": {}"), own.npos) << own;
  scenario.parameters = {{"AIR_DRAG", 0.5}};
  const std::string other = parameters_of(folder.at("other.h5"));
  EXPECT_NE(other.find("\"values\": [1200, 0.6, 0.5, 0.8, "), other.npos) << other;
  EXPECT_NE(other.find("\"given\": { \"AIR_DRAG\": 0.5 }"), other.npos) << other;
}

TEST(ReportData, HasTheFirstInputsAndEveryResize) {
  std::vector<Input> inputs(5'001, {1, Fling{}});
  inputs.push_back({2, Resize{Size{9, 9}, {}}});
  EXPECT_EQ(inputs_json(inputs).get<Json::Array>()->size(), 5'001U);
}

// The file is begun again, as it has fewer rows than it was made for; a picture must not be.
TEST(WrittenRun, ThatBecomesNonFiniteIsGivenToOthersOnce) {
  const TempFolder folder;
  const Scenario scenario = fling_at(60.0, 100, {{std::int64_t{50}, Hitch{1e306}}});
  TraceSink played, given;
  const RunSummary summary = replay(shipped_core(), scenario, played);
  const WrittenRun run = write_run(shipped_core(), folder.at("run.h5"), scenario, {.also = {&given}});
  EXPECT_TRUE(same_trace(given, played));
  EXPECT_EQ(text_of(run.summary), text_of(summary));
  EXPECT_EQ(run.rows_recorded, 52);
}

TEST(RunPicture, TakesEveryRowOfTheFirstStepsAndEveryNthLater) {
  const RowSink::Wants wants = RunPicture(fling_at(60.0, 120'000)).wants();
  EXPECT_EQ(wants.rows_every, 3);
  EXPECT_EQ(wants.all_rows_to, 50'000);
  EXPECT_EQ(RunPicture(fling_at(60.0, 49'999)).wants().rows_every, 1);
}

TEST(Progress, EstimatesByWhatIsDoneAndNothingBefore) {
  EXPECT_EQ(progress_text(25, 100, "steps", 2.0), "25 of 100 steps, 12.5 per second, 6 s left");
  EXPECT_EQ(progress_text(200, 100, "steps", 2.0), "200 of 100 steps, 100 per second, 0 s left");
  for (const double elapsed_s : {0.0, 2.0})
    EXPECT_EQ(progress_text(0, 100, "steps", elapsed_s), "0 of 100 steps");
}

TEST(Title, HasTheClockAndHowFarARunCame) {
  Scenario scenario = fling_at(59.94, 90);
  EXPECT_EQ(title_of(scenario, 7, 0.5), "fling: 7 of 90 steps, 0.5 s at 59.94 Hz");
  scenario.clock.base = FixedStep{0.25};
  EXPECT_EQ(title_of(scenario, 90, 22.5), "fling: 90 steps, 22.5 s at dt 0.25 s");
  scenario.clock.base = RecordedSteps{{0.25, 0.5}};
  scenario.length = std::int64_t{2};
  EXPECT_EQ(title_of(scenario, 2, 0.75), "fling: 2 steps, 0.75 s at recorded dt");
}

TEST(StillPicture, HasThePathOfTheCentreToScaleBelowTheVerdict) {
  const TempFolder folder;
  Scenario scenario = fling_at(60.0, 2, {{std::int64_t{1}, Place{{7.0, 9.0}}}});
  scenario.clock.base = FixedStep{0.0};
  scenario.window = {900, 500};
  scenario.sprite = {100, 40};
  scenario.start = {300.0, 200.0};
  static_cast<void>(write_run(shipped_core(), folder.at("run.h5"), scenario, {}));
  const Json data = parse_json(R"({"runs": [{"name": "a<b", "title": "2 steps",
      "non_finite": "vx is NaN", "golden": {"agrees": false, "class": "values"},
      "expect": [{"holds": true, "text": "one"}, {"holds": false, "text": "another"}]}]})",
                               "data");
  const std::string html = still_html({.files = {folder.at("run.h5")}}, data);
  EXPECT_TRUE(html.starts_with(
      "<section id=\"run=0\">\n<h1>a&lt;b</h1>\n<p>2 steps</p>\n<p>vx is NaN; the run ended there</p>\n"
      "<p>Differs from the golden file: values</p>\n<p>holds: one</p>\n<p>does not hold: another</p>\n"
      "</section>\n<svg "))
      << html;
  EXPECT_NE(html.find("path of the centre"), html.npos) << html;
}

}  // namespace
}  // namespace hyrax
