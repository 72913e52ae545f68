// A recording on disk, during a session and at its end.
#include "tools/recorder/recording.h"

#include <gtest/gtest.h>

#include <future>
#include <new>
#include <utility>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/scenario/frame_clock.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/hyrax/recorder.h"

namespace hyrax {
namespace {

class RecordedSession : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.at(name); }
  // A throw every hundred frames.
  void play(std::int64_t frames) {
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      if (session.now().row.step % 100 == 0) session.apply(Fling{{900.0, -1000.0}});
      session.advance(1.0 / 60.0);
    }
  }
  void save() {
    session.recording()->save();
    saver.wait();
  }
  std::vector<std::string> names() const { return folder_.names(); }
  // Frames of a file that replays to its own state hash.
  static std::int64_t good_frames(const std::string& path) {
    const Scenario scenario = load_scenario(path);
    const RunSummary summary = replay(shipped_core(), scenario);
    EXPECT_EQ(scenario.expect->state_hash, hex(summary.state_hash)) << path;
    return summary.steps;
  }

  const TempFolder folder_;
  ScenarioSaver saver;
  std::vector<std::string> notes;
  Pet pet{shipped_core(), {{}, kDesktopWindow, kHyrax}, 1000, 0};
  Session& session = pet.session();
  Recorder recorder{
      pet,
      saver,
      1000,
      {.notify = [this](const std::string& note) { notes.push_back(note); }, .new_path = nullptr}};
};

TEST_F(RecordedSession, IsCompleteAfterEverySaveAndNoFileBefore) {
  recorder.start(path("empty.json"), 0);
  save();
  recorder.finish();
  EXPECT_TRUE(names().empty());
  play(10);
  recorder.start(path("Fling 1.json"), 0);
  for (int second = 1; second <= 5; ++second) {
    play(60);
    save();
    EXPECT_EQ(good_frames(path("Fling 1.json")), 60 * second);
  }
  play(7);
  recorder.finish();
  EXPECT_EQ(good_frames(path("Fling 1.json")), 307);
  EXPECT_FALSE(session.is_recording());
  EXPECT_EQ(load_scenario(path("Fling 1.json")).name, "fling-1");
}

TEST_F(RecordedSession, ContinuesInPartsBesideOtherFilesAndEndsAsOneFile) {
  write_text_file(path("long-2.json"), "mine");
  write_text_file(path("long-4.json"), "mine, too");
  recorder.start(path("long.json"), 0);
  play(2 * Recording::kPartFrames + 500);
  save();
  EXPECT_EQ(names(), (std::vector<std::string>{"long-2.json", "long-3.json", "long-4.json", "long-5.json",
                                               "long.json"}));
  for (const char* const part : {"long.json", "long-3.json"})
    EXPECT_EQ(good_frames(path(part)), Recording::kPartFrames);
  EXPECT_EQ(good_frames(path("long-5.json")), 500);
  recorder.finish();
  EXPECT_EQ(names(), (std::vector<std::string>{"long-2.json", "long-4.json", "long.json"}));
  EXPECT_EQ(good_frames(path("long.json")), 2 * Recording::kPartFrames + 500);
  EXPECT_EQ(read_text_file(path("long-2.json")), "mine");
  EXPECT_EQ(read_text_file(path("long-4.json")), "mine, too");
  write_text_file(path("one-2.json"), "mine");
  recorder.start(path("one.json"), 0);
  play(Recording::kPartFrames);
  recorder.finish();
  EXPECT_EQ(good_frames(path("one.json")), Recording::kPartFrames);
  EXPECT_EQ(read_text_file(path("one-2.json")), "mine") << "not the second part, which has no frame";
}

TEST_F(RecordedSession, LeavesAFileThatHasItsNameOrTakesItMeanwhile) {
  write_text_file(path("fling.json"), "mine");
  EXPECT_EQ(refusal_of([&] { recorder.start(path("fling.json"), 0); }),
            path("fling.json") + ": exists already; name another file, or remove it first");
  EXPECT_FALSE(session.is_recording());
  std::filesystem::remove(path("fling.json"));
  recorder.start(path("fling.json"), 0);
  write_text_file(path("fling.json"), "mine");
  play(50);
  save();
  EXPECT_EQ(good_frames(path("fling-2.json")), 50);
  play(20);
  EXPECT_THROW(recorder.finish(), Failure);
  EXPECT_EQ(read_text_file(path("fling.json")), "mine");
  EXPECT_EQ(good_frames(path("fling-2.json")), 70);
}

TEST_F(RecordedSession, ContinuesInFurtherFiles) {
  write_text_file(path("long-2.json"), "mine");
  recorder.start(path("long.json"), 0);
  for (const std::int64_t frames : {Recording::kPartFrames + 7, std::int64_t{20}, std::int64_t{30}}) {
    play(frames);
    session.apply(Fling{{100.0, -200.0}});
    save();
    recorder.continue_in_new_file();
  }
  play(40);
  recorder.finish();
  EXPECT_EQ(names(), (std::vector<std::string>{"long-2.json", "long-3.json", "long-4.json", "long-5.json",
                                               "long.json"}));
  EXPECT_EQ(good_frames(path("long.json")), Recording::kPartFrames + 7);
  EXPECT_EQ(good_frames(path("long-3.json")), 20);
  EXPECT_EQ(good_frames(path("long-4.json")), 30);
  EXPECT_EQ(good_frames(path("long-5.json")), 40);
}

TEST_F(RecordedSession, ContinuesWhereTheFileThatEndsCannotBeWritten) {
  recorder.start(path("fling.json"), 0);
  play(10);
  write_text_file(path("fling.json"), "mine");
  recorder.continue_in_new_file();
  EXPECT_TRUE(notes.back().starts_with(path("fling.json") + ": ")) << notes.back();
  ASSERT_TRUE(session.is_recording());
  play(20);
  recorder.finish();
  EXPECT_EQ(good_frames(path("fling-2.json")), 10);
  EXPECT_EQ(good_frames(path("fling-3.json")), 20);
}

// Simulates a system that runs out of memory.
TEST_F(RecordedSession, SurvivesEveryExceptionOfASave) {
  ScenarioSaver short_of_memory([](const Scenario& scenario) {
    if (step_count(scenario) > 5) throw std::bad_alloc();
    return scenario_file_text(scenario);
  });
  short_of_memory.save(path("long.json"), fling_at(60.0, 6));
  short_of_memory.wait();
  const auto failure = short_of_memory.take_failure();
  ASSERT_TRUE(failure.has_value());
  EXPECT_TRUE(failure->starts_with(path("long.json") + ": cannot be written: ")) << *failure;
  short_of_memory.save(path("short.json"), fling_at(60.0, 5));
  short_of_memory.wait();
  EXPECT_FALSE(short_of_memory.take_failure().has_value());
  EXPECT_EQ(names(), std::vector<std::string>{"short.json"});
}

TEST_F(RecordedSession, IsWrittenAsItIsLatestWhileADiskIsSlow) {
  std::promise<void> disk;
  std::vector<std::int64_t> written;
  ScenarioSaver slow([&, ready = disk.get_future().share()](const Scenario& scenario) {
    ready.wait();
    written.push_back(step_count(scenario));
    return scenario_file_text(scenario);
  });
  for (const auto& [name, steps] : {std::pair{"a.json", 1}, {"b.json", 2}, {"c.json", 3}, {"c.json", 4}})
    slow.save(path(name), fling_at(60.0, steps));
  disk.set_value();
  slow.wait();
  EXPECT_EQ(written, (std::vector<std::int64_t>{1, 2, 4}));
}

TEST_F(RecordedSession, IsNamedByItsFile) {
  EXPECT_EQ(scenario_name_of("a/@AZ[ `az{_09:.json"), "-az---az--09-");
  EXPECT_EQ(scenario_name_of("a/"), "recording");
  EXPECT_EQ(scenario_name_of(std::string(99, 'x') + ".json").size(), 64u);
}

TEST(NextDueTicks, KeepTheRateUnlessTheLastFrameWasLateOrTooEarly) {
  const auto due = [](std::int64_t now) {
    return next_due_ticks({.last_due_ticks = 1000, .now_ticks = now, .period_ticks = 100});
  };
  EXPECT_EQ(due(1000), 1100);
  EXPECT_EQ(due(1025), 1100);
  EXPECT_EQ(due(1026), 1126);
  EXPECT_EQ(due(1500), 1600);
  EXPECT_EQ(due(999), 1099);
}

TEST(PictureOf, APoseIsTheSmallestThatIsLargeEnough) {
  const std::string resources = read_text_file(HYRAX_SOURCE_DIR "/tools/hyrax/hyrax.rc");
  const auto expect_picture = [&](Pose pose, const std::string& name, int width_px, int percentage) {
    EXPECT_NE(resources.find("\n" + std::to_string(picture_of(pose, width_px)) + " RCDATA \"sprite/" + name +
                             "-" + std::to_string(percentage) + ".png\""),
              std::string::npos)
        << name << " " << width_px;
  };
  for (const auto& [pose, name] :
       {std::pair{Pose::fly, "fly"}, {Pose::held, "held"}, {Pose::stand, "stand"}, {Pose::sleep, "sleep"}})
    for (const int percentage : {100, 125, 150, 175, 200}) {
      const int width_px = 128 * percentage / 100;
      expect_picture(pose, name, width_px, percentage);
      expect_picture(pose, name, percentage == 100 ? 1 : width_px - 31, percentage);
      if (percentage == 200) expect_picture(pose, name, 999, percentage);
    }
}

TEST(Repeated, ARecordingIsSavedTwiceASecond) {
  Repeated saves(1000, Recording::kSavesPerSecond);
  EXPECT_TRUE(saves.is_due(0));
  saves.done(7000);
  EXPECT_FALSE(saves.is_due(7499));
  EXPECT_TRUE(saves.is_due(7500));
}

}  // namespace
}  // namespace hyrax
