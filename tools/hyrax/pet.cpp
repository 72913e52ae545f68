#include "tools/hyrax/pet.h"
#include "tools/hyrax/resource_ids.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hyrax {
namespace {

constexpr double kTurns_px_per_s = 20.0;  // It does not turn around at lower speeds.
constexpr int kStandsFrames = 3;          // A bounce touches the ground for one frame.
constexpr std::int64_t kSlowestFramesPerSecond = 10;
constexpr double kStands_px = 1.0;  // A settled hyrax on a display that drops frames hops by less.

Position start_on(const Desk& desk) { return {(desk.work_area.width_px - desk.sprite.width_px) / 2.0, 0.0}; }

Keyframe start_of(const Desk& desk) {
  Keyframe start;
  start.row.x_px = start_on(desk).x_px;
  start.row.y_px = start_on(desk).y_px;
  start.window = desk.work_area;
  start.sprite = desk.sprite;
  return start;
}

}  // namespace

Pet::Pet(const Core& core, const Desk& desk, std::int64_t ticks_per_s, std::int64_t ticks)
    : desk_(desk),
      monitors_{desk},
      ticks_per_s_(ticks_per_s),
      last_ticks_(ticks),
      session_(core, start_of(desk)) {
  assert(ticks_per_s > 0);
}

void Pet::grab(ScreenPoint hand, std::int64_t ticks) {
  assert(!is_held());
  wake(ticks);
  apply(Grab{});
  hold_.emplace(ticks_per_s_, hand, ticks, position(), desk_.origin);
}

void Pet::drag(ScreenPoint hand, std::int64_t ticks) {
  assert(is_held());
  if (hold_->move(hand, ticks)) wake(ticks);
}

void Pet::let_go(ScreenPoint hand, std::int64_t ticks, const Desk& desk) {
  drag(hand, ticks);
  follow_hand();
  move_to(desk, ticks);
  cross_borders(0.0);  // It may be let go on a border.
  release(hold_->velocity(ticks), ticks);
}

void Pet::drop(std::int64_t ticks) {
  assert(is_held());
  follow_hand();
  release({}, ticks);
}

void Pet::cancel(std::int64_t ticks) {
  assert(is_held());
  apply(Place{hold_->start(desk_.origin)});
  release({}, ticks);
}

void Pet::fling(const Velocity& velocity, std::int64_t ticks) {
  wake(ticks);
  apply(Fling{velocity});
}

void Pet::reset(std::int64_t ticks) {
  if (is_held()) drop(ticks);
  wake(ticks);
  apply(Place{start_on(desk_)});
  apply(Stop{});
}

void Pet::resume(std::int64_t ticks) {
  is_paused_ = false;
  skip_time(ticks);
}

void Pet::move_to(const Desk& desk, std::int64_t ticks) {
  const std::vector<Action> inputs = inputs_of_move(desk_, desk, position());
  if (inputs.empty()) return;
  const bool was_paused = is_paused_;
  wake(ticks);
  for (const Action& input : inputs) apply(input);
  desk_ = desk;
  is_paused_ = was_paused;
  if (is_paused_ && !is_held()) stay_inside();  // No frame does it.
}

void Pet::use_monitors(std::vector<Desk> monitors, const Desk& nearest, std::int64_t ticks) {
  monitors_ = std::move(monitors);
  if (!is_one_of(monitors_, desk_)) move_to(nearest, ticks);
}

void Pet::frame(std::int64_t ticks) {
  if (is_asleep()) return;
  follow_hand();
  // A clock may go backwards.
  const std::int64_t elapsed_ticks =
      std::clamp<std::int64_t>(ticks - last_ticks_, 0, ticks_per_s_ / kSlowestFramesPerSecond);
  last_ticks_ = ticks;
  const double dt_s = static_cast<double>(elapsed_ticks) / static_cast<double>(ticks_per_s_);
  if (!is_held()) cross_borders(dt_s);
  session_.advance(dt_s);
  inputs_of_frame_ = std::exchange(inputs_, {});
  const Row& row = session_.now().row;
  const int ground_px = desk_.work_area.height_px - desk_.sprite.height_px;
  const bool is_down = row.y_px > ground_px - kStands_px;
  ground_frames_ = is_down ? std::min(ground_frames_ + 1, kStandsFrames) : 0;
  const double vx_px_per_s = row.vx_px_per_s;
  if (vx_px_per_s < -kTurns_px_per_s) faces_left_ = true;
  if (vx_px_per_s > kTurns_px_per_s) faces_left_ = false;
}

Pose Pet::pose() const {
  if (is_held()) return Pose::held;
  if (ground_frames_ < kStandsFrames) return Pose::fly;
  return session_.is_still() ? Pose::sleep : Pose::stand;
}

Position Pet::position() const { return {session_.now().row.x_px, session_.now().row.y_px}; }

// The time it was asleep belongs to no frame.
void Pet::wake(std::int64_t ticks) {
  if (is_asleep()) last_ticks_ = ticks;
  session_.wake();
  is_paused_ = false;
}

void Pet::apply(const Action& action) {
  session_.apply(action);
  inputs_.push_back(action);
}

void Pet::follow_hand() {
  if (!hold_) return;
  if (const auto corner = hold_->follow(desk_.origin)) apply(Place{*corner});
}

// Outside, the first step would take it back to the edge, and its speed with it.
void Pet::stay_inside() {
  const Position corner = inside(position(), desk_.work_area, desk_.sprite);
  if (corner != position()) apply(Place{corner});
}

void Pet::cross_borders(double dt_s) {
  const Row& row = session_.now().row;
  const Position next{row.x_px + dt_s * row.vx_px_per_s, row.y_px + dt_s * row.vy_px_per_s};
  const Desk desk = desk_of_way(monitors_, desk_, position(), next);
  if (desk == desk_) return;
  move_to(desk, last_ticks_);
  if (!is_held()) stay_inside();  // It may be larger there.
}

// The first frame of flight begins here, not at the last frame.
void Pet::release(const Velocity& velocity, std::int64_t ticks) {
  wake(ticks);
  stay_inside();
  apply(Release{velocity});
  hold_.reset();
  last_ticks_ = std::max(last_ticks_, ticks);
}

std::int64_t next_due_ticks(const DueTimes& times) {
  const std::int64_t due_ticks = times.last_due_ticks + times.period_ticks;
  const std::int64_t wait_ticks = due_ticks - times.now_ticks;
  const bool is_late_or_early =
      wait_ticks < times.period_ticks - times.period_ticks / 4 || wait_ticks > times.period_ticks;
  return is_late_or_early ? times.now_ticks + times.period_ticks : due_ticks;
}

int picture_of(Pose pose, int width_px) {
  constexpr std::array kPictures = {HYRAX_FLY, HYRAX_HELD, HYRAX_STAND, HYRAX_SLEEP};
  const int of_pose = kPictures[static_cast<std::size_t>(pose)];
  for (const int percentage : {100, 125, 150, 175})
    if (kUsualSprite_px * percentage / 100 >= width_px) return of_pose + percentage;
  return of_pose + 200;
}

void Session::apply(const Action& action) {
  player_.apply(action);
  wake();
  ring_.add_input(action);
  if (recording_) recording_->add_input(action);
}

void Session::advance(double dt_s) {
  const Row before = now().row;
  player_.advance(dt_s);
  const bool is_in_place = same_bits(now().row.x_px, before.x_px) && same_bits(now().row.y_px, before.y_px);
  if (!is_in_place) still_frames_ = 0;
  if (is_in_place && dt_s > 0.0 && !is_still()) ++still_frames_;
  ring_.add_frame(now());
  if (recording_) recording_->add_frame(now());
}

}  // namespace hyrax
