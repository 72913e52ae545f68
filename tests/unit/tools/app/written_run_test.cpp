// A run as `run` writes it, how far it is, and its file as the report page shows it without JavaScript.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/app/command_line/progress.h"
#include "tools/app/play/play_with_progress.h"
#include "tools/app/report/report_page.h"
#include "tools/app/runs/scenario_run.h"

namespace hyrax {
namespace {

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
  EXPECT_EQ(progress_text(100, 100, "steps", 2.0), "100 of 100 steps, 50 per second, 0 s left");
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
  const Json data = parse_json(R"({"runs": [{"name": "a<b", "title": "2 steps", "cause": "a cause",
      "non_finite": "vx is NaN", "golden": {"agrees": false, "class": "values"},
      "expect": [{"holds": true, "text": "one"}, {"holds": false, "text": "another"}]}]})",
                               "data");
  const std::string html = still_html({.files = {folder.at("run.h5")}}, data);
  EXPECT_TRUE(html.starts_with(
      "<h1>a&lt;b</h1>\n<p>2 steps</p>\n<p>a cause</p>\n<p>vx is NaN; the run ended there</p>\n"
      "<p>Differs from the golden file: values</p>\n<p>holds: one</p>\n<p>does not hold: another</p>\n"
      "<svg viewBox=\"0 0 900 500\""))
      << html;
  EXPECT_NE(html.find("points=\"350.0,220.0 350.0,220.0 57.0,29.0 \""), html.npos) << html;
}

}  // namespace
}  // namespace hyrax
