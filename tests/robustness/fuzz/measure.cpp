// Measuring the rows of somebody's trajectory file against the reference: the input is rows of six
// doubles (t, dt, x, y, vx, vy) and a contact byte each, of any value.
#include <cstring>

#include "sim/reference/drift_meter.h"
#include "sim/reference/margin.h"
#include "tests/robustness/fuzz/fuzz_target.h"

namespace hyrax {
namespace {

constexpr std::size_t kRowBytes = 49;

Columns rows_in(const std::uint8_t* data, std::size_t size) {
  Columns rows;
  for (std::int64_t step = 0; size >= kRowBytes; ++step, data += kRowBytes, size -= kRowBytes) {
    double values[6];
    std::memcpy(values, data, sizeof values);
    rows.append({step, values[0], values[1], values[2], values[3], values[4], values[5], data[48]});
  }
  return rows;
}

Scenario scenario_of(std::int64_t steps) {
  Scenario scenario;
  scenario.window = {800, 600};
  scenario.sprite = {100, 100};
  scenario.length = steps;
  return scenario;
}

}  // namespace
}  // namespace hyrax

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hyrax;
  const Columns rows = rows_in(data, size);
  if (rows.size() < 2) return 0;
  const Scenario scenario = scenario_of(static_cast<std::int64_t>(rows.size()) - 1);
  const std::vector<Input> inputs = {{1, Fling{{900.0, -600.0}}}, {2, Resize{Size{0, 0}, {}}}};
  DriftSink sink;
  DriftMeter drift(scenario, inputs, sink);
  drift.rows(rows);
  static_cast<void>(drift.finish());
  MarginMeter margin(scenario, inputs);
  margin.rows(rows);
  static_cast<void>(margin.margin());
  return 0;
}
