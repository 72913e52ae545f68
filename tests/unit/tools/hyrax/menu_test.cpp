// What menu and recorder do, and the notes they show.
#include "tools/hyrax/menu.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

std::string shown(const MenuState& state) {
  std::string text;
  for (const MenuEntry& entry : menu_entries(state))
    text += entry.choice == Choice::none ? "| "
            : entry.is_enabled           ? entry.text + std::to_string(static_cast<int>(entry.choice)) + " "
                                         : "(" + entry.text + ") ";
  return text;
}

TEST(Menu, HasWhatIsPossibleNow) {
  EXPECT_EQ(shown({}),
            "&Throw1 &Pause2 &Reset3 | Start re&cording4 (&Save recording) Save what &just happened6 | "
            "&About Hyrax7 &Quit8 ");
  EXPECT_EQ(shown({.is_paused = true, .is_recording = true}),
            "&Throw1 &Go on2 &Reset3 | (Start re&cording) &Save recording5 Save what &just happened6 | "
            "&About Hyrax7 &Quit8 ");
  EXPECT_EQ(shown({.is_replay = true, .is_recording = true}),
            "(&Throw) (&Pause) (&Reset) | (Start re&cording) (&Save recording) (Save what &just happened) | "
            "&About Hyrax7 &Quit8 ");
}

class ChosenFromMenu : public testing::Test {
 protected:
  static constexpr std::int64_t kTicksPerS = 6000;

  void choose(Choice choice) { execute(choice, pet, recorder, ticks); }
  void frames(int count) {
    for (int frame = 0; frame < count; ++frame) pet.frame(ticks += kTicksPerS / 60);
  }
  std::string path(const std::string& name) const { return folder.at(name); }
  static std::int64_t good_frames(const std::string& path) {
    const Scenario scenario = load_scenario(path);
    const RunSummary summary = replay(shipped_core(), scenario);
    EXPECT_EQ(scenario.expect->state_hash, hex(summary.state_hash));
    return summary.steps;
  }
  // Another thread saves.
  static void wait_until(const std::function<bool()>& is_done) {
    for (int tries = 0; tries < 10'000 && !is_done(); ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_TRUE(is_done());
  }

  const TempFolder folder;
  std::vector<std::string> notes;
  std::int64_t ticks = 77;
  Pet pet{shipped_core(), {{100, 50}, {1024, 768}, {128, 128}}, kTicksPerS, ticks};
  ScenarioSaver saver;
  Recorder recorder{
      pet,
      saver,
      kTicksPerS,
      {.notify = [this](const std::string& note) { notes.push_back(note); },
       .new_path = [this](const std::string& name) { return free_path(path(name + ".json")); }}};
};

TEST_F(ChosenFromMenu, AThrowGoesUpAndToEitherSide) {
  int left = 0;
  for (; ticks < 200; ++ticks) {
    choose(Choice::throw_it);
    const Row& row = pet.session().now().row;
    EXPECT_TRUE(std::fabs(row.vx_px_per_s) >= 600.0 && std::fabs(row.vx_px_per_s) <= 2000.0)
        << row.vx_px_per_s;
    EXPECT_TRUE(row.vy_px_per_s <= -800.0 && row.vy_px_per_s >= -1700.0) << row.vy_px_per_s;
    left += row.vx_px_per_s < 0.0;
  }
  EXPECT_TRUE(left > 30 && left < 90) << left;
}

TEST_F(ChosenFromMenu, ThePetPausesGoesOnAndIsReset) {
  frames(10);
  choose(Choice::pause);
  EXPECT_TRUE(pet.is_paused());
  frames(10);
  EXPECT_EQ(pet.session().now().row.step, 10);
  choose(Choice::pause);
  EXPECT_FALSE(pet.is_paused());
  frames(1);
  EXPECT_EQ(pet.session().now().row.dt_s, 1.0 / 60.0);
  choose(Choice::reset);
  frames(1);
  EXPECT_EQ(pet.inputs_of_frame(), (std::vector<Action>{Place{{448.0, 0.0}}, Stop{}}));
  for (const Choice choice : {Choice::none, Choice::about, Choice::quit}) choose(choice);
  frames(1);
  EXPECT_TRUE(pet.inputs_of_frame().empty() && notes.empty());
}

TEST_F(ChosenFromMenu, RecordingsAreNewFilesThatReplay) {
  choose(Choice::save_just_happened);  // Nothing has.
  frames(5);
  choose(Choice::start_recording);
  EXPECT_TRUE(pet.session().is_recording());
  frames(7);
  choose(Choice::save_recording);
  EXPECT_FALSE(pet.session().is_recording());
  choose(Choice::save_just_happened);
  choose(Choice::save_just_happened);
  EXPECT_EQ(notes,
            (std::vector<std::string>{
                "Recording to " + path("recording.json"), "Saved as " + path("recording.json"),
                "Saved as " + path("just-happened.json"), "Saved as " + path("just-happened-2.json")}));
  EXPECT_EQ(good_frames(path("recording.json")), 7);
  EXPECT_EQ(good_frames(path("just-happened-2.json")), 12);
  std::filesystem::remove_all(folder.at(""));
  EXPECT_TRUE(refusal_of([&] { choose(Choice::save_just_happened); }, ExitCode::cannot_access)
                  .starts_with(path("just-happened.json") + ": cannot be written"));
}

TEST_F(ChosenFromMenu, ARecordingIsSavedWhenItIsDueAndBeforeTheSleep) {
  recorder.save_if_due(ticks);
  recorder.finish();
  EXPECT_TRUE(refusal_of([&] { recorder.start(path("no/fling.json"), ticks); }, ExitCode::cannot_access)
                  .starts_with(path("no/fling.json") + ": cannot be written"));
  recorder.start(path("fling.json"), ticks);
  frames(29);
  recorder.save_if_due(ticks);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(is_there(path("fling.json")));
  frames(1);
  recorder.save_if_due(ticks);
  wait_until([&] { return is_there(path("fling.json")); });
  EXPECT_EQ(good_frames(path("fling.json")), 30);
  frames(5);
  choose(Choice::pause);
  wait_until([&] {
    return load_scenario(path("fling.json")).expect->state_hash ==
           hex(pet.session().just_happened().state_hash());
  });
  EXPECT_TRUE(notes.empty());
}

TEST_F(ChosenFromMenu, ARecordingOfFiveHoursContinuesInANewFile) {
  recorder.start(path("fling.json"), ticks);
  for (std::int64_t frame = 1; frame < Recording::kFramesMax; ++frame) pet.session().advance(0.25);
  recorder.save_if_due(ticks);
  EXPECT_TRUE(notes.empty());
  pet.session().advance(0.25);
  recorder.save_if_due(ticks);
  EXPECT_EQ(notes, std::vector<std::string>{"The recording continues in " + path("fling-2.json")});
  choose(Choice::throw_it);
  frames(5);
  recorder.save();
  EXPECT_EQ(notes.back(), "Saved as " + path("fling-2.json"));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"fling-2.json", "fling.json"}));
  EXPECT_EQ(good_frames(path("fling-2.json")), 5);
}

TEST_F(ChosenFromMenu, ARecordingThatCannotBeSavedContinuesAndIsSavedLater) {
  std::filesystem::create_directory(path("gone"));
  recorder.start(path("gone/fling.json"), ticks);
  frames(30);
  std::filesystem::remove(path("gone"));
  for (int attempt = 0; attempt < 2; ++attempt) {
    choose(Choice::save_recording);
    EXPECT_TRUE(notes.back().starts_with(path("gone/fling.json") + ": cannot be written") &&
                notes.back().ends_with("; the recording continues"))
        << notes.back();
    ASSERT_TRUE(pet.session().is_recording());
    frames(5);
  }
  std::filesystem::create_directory(path("gone"));
  std::ofstream(path("gone/fling.json")) << "mine";  // Another's, though it was to be written before.
  for (int attempt = 0; attempt < 2; ++attempt) {
    choose(Choice::save_recording);
    EXPECT_EQ(notes.back(), path("gone/fling.json") +
                                ": cannot be written: File exists; what was saved is in " +
                                path("gone/fling-2.json") + "; the recording continues");
  }
  EXPECT_EQ(good_frames(path("gone/fling-2.json")), 40);
  std::filesystem::remove(path("gone/fling.json"));
  frames(2);
  choose(Choice::save_recording);
  EXPECT_EQ(notes.back(), "Saved as " + path("gone/fling.json"));
  EXPECT_EQ(good_frames(path("gone/fling.json")), 42);
  EXPECT_FALSE(is_there(path("gone/fling-2.json")) || pet.session().is_recording());
}

TEST_F(ChosenFromMenu, AFailureToSaveIsReportedOnce) {
  std::filesystem::create_directory(path("gone"));
  recorder.start(path("gone/fling.json"), ticks);
  std::filesystem::remove(path("gone"));
  const auto save = [&] {
    frames(30);
    recorder.save_if_due(ticks);
    return !notes.empty();
  };
  wait_until(save);
  for (int again = 0; again < 5; ++again) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    save();
  }
  EXPECT_EQ(notes.size(), 1u);
  EXPECT_TRUE(notes.front().starts_with(path("gone/fling.json") + ": cannot be written")) << notes.front();
  choose(Choice::save_just_happened);
  EXPECT_EQ(notes.back(), "Saved as " + path("just-happened.json"));
  EXPECT_THROW(recorder.finish(), Failure);
  EXPECT_FALSE(pet.session().is_recording());
}

}  // namespace
}  // namespace hyrax
