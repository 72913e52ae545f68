// What a program does to its class physics becomes a scenario that replays to the same bits.
#include "tools/recorder/physics_recorder.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/core/shipped_core.h"
#include "sim/physics/physics.h"
#include "sim/replay/replay.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"

namespace hyrax {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class RecordedPhysics : public testing::Test {
 protected:
  std::string path(const std::string& name = "throw.json") const { return folder_.at(name); }
  void play(auto& recorder, int frames) {
    for (int frame = 0; frame < frames; ++frame)
      recorder.update(pet, 0.016 + 0.001 * (frame % 3), width_px, 720, 128, 112);
  }
  // What a program does to a pet: it throws, holds, drags, drops, stops it and changes the window.
  void live(auto& recorder) {
    play(recorder, 60);
    pet.setVelocity(900.0, -1200.0);
    play(recorder, 40);
    for (int frame = 0; frame < 20; ++frame) {
      pet.setPos(400.0 + 3.0 * frame, 200.25);
      recorder.hold(pet, 1.0 / 60.0, width_px, 720, 128, 112);
    }
    pet.setVelocity(-0.0, 5.0);  // Of a hand that is still; the sign is a bit, too.
    play(recorder, 50);
    width_px = 900;
    pet.resetVelocity();
    play(recorder, 50);
  }
  static void expect_replays(const std::string& file, std::int64_t frames, bool agrees = true) {
    const Scenario scenario = load_scenario(file);
    const RunSummary run = replay(shipped_core(), scenario);
    EXPECT_EQ(run.steps, frames);
    EXPECT_EQ(*scenario.expect->state_hash == hex(run.state_hash), agrees);
  }

  const TempFolder folder_;
  physics pet{300.0, 10.0, 450.0, -0.0};
  int width_px = 1280;
};

TEST_F(RecordedPhysics, ReplaysToTheHashOfWhatWasShown) {
  PhysicsRecorder recorder(path(), pet, {1280, 720}, {128, 112});
  live(recorder);
  recorder.finish();
  EXPECT_EQ(recorder.failure(), std::nullopt);
  expect_replays(path(), 220);
  const Scenario scenario = load_scenario(path());
  std::vector<std::string_view> kinds;
  for (const Event& event : scenario.events) kinds.push_back(name_of(event.action));
  EXPECT_EQ(std::vector(kinds.begin(), kinds.begin() + 3),
            (std::vector<std::string_view>{"fling", "grab", "place"}));
  EXPECT_EQ(std::vector(kinds.end() - 3, kinds.end()),
            (std::vector<std::string_view>{"release", "resize", "fling"}));
  // A control: without its events it is another run.
  Scenario altered = scenario;
  altered.events.pop_back();
  EXPECT_NE(hex(replay(shipped_core(), altered).state_hash), *scenario.expect->state_hash);
  live(recorder);  // After the end it only moves the pet.
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"throw.json"});
}

// As one that counts in a static variable. The recorder calls update, too: every odd call is the program's.
struct SecretivePhysics : physics {
  using physics::physics;
  void update(double dt, int width, int height, int sprite_width, int sprite_height) {
    physics::update(dt, width, height, sprite_width, sprite_height);
    if (++calls == 31) setPos(x() + 1e-9, y());
  }
  static inline int calls = 0;
};

TEST_F(RecordedPhysics, DoesNotReplayWhereTheStepDependsOnMoreThanTheBody) {
  SecretivePhysics secretive(300.0, 10.0, 450.0, 0.0);
  PhysicsRecorder recorder(path(), secretive, {1280, 720}, {128, 112});
  for (int frame = 0; frame < 60; ++frame) recorder.update(secretive, 0.016, 1280, 720, 128, 112);
  recorder.finish();
  expect_replays(path(), 60, false);
}

TEST_F(RecordedPhysics, IsOnTheDiskWithinASecondAndLeavesOtherFiles) {
  write_text_file(path(), "mine");
  PhysicsRecorder recorder(path(), pet, {1280, 720}, {128, 112});
  EXPECT_EQ(recorder.path(), path("throw-2.json"));
  play(recorder, 1);  // The first frame is saved at once.
  for (int wait = 0; wait < 500 && folder_.names().size() < 2; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(read_text_file(path()), "mine");
  EXPECT_EQ(load_scenario(path("throw-2.json")).expect->state_hash.has_value(), true);
}

TEST_F(RecordedPhysics, EndsWhereNoScenarioCanFollow) {
  for (const auto& [dt_s, velocity, what] :
       {std::tuple{kNaN, 0.0, "a dt, size, position or speed that no scenario may have"},
        {0.016, kNaN, "a dt, size, position or speed that no scenario may have"}}) {
    const std::string file = path(std::to_string(folder_.names().size()) + ".json");
    pet = physics(300.0, 10.0, 450.0, 0.0);
    PhysicsRecorder recorder(file, pet, {1280, 720}, {128, 112});
    play(recorder, 10);
    pet.setVelocity(velocity, 0.0);
    recorder.update(pet, dt_s, 1280, 720, 128, 112);
    EXPECT_FALSE(recorder.is_recording());
    EXPECT_EQ(recorder.failure(), file + ": the recording ended: " + what);
    expect_replays(file, 10);
  }
  pet = physics(300.0, 10.0, 450.0, 0.0);
  PhysicsRecorder nowhere(path("no-folder/throw.json"), pet, {1280, 720}, {128, 112});
  play(nowhere, 10);  // The program goes on.
  EXPECT_TRUE(nowhere.failure()->starts_with(path("no-folder/throw.json") + ": cannot be written: "));
}

}  // namespace
}  // namespace hyrax
