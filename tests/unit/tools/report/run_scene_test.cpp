// What a picture of a run shows, as data: path, beads, throws, inputs, contacts and the view are those
// approved.
#include "tools/report/run_scene.h"

#include <gtest/gtest.h>

#include "sim/core/shipped_core.h"
#include "sim/replay/replay.h"
#include "sim/trajectory/stored_run.h"
#include "tests/unit/sim/replay/some_flings.h"
#include "tests/unit/sim/result/described.h"

namespace hyrax {
namespace {

std::string described(const PathPoint& point) {
  return " (" + six_digits(point.x_px) + ", " + six_digits(point.y_px) + ")";
}
std::string described(const Box& box) {
  return described(PathPoint{box.left_px, box.top_px}) + " .." +
         described(PathPoint{box.right_px, box.bottom_px});
}

std::string described(const RunScene& scene) {
  constexpr const char* kKinds[] = {"flown", "moved", "unrecorded"};
  std::string text = "view" + described(scene.view);
  for (const Size& window : scene.windows)
    text += "\nwindow " + std::to_string(window.width_px) + " x " + std::to_string(window.height_px);
  for (const auto& sprite : {scene.start, scene.end})
    text += "\nsprite" + (sprite ? described(*sprite) : " -");
  if (scene.not_finite) text += "\nnot finite" + described(*scene.not_finite);
  text += "\nspeeds " + six_digits(scene.path.speed_px_per_s_low) + " .. " +
          six_digits(scene.path.speed_px_per_s_max);
  for (const Stroke& stroke : scene.path.strokes)
    text += std::string("\n") + kKinds[static_cast<std::size_t>(stroke.kind)] + " " +
            std::to_string(stroke.points.size()) + described(stroke.points.front()) + " .." +
            described(stroke.points.back());
  text += "\nbeads every " + std::to_string(scene.path.frames_per_bead) + ":";
  for (const PathPoint& bead : scene.path.beads) text += described(bead);
  for (const Throw& one : scene.throws)
    text += "\nthrow" + described(PathPoint{one.x_px, one.y_px}) + " by" +
            described(PathPoint{one.velocity.vx_px_per_s, one.velocity.vy_px_per_s});
  for (const TimedInput& input : scene.inputs)
    text += "\ninput " + std::string(input.what) + " at " + six_digits(input.t_s) + " s" +
            described(PathPoint{input.x_px, input.y_px});
  for (const Wall wall : kWalls) text += "\ncontacts " + std::to_string(scene.contacts[wall]);
  for (const Bounce& bounce : scene.bounces)
    text += "\n" + std::string(kWallNames[wall_index(bounce.wall)]) + described(bounce.sprite);
  for (const Box& ghost : scene.ghosts) text += "\nghost" + described(ghost);
  return text + "\n\n";
}

TEST(RunScene, OfRunsAreThoseApproved) {
  std::vector<Event> many;
  for (std::int64_t frame = 10; frame < 300; frame += 20)
    many.push_back({frame, Fling{{0.0, -9.0 * static_cast<double>(frame)}}});
  many.insert(many.begin() + 3, {std::int64_t{55}, Resize{Size{900, 500}, {}}});
  Scenario steep = fling_at(144.0, 400, many);
  steep.window = {200, 3000};
  steep.record_every = 7;
  // Of the throws one is stopped, one placed elsewhere, one flies on from such a place, and one is released.
  Scenario fast = fling_at(24.0, 90,
                           {{10, Fling{{1.0, 2.0}}},
                            {10, Stop{}},
                            {20, Grab{}},
                            {21, Fling{{3.0, 4.0}}},
                            {22, Release{{5.0, 6.0}}},
                            {30, Fling{{7.0, 8.0}}},
                            {30, Place{{100.0, 200.0}}},
                            {40, Place{{300.0, 100.0}}},
                            {50, Fling{{9.0, 10.0}}}});
  fast.start_velocity = {60'000.0, -700.0};
  fast.sprite = {90, 128};
  Scenario wide = fling_at(60.0, 60);  // Not finite at the end; more windows than are drawn.
  wide.window = {9000, 200};
  for (std::int64_t frame = 1; frame < 30; ++frame)
    wide.events.push_back({frame, Resize{Size{static_cast<std::int32_t>(9000 - frame), 200}, {}}});
  Scenario endless = fling_at(60.0, 1'200, {});  // More beads than are drawn.
  for (std::int64_t frame = 60; frame < 1'200; frame += 60)
    endless.events.push_back({frame, Fling{{2000.0, -900.0}}});
  std::string text;
  for (const Scenario& scenario : {eventful_fling(), steep, fast, wide, endless}) {
    RunRecorder recorder(step_count(scenario));
    static_cast<void>(replay(shipped_core(), scenario, recorder));
    StoredRun run = recorder.take();
    if (scenario.window == wide.window) run.rows.vx_px_per_s.back() = run.rows.x_px.back() = kNotGiven;
    text += described(make_run_scene(scenario, run.rows, run.contacts, 640.0));
  }
  expect_approved("tests/unit/tools/report/run_scene.txt", text);
}

}  // namespace
}  // namespace hyrax
