// A core that describes itself, played and compared by a program that has nothing of the paper's.
#include <gtest/gtest.h>
#include <bit>

#include "sim/described/described_comparison.h"
#include "sim/described/see.h"

namespace hyrax {
namespace {

struct Pendulum {
  double angle_rad = 1.0;
  double turn_rad_per_s = 0.0;
  void step(double dt_s) {
    turn_rad_per_s -= 9.81 * angle_rad * dt_s;
    angle_rad += turn_rad_per_s * dt_s;
  }
  void state(auto&& see) {
    see("angle_rad", angle_rad);
    see("turn_rad_per_s", turn_rad_per_s);
  }
};

struct Rows : DescribedSink {
  std::vector<double> angles_rad = {};
  DescribedRows kept = {};
  void row(const DescribedRow& row) override {
    angles_rad.push_back(std::bit_cast<double>(row.state[0]));
    kept.append(row);
  }
};

TEST(GeneralHalf, PlaysAndComparesWithoutThePapers) {
  const DescribedCore core = described_core_of<Pendulum>("pendulum", {});
  DescribedScenario scenario;
  scenario.clock.base = FixedRate{60.0};
  scenario.length = std::int64_t{300};
  Rows rows, lower;
  DescribedSink* sinks[] = {&rows};
  EXPECT_EQ(play(core, scenario, sinks).steps, 300);
  Pendulum own;
  for (const double angle_rad : rows.angles_rad) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(angle_rad), std::bit_cast<std::uint64_t>(own.angle_rad));
    own.step(1.0 / 60.0);
  }
  EXPECT_EQ(description_fault(core, scenario), std::nullopt);
  scenario.start = {{0, word_of(0.5)}};
  sinks[0] = &lower;
  static_cast<void>(play(core, scenario, sinks));
  const DescribedComparison comparison =
      compare_runs(core.description, {batches_of(rows.kept)}, {batches_of(lower.kept)});
  EXPECT_EQ(comparison.difference, DifferenceClass::values);
  EXPECT_EQ(comparison.first->step, 0);
}

}  // namespace
}  // namespace hyrax
