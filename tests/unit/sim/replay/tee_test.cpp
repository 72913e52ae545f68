// One replay into several sinks.
#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/replay/trace_sink.h"

namespace hyrax {
namespace {

TEST(Tee, GivesEachSinkWhatItWouldGetAlone) {
  const RowSink::Wants all[] = {{.rows_every = 1},
                                {.rows_every = 7, .contacts = true},
                                {.contacts = true, .blocks = true},
                                {.rows_every = 4096, .blocks = true},
                                {}};
  for (const Scenario& scenario : {eventful_fling(), fling_at(60.0, 20'000), fling_at(60.0, 0)}) {
    TraceSink together[] = {TraceSink(all[0]), TraceSink(all[1]), TraceSink(all[2]), TraceSink(all[3]),
                            TraceSink(all[4])};
    std::vector<RowSink*> sinks;
    for (TraceSink& sink : together) sinks.push_back(&sink);
    const RunSummary summary = replay(shipped_core(), scenario, sinks);
    for (std::size_t index = 0; index < std::size(together); ++index) {
      TraceSink alone(all[index]);
      EXPECT_EQ(replay(shipped_core(), scenario, alone).state_hash, summary.state_hash);
      EXPECT_TRUE(same_trace(together[index], alone)) << index;
    }
  }
}

// Every row up to 5,000, then every 1,000th; from row 12,000 on nothing.
class FewerAndFewer : public RowSink {
 public:
  Wants wants() const override {
    return {.rows_every = steps.empty() || steps.back() < 12'000 ? 1000 : 0, .all_rows_to = 5000};
  }
  void rows(const Columns& batch) override {
    steps.insert(steps.end(), batch.step.begin(), batch.step.end());
  }
  void repeats(const Repetition& found) override { repetition = found; }
  std::vector<std::int64_t> steps;
  Repetition repetition;
};

TEST(Tee, GivesASinkFewerRowsWhenItRequestsFewer) {
  FewerAndFewer sink;
  const RunSummary summary = replay(shipped_core(), fling_at(60.0, 10'000'000), sink);
  ASSERT_GT(sink.steps.size(), 5001u);
  for (std::int64_t step = 0; step <= 5000; ++step)
    ASSERT_EQ(sink.steps[static_cast<std::size_t>(step)], step);
  EXPECT_EQ(sink.steps[5001], 6000);
  EXPECT_EQ(sink.steps[5002], 7000);
  EXPECT_LT(sink.steps.size(), 10'001u);  // It is queried again after a batch.
  EXPECT_EQ(sink.repetition.from_step, summary.periodic_from_step);
  EXPECT_EQ(sink.repetition.period_steps, summary.period_steps);
}

}  // namespace
}  // namespace hyrax
