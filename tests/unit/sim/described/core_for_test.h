// Cores and scenarios of the tests of this folder.
#pragma once

#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "sim/described/described_run.h"
#include "sim/described/see.h"

namespace hyrax {

/// A core whose state is one place; what is derived from it says how that moves.
struct OnePlace {
  double x = 0.0;
  void state(auto&& see) { see("x_px", x); }
};

template <class Core>
DescribedCore core_for_test() {
  return described_core_of<Core>("tested", {});
}

/// At 60 Hz.
inline DescribedScenario scenario_for_test(std::int64_t steps) {
  DescribedScenario scenario;
  scenario.clock.base = FixedRate{60.0};
  scenario.length = steps;
  return scenario;
}

inline DescribedEvent event_for_test(std::int64_t frame, DescribedAction action) {
  return {frame, std::move(action)};
}

/// All rows of a run.
struct RowsForTest : DescribedSink {
  struct Kept {
    std::int64_t step;
    double t_s;
    double dt_s;
    std::vector<Word> state;
    std::vector<Word> outputs;
    std::vector<std::uint8_t> contacts;
  };
  std::vector<Kept> rows = {};
  std::vector<DescribedContact> ended = {};
  std::vector<DescribedBlock> blocks = {};

  void row(const DescribedRow& row) override {
    rows.push_back({row.step,
                    row.t_s,
                    row.dt_s,
                    {row.state.begin(), row.state.end()},
                    {row.outputs.begin(), row.outputs.end()},
                    {row.contacts.begin(), row.contacts.end()}});
  }
  void contact(const DescribedContact& contact) override { ended.push_back(contact); }
  void block(const DescribedBlock& block) override { blocks.push_back(block); }

  /// A state value that is a double.
  [[nodiscard]] double number(std::size_t row, std::size_t place = 0) const {
    return std::bit_cast<double>(rows[row].state[place]);
  }
};

inline DescribedSummary play_for_test(const DescribedCore& core, const DescribedScenario& scenario,
                                      RowsForTest& rows) {
  DescribedSink* const sinks[] = {&rows};
  return play(core, scenario, sinks);
}

}  // namespace hyrax
