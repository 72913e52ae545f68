#include "sim/core/shipped_core.h"
#include "sim/reference/drift_meter.h"
#include "sim/reference/gsl_flight.h"
#include "sim/replay/replay.h"
#include "tests/benchmarks/figure.h"
#include "tests/benchmarks/naive_step.h"

namespace hyrax::bench {
namespace {

constexpr int kRounds = 15;
constexpr int kRunsPerRound = 50;
constexpr std::int64_t kSteps = 600;  // 10 s at 60 Hz.

struct EveryRow final : DriftSink {
  [[nodiscard]] bool wants_rows() const override { return true; }
  void row(const RowErrors& row) override { sum += row.truncation_px + row.energy_drift_px2_per_s2; }
  double sum = 0.0;
};

void measure(const Scenario& scenario, FlightSolver* solver) {
  EveryRow rows;
  DriftMeter meter(scenario, {}, rows, solver);
  static_cast<void>(replay(shipped_core(), scenario, meter));
  keep(meter.finish().arcs);
  keep(rows.sum);
}

void drift_ratios(const std::string& what, const Scenario& scenario, std::vector<Figure>& figures) {
  const std::unique_ptr<FlightSolver> gsl = gsl_flight();
  const auto repeat = [](const auto& work) {
    return [work] {
      for (int run = 0; run < kRunsPerRound; ++run) work();
    };
  };
  const auto timings = time_side_by_side(
      {repeat([&] { step_naively(start_state(scenario), kSteps, scenario.window); }),
       repeat([&] { measure(scenario, nullptr); }), repeat([&] { measure(scenario, gsl.get()); })},
      kRounds);
  figures.push_back(ratio("drift of " + what + ", closed form, every row, times naive", timings[1],
                          timings[0], Goal::at_most, 15.0));
  figures.push_back(ratio("drift of " + what + ", GSL beside it, times naive", timings[2], timings[0],
                          Goal::at_most, 60.0));
}

}  // namespace

std::vector<Figure> drift_figures() {
  std::vector<Figure> figures;
  Scenario scenario = desktop_fling({60.0, 900.0, 1000.0, -1350.0}, kSteps);
  drift_ratios("10 s", scenario, figures);
  scenario.window = {1'000'000, 1'000'000};  // Nothing rests, so every row has its errors.
  drift_ratios("10 s all in flight", scenario, figures);
  return figures;
}

}  // namespace hyrax::bench
