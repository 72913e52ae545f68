// Everything that each study gives, as data: tables, figures, verdict and summary, against the approved text;
// its pictures have no faults.
#include "tests/unit/sim/result/described.h"

#include <fmt/format.h>

#include "sim/core/shipped_core.h"
#include "sim/study/study.h"
#include "sim/trace/step_program.h"
#include "sim/trace/step_text.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/study/clocks.h"
#include "tests/unit/tools/report/picture_faults.h"
#include "tools/report/figure_svg.h"

namespace hyrax {
namespace {

NamedScenario named(const std::string& name, Scenario scenario) {
  scenario.name = name;
  return {name + ".json", std::move(scenario)};
}

// Steady enough to measure by, and no two medians and ends of intervals need be equal.
std::int64_t nearly_steady_ns() {
  static std::int64_t now_ns = 0, calls = 0;
  return now_ns += 100'000 + 400 * (++calls % 7);
}

Result quick(const Study& study, std::string& progress) {
  StudyRequest request{.core = shipped_core(),
                       .is_quick = true,
                       .core_step = make_step_program(read_step(shipped_core().record.step).value()),
                       .machine = "some machine",
                       .measure_costs = metered<nearly_steady_ns>};
  std::int64_t calls = 0;
  request.report_progress = [&](const std::string& unit, std::int64_t done, std::int64_t total) {
    progress = fmt::format("progress {}: {} of {}, called {} times\n", unit, done, total, ++calls);
  };
  if (study.name != "frame-rate") {  // Which has a fling of its own.
    request.scenarios = {named("calm", fling_at(60.0, 300)), named("eventful", fling_at(144.0, 500))};
    request.scenarios[1].scenario.events = {{std::int64_t{40}, Hitch{0.1}}, {2.5, Fling{{-700.0, -300.0}}}};
  }
  if (study.name == "hard-cases") {  // One that breaks an expectation, and some of expected failures.
    request.scenarios[0].scenario.expect.emplace().final_x_px = Interval{-2.0, -1.0};
    request.scenarios.push_back(
        named("rest", load_scenario(std::string(HYRAX_SOURCE_DIR) + "/scenarios/hard/rest.json")));
    request.scenarios.push_back(named("wide", fling_at(60.0, 120)));
    request.scenarios.back().scenario.sprite.width_px = 3000;
  }
  if (study.name == "needs") {
    request.within_px = 40.0;  // Some method is cheaper than the paper's step.
    // More parts than are printed and drawn.
    request.scenarios.push_back(named("busy", fling_at(60.0, 120, {33, {std::int64_t{60}, Stop{}}})));
  }
  return study.run(request);
}

TEST(Results, OfEveryStudyAreThoseApproved) {
  for (const Study& study : studies()) {
    std::string text;
    const Result result = quick(study, text);
    for (const Table& table : result.tables) text += described(table);
    for (const Figure& figure : result.figures) {
      text += described(figure);
      SCOPED_TRACE(study.name + ": " + figure.title);
      EXPECT_EQ(picture_faults(figure_svg(figure)), std::vector<std::string>{});
      EXPECT_EQ(picture_faults(figure_html(figure)), std::vector<std::string>{});
      if (const auto* const plots = std::get_if<std::vector<Plot>>(&figure.body)) {
        for (const Plot& plot : *plots) EXPECT_EQ(shared_looks(plot.series), std::vector<std::string>{});
      }
    }
    EXPECT_FALSE(result.verdict.answer.empty()) << study.name;
    EXPECT_LE(result.verdict.answer.size(), 80u) << result.verdict.answer;
    text += described(result.verdict) + "summary\n";
    for (const Table& table : result.summary) text += described(table, "  ");
    expect_approved("tests/unit/sim/study/approved/" + study.name + ".txt", text);
  }
}

}  // namespace
}  // namespace hyrax
