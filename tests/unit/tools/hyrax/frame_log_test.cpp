// What hyrax.exe logs of each frame.
#include <gtest/gtest.h>

#include "tests/unit/tools/files/refusal.h"
#include "tests/unit/tools/store/temp_folder.h"
#include "tools/files/text_file.h"
#include "tools/hyrax/frame_log.h"

namespace hyrax {
namespace {

// On a second monitor, of which no side is 0.
TEST(FrameLog, HasEachNumberUnderItsName) {
  const TempFolder folder;
  const std::string path = folder.at("frames");
  Keyframe now;
  now.row = {8, 1.5, 0.25, 2.0, 3.0, -4.0, 5.0, 0};
  now.is_held = true;
  const Desk desk{.origin = {-1920, 30}, .work_area = {1900, 1000}, .sprite = {128, 96}};
  FrameLog log(path);
  log.frame(now, desk, {Grab{}, Resize{Size{1, 1}, {}}, Resize{{}, Size{2, 2}}}, {-1918, 33, -1790, 129});
  log.sleep(now);
  EXPECT_EQ(refusal_of([&] { FrameLog{path}; }),
            path + ": exists already; name another file, or remove it first");
  EXPECT_EQ(refusal_of([&] { FrameLog{folder.at("")}; }, ExitCode::cannot_access),
            folder.at("") + ": cannot be written: Is a directory");
  // A program that is killed now has written it all.
  EXPECT_EQ(
      read_text_file(path),
      R"({ "frame": 7, "t_s": 1.5, "dt_s": 0.25, "x_px": 2, "y_px": 3, "vx_px_per_s": -4, "vy_px_per_s": 5, )"
      R"("held": true, "window_rect_px": [-1918, 33, -1790, 129], "work_area_px": [-1920, 30, -20, 1030], )"
      R"("sprite_px": [128, 96], "inputs": ["grab", "resize-window", "resize-sprite"] })"
      "\n{ \"asleep_after_frame\": 7 }\n");
}

TEST(FrameLog, OfAFullDiskFailsAtTheEnd) {
  FrameLog log("/dev/full");
  log.finish();
  log.sleep({});
  EXPECT_EQ(refusal_of([&] { log.finish(); }, ExitCode::cannot_access),
            "/dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace hyrax
