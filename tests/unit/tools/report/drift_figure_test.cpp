#include "tools/report/drift_figure.h"

#include <gtest/gtest.h>

#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

// Arcs of ten rows each, a second long, that end at the ground.
struct MeasuredRun : DriftRun {
  explicit MeasuredRun(std::size_t count) {
    for (std::size_t arc = 0; arc < count; ++arc) {
      const auto first = static_cast<std::int64_t>(10 * arc);
      const auto end_s = static_cast<double>(arc + 1);
      arcs.push_back({.first_step = first,
                      .last_step = first + 9,
                      .t_s = end_s,
                      .duration_s = 1.0,
                      .energy_parts = {.gravity = -12'000.0}});
      contacts.push_back({.step = first + 10, .t_s = end_s, .energy_parts = {.lift = 6'000.0}});
      for (std::int64_t row = 0; row < 10; ++row) {
        const auto n = static_cast<double>(row);
        rows.push_back({arc,
                        {.step = first + row,
                         .t_s = end_s - 1.0 + n / 9.0,
                         .energy_drift_px2_per_s2 = -12'000.0 * n / 9.0}});
        whole_rows.push_back({rows.back().errors.t_s, n});
      }
    }
    steps = static_cast<std::int64_t>(10 * count);
    simulated_s = static_cast<double>(count);
    summary.arcs = summary.contacts = static_cast<std::int64_t>(count);
    summary.secular_px_per_s = -10.0;
    summary.causes = {.gravity = -10.0 * simulated_s, .lift = 5.0 * simulated_s};
    whole.run = WholeRun{.end_px = 12.0};
  }
};

// At the end of each arc gravity took 10 px more, and its contact then gave 5 back. Of many bounces and
// inputs it marks no more than readers can distinguish, and neither a hand's way nor what comes after the
// last flight.
TEST(DriftFigure, OfRunsAreThoseApproved) {
  std::string text;
  const auto add = [&text](const std::string& what, std::size_t arcs, const auto& alter) {
    MeasuredRun run(arcs);
    run.scenario.name = "x";
    alter(run);
    text += what + "\n" + described(drift_figure(run));
  };
  add("half comes back", 3, [](DriftRun&) {});
  add("30 % come back", 3, [](DriftRun& run) { run.summary.causes.lift = 9.0; });
  add("more comes back", 3, [](DriftRun& run) { run.summary.causes.lift = 60.0; });
  add("it gains", 3, [](DriftRun& run) {
    run.summary.causes.lift = 0.1;
    run.summary.secular_px_per_s = 0.25;
  });
  add("it rests from 2 s on", 3, [](DriftRun& run) {
    run.summary.rests = {{2.0, 3.0}};
    run.summary.is_resting_at_end = true;
  });
  add("it rests in between", 3, [](DriftRun& run) { run.summary.rests = {{1.0, 2.0}}; });
  add("80 bounces", 80, [](DriftRun&) {});
  add("81 bounces", 81, [](DriftRun&) {});
  const Event stop{std::int64_t{5}, Stop{}}, place{std::int64_t{6}, Place{}}, late{std::int64_t{90}, Stop{}};
  add("13 inputs", 2, [&](DriftRun& run) { run.scenario = fling_at(60.0, 100, {13, stop}); });
  add("a hand's way, and late", 2, [&](DriftRun& run) {
    run.scenario = fling_at(60.0, 100, {stop, place, late});
  });
  expect_approved("tests/unit/tools/report/drift_figures.txt", text);
}

}  // namespace
}  // namespace hyrax
