// What a program does to a core that describes itself becomes a scenario that plays to the same bits.
#include "tools/recorder/core_recorder.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/described/described_run.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/described/scenario_json.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

struct RecordedToy {
  double x = 10, v = 100, wind = 0, gravity = 900;
  float heat = 0.5F;
  int bounces = 0;
  bool is_wet = false, is_down = false;

  void step(double dt_s) {
    v += (gravity + wind) * dt_s;
    x += v * dt_s;
    heat *= 0.99F;
    is_down = x > 500;
    if (is_down) x = 500, v = -0.8 * v, ++bounces;
  }
  void state(auto&& see) {
    see("x_px", x);
    see("v_px_per_s", v);
    see("heat", heat, {0.0, 1.0});
    see("bounces", bounces);
    see("wet", is_wet);
  }
  void inputs(auto&& see) { see("wind_px_per_s2", wind); }
  void parameters(auto&& see) { see("gravity_px_per_s2", gravity); }
  void contacts(auto&& see) const { see("floor", is_down); }
};

class RecordedCore : public testing::Test {
 protected:
  std::string path() const { return folder_.at("toy.json"); }
  void play(CoreRecorder<RecordedToy>& recorder, int frames) {
    for (int frame = 0; frame < frames; ++frame) recorder.step(toy, 0.016 + 0.001 * (frame % 3));
  }
  DescribedScenario read() const {
    return parse_described_scenario(core.description, read_text_file(path()), path());
  }
  void expect_replays(std::int64_t frames) const {
    const DescribedScenario scenario = read();
    const DescribedSummary run = hyrax::play(core, scenario, {});
    EXPECT_EQ(run.steps, frames);
    EXPECT_EQ(hex(run.state_hash), *scenario.expect->state_hash);
  }

  const TempFolder folder_;
  const DescribedCore core = described_core_of<RecordedToy>("toy", {});
  RecordedToy toy;
};

TEST_F(RecordedCore, ReplaysToTheHashOfWhatWasShown) {
  toy.gravity = 1000;
  toy.x = 20.5;
  CoreRecorder recorder(path(), "toy", toy);
  play(recorder, 100);
  toy.v = -700;
  toy.wind = -50;
  toy.is_wet = true;
  play(recorder, 5000);  // More than a block of rows.
  for (int frame = 0; frame < 10; ++frame) {
    toy.x = 100.0 + frame;
    recorder.hold(toy, 0.016);
  }
  toy.wind = 0;
  play(recorder, 50);
  recorder.finish();
  EXPECT_EQ(recorder.failure(), std::nullopt);
  expect_replays(5160);
  const DescribedScenario scenario = read();
  EXPECT_EQ(scenario.core, "toy");
  EXPECT_EQ(scenario.events.front(),
            (DescribedEvent{std::int64_t{100},
                            SetValues{{{0, word_of(-50.0)}}, {{1, word_of(-700.0)}, {4, word_of(true)}}}}));
  // A control: without its last event it is another run.
  DescribedScenario altered = scenario;
  altered.events.pop_back();
  EXPECT_NE(hex(hyrax::play(core, altered, {}).state_hash), *scenario.expect->state_hash);
}

TEST_F(RecordedCore, EndsWhereNoScenarioCanFollow) {
  const auto expect_end = [&](const auto& spoil, double dt_s, const std::string& what) {
    std::filesystem::remove(path());
    toy = {};
    CoreRecorder recorder(path(), "toy", toy);
    play(recorder, 7);
    spoil();
    recorder.step(toy, dt_s);
    recorder.step(toy, 0.016);
    EXPECT_EQ(recorder.failure(), path() + ": the recording ended: " + what);
    expect_replays(7);
  };
  expect_end([] {}, -1.0, "a dt that no scenario may have");
  expect_end([&] { toy.gravity = 1; }, 0.016, "a parameter changed");
  expect_end([&] { toy.heat = 2.0F; }, 0.016, "heat has a value that no scenario may have");
  expect_end([&] { toy.x = std::numeric_limits<double>::infinity(); }, 0.016,
             "x_px has a value that no scenario may have");
}

// The frame that made it is in the file: the bug is what is recorded.
TEST_F(RecordedCore, EndsWithTheFrameWhoseStateIsNotFinite) {
  CoreRecorder recorder(path(), "toy", toy);
  play(recorder, 7);
  toy.v = -1e308;
  recorder.step(toy, 100.0);
  EXPECT_EQ(recorder.failure(), path() + ": the recording ended: x_px is not finite");
  const DescribedSummary run = hyrax::play(core, read(), {});
  EXPECT_EQ(run.early_end->step, 8);
  EXPECT_EQ(hex(run.state_hash), *read().expect->state_hash);
}

}  // namespace
}  // namespace hyrax
