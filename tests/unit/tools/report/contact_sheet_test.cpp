// Contact sheets: what each panel says and in which order, on paper of two widths and on a page.
#include <gtest/gtest.h>

#include <regex>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/contact_sheet.h"
#include "tools/report/run_scene.h"

namespace hyrax {
namespace {

Sheet fling_picture(const Size& window) {
  Scenario scenario = fling_at(60.0, 600);
  scenario.window = window;
  RunRecorder recorder(step_count(scenario));
  static_cast<void>(replay(shipped_core(), scenario, recorder));
  const StoredRun run = recorder.take();
  return run_panel(scenario, run.rows, run.contacts);
}

std::vector<RunPanel> panels() {
  const Sheet picture = fling_picture({1920, 1080});
  return {
      {.name = "fine", .status = "agreed", .picture = picture, .link = "#run=0"},
      {.name = "a-name-that-is-longer-than-the-line-of-a-panel",
       .status = "disagreed",
       .picture = fling_picture({400, 1080}),
       .link = "#run=1"},
      {.name = "new", .status = "played", .picture = picture, .text = "where <it> is", .command = "run new"},
      {.name = "broken", .status = "failed"},
      {.name = "later", .status = "agreed", .picture = picture, .link = "#run=2"}};
}

// Title, names and verdicts, a line for each line of text.
std::string texts_of(const std::string& svg) {
  std::string texts;
  for (const ShownText& each : texts_in(svg)) texts += each.text + "\n";
  return texts;
}

TEST(ContactSheet, SaysWhatDoesNotAgreeFirstByAMarkAndAWordAtBothWidths) {
  const std::string svg = contact_sheet_svg(panels());
  EXPECT_EQ(picture_faults(svg), std::vector<std::string>{});
  const std::size_t narrow = svg.find("<svg class=\"narrow\"");
  EXPECT_EQ(texts_of(svg.substr(0, narrow)),
            "5 scenarios: 1 disagreed, 1 failed, 1 played, 2 agreed\n"
            "a-name-that-is-longer-than-\nthe-line-of-a-panel\n✗ disagreed\nbroken\n✗ failed\n"
            "new\n– played\nfine\n✓ agreed\nlater\n✓ agreed\n");
  EXPECT_NE(texts_of(svg.substr(narrow)).find("a-name-that-\nis-longer-\n"), std::string::npos);
  const std::regex border(
      "<rect [^>]*rx=\"6\" fill=\"none\" stroke=\"([^\"]+)\" stroke-width=\"([^\"]+)\"( stroke-dash)?");
  std::string borders;
  const std::string wide = svg.substr(0, narrow);
  for (std::sregex_iterator found(wide.begin(), wide.end(), border), end; found != end; ++found)
    borders += (*found)[2].str() +
               ((*found)[1] == colour_named("good")  ? " good"
                : (*found)[1] == colour_named("bad") ? " bad"
                                                     : "") +
               ((*found)[3].matched ? " dashed, " : ", ");
  EXPECT_EQ(borders, "4 bad, 4 bad, 2 dashed, 1.5 good, 1.5 good, ");
}

TEST(ContactSheet, OfAPageLeadsToARunOrOpensWhatIsKnownOfIt) {
  const std::string html = contact_sheet_html(panels(), true);
  EXPECT_NE(html.find("<h1>5 scenarios"), html.npos);
  EXPECT_NE(html.find("<a class=\"panel bad\" href=\"#run=1\"><b>a-name"), html.npos);
  EXPECT_NE(html.find("<details class=\"panel notable\"><summary><b>new</b>\n<span>– played</span>\n<svg "),
            html.npos);
  EXPECT_NE(html.find("</summary>\n<p>where &lt;it> is</p>\n<code>run new</code>\n</details>"), html.npos);
  EXPECT_NE(html.find("<summary><b>broken</b>\n<span>✗ failed</span>\n</summary>"), html.npos)
      << "no picture";
  EXPECT_EQ(contact_sheet_html(panels(), false).find("<h1>"), html.npos);
}

TEST(RunPanelPicture, HasTheProportionsOfItsWindowAndNoText) {
  for (const Size& window : {Size{1920, 1080}, {400, 1080}}) {
    const Sheet picture = fling_picture(window);
    EXPECT_LE(picture.width, kPanelWidth);
    EXPECT_LE(picture.height, kPanelHeight);
    EXPECT_GE(std::max(picture.width / kPanelWidth, picture.height / kPanelHeight), 0.999);
    EXPECT_NEAR(picture.width / picture.height, static_cast<double>(window.width_px) / window.height_px,
                0.06);
    EXPECT_EQ(picture.svg.body().find("<text"), std::string::npos);
    EXPECT_LT(picture.svg.body().size(), 12'000u);
  }
}

TEST(PlotPanel, DrawsFiniteValuesToTheEdges) {
  const Series line{.name = "a", .x = {0, 5, kNotGiven, 10}, .y = {0, 1, 3, 2}};
  const Series dots{.name = "b", .look = {.form = Form::points}, .x = {10}, .y = {2}};
  const Sheet sheet = plot_panel({.series = {line, dots}});
  EXPECT_NE(sheet.svg.body().find("d=\"M4,126 101,65 198,4\""), std::string::npos) << sheet.svg.body();
  EXPECT_NE(sheet.svg.body().find("<circle cx=\"198\" cy=\"4\""), std::string::npos);
  EXPECT_EQ(plot_panel({}).width, 0.0);
  const Sheet equal = plot_panel({.y = {.is_reversed = true}, .series = {line}, .has_equal_scales = true});
  EXPECT_NE(equal.svg.body().find("d=\"M4,4 101,23.4 198,42.8\""), std::string::npos) << equal.svg.body();
}

}  // namespace
}  // namespace hyrax
