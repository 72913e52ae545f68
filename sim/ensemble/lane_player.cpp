#include "sim/ensemble/lane_player.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace hyrax {
namespace {

constexpr std::int64_t kBlock = 48;  // Steps between two looks at the lanes.
constexpr std::int64_t kLongRun =
    32768;  // From so many frames on blocks are longer, and any short period shows.
constexpr std::int64_t kLongBlock = 4096;
static_assert(kLongBlock <= kBlockStepsMax);

// Members that wait for a lane, and the lanes that play. Work has
//   frames(index): frames to play, > 0
//   load(index, lane), play(steps): as the kernel
//   visits(): lanes to look at although they have not ended
//   after(index, lane, steps, left): takes the block's results; returns the frames left, 0 if it is done.
template <class Work>
void play_all(Work& work, std::size_t count, std::int64_t block) {
  std::array<std::size_t, kLanes> index{};
  std::array<std::int64_t, kLanes> end{};
  std::uint32_t live = 0;
  std::int64_t elapsed = 0;
  std::size_t next = 0;
  const auto fill = [&](std::size_t lane) {
    live &= ~(std::uint32_t{1} << lane);
    end[lane] = std::numeric_limits<std::int64_t>::max();
    if (next == count) {
      if constexpr (requires { work.leave_empty(lane); }) work.leave_empty(lane);
      return;
    }
    live |= std::uint32_t{1} << lane;
    index[lane] = next;
    end[lane] = elapsed + work.frames(next);
    work.load(next++, lane);
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) fill(lane);
  std::int64_t first_end = *std::min_element(end.begin(), end.end());
  while (live != 0) {  // NOLINT(bugprone-infinite-loop): `fill` changes it.
    const std::int64_t steps = std::min(first_end - elapsed, block);
    work.play(steps);
    elapsed += steps;
    std::uint32_t visited = work.visits() & live;
    if (elapsed == first_end)
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        if (end[lane] == elapsed) visited |= std::uint32_t{1} << lane;
    if (visited == 0) continue;
    for (; visited != 0; visited &= visited - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(visited));
      const std::int64_t left = work.after(index[lane], lane, steps, end[lane] - elapsed);
      if (left == 0)
        fill(lane);
      else
        end[lane] = elapsed + left;
    }
    first_end = *std::min_element(end.begin(), end.end());
  }
}

bool is_in(std::uint32_t lanes, std::size_t lane) { return (lanes >> lane & 1u) != 0; }

WallCounts unpacked(std::uint64_t walls) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << kWallBits) - 1;
  const auto count = [&](Wall wall) {
    return static_cast<std::int64_t>(walls >> (kWallBits * wall_index(wall)) & kMask);
  };
  return {count(Wall::left), count(Wall::right), count(Wall::top), count(Wall::ground)};
}

void add(WallCounts& to, const WallCounts& counts, std::int64_t times) {
  for (const Wall wall : kWalls) to[wall] += times * counts[wall];
}

double time_after_s(Timeline timeline, double dt_s, std::int64_t frames) {
  timeline.play(dt_s, frames);
  return timeline.time_s();
}

// Whether a sprite that slides on the ground stays away from the walls in x. Drag and friction leave this
// part of vx in each step, so the way is that of a geometric series, and rounding at most doubles each
// step's; a vx that rounding keeps from becoming 0 goes on for all frames.
bool stays_inside(const Constants& core, double x_px, double vx_px_per_s, double dt_s, double right_px) {
  // Such a vx is below 5e-324 / (1 - left_part), at most 5e-308 px/s; 1e12 frames of 1e9 s, and some room.
  constexpr double kStuckWay_px = 1e-285;
  const double left_part = core.air_drag * core.ground_friction;
  if (!(core.air_drag >= 0.0 && core.ground_friction >= 0.0 && left_part < 1.0)) return false;
  const double reach_px =
      2.0 * core.air_drag / (1.0 - left_part) * std::fabs(vx_px_per_s) * dt_s + kStuckWay_px;
  return vx_px_per_s < 0.0 ? x_px - reach_px >= 0.0 && x_px <= right_px
                           : x_px >= 0.0 && x_px + reach_px <= right_px;
}

}  // namespace

// Legs in the kernel that computes every step.
class LanePlayer::Flying {
 public:
  Flying(LanePlayer& player, std::span<const Leg> legs, LaneClock clock)
      : player_(player), lanes_(player.lanes_), legs_(legs), clock_(clock) {}

  [[nodiscard]] std::int64_t frames(std::size_t index) const { return legs_[index].frames; }
  [[nodiscard]] std::int64_t computed() const { return computed_; }

  void load(std::size_t index, std::size_t lane) {
    const Leg& leg = legs_[index];
    const Bounds bounds = leg.member->world.bounds();
    for_each_number(*leg.member, [lane](auto number, auto& of_lanes) { of_lanes[lane] = number; });
    lanes_.right_px[lane] = bounds.right_px;
    lanes_.bottom_px[lane] = bounds.bottom_px;
    lanes_.dt_s[lane] = leg.dt_s;
    repeated_ &= ~(std::uint32_t{1} << lane);
    if (clock_ != LaneClock::fixed) load_clock(*leg.member, lane);
    computed_ += leg.frames;
  }

  // The kernel computes an empty lane as well: from here on it reads no more frames of a trace than the lanes
  // that are left do.
  void leave_empty(std::size_t lane) { lanes_.frame[lane] = 0; }

  void play(std::int64_t steps) { player_.kernels_.play(lanes_, steps, player_.detail_, clock_); }

  [[nodiscard]] std::uint32_t visits() const {
    if (player_.detail_ != Detail::final) return ~std::uint32_t{0};
    return clock_ == LaneClock::fixed ? lanes_.is_at_rest | lanes_.repeats : 0;
  }

  std::int64_t after(std::size_t index, std::size_t lane, std::int64_t steps, std::int64_t left) {
    const Leg& leg = legs_[index];
    if (player_.detail_ != Detail::final) take_track(leg, lane, steps, left);
    if (clock_ == LaneClock::fixed && left > 0) left = leave_out(leg, lane, steps, left);
    if (left == 0) store(leg, lane);
    return left;
  }

 private:
  // Calls move(number, its array over the lanes) for what a lane takes from its member and gives back.
  void for_each_number(MovingMember& member, const auto& move) const {
    State& state = member.world.state;
    move(state.x_px, lanes_.x_px);
    move(state.y_px, lanes_.y_px);
    move(state.vx_px_per_s, lanes_.vx_px_per_s);
    move(state.vy_px_per_s, lanes_.vy_px_per_s);
    if (player_.detail_ == Detail::final) return;
    move(member.walls, lanes_.walls);
    move(member.rest.x_px, lanes_.anchor_x_px);
    move(member.rest.y_px, lanes_.anchor_y_px);
    if (clock_ != LaneClock::fixed) {
      move(member.rest.t_s, lanes_.anchor_t_s);
      move(member.timeline.base_s, lanes_.time_base_s);
      move(member.timeline.comp_s, lanes_.time_comp_s);
      move(member.timeline.dt_s, lanes_.time_dt_s);
    }
    if (player_.detail_ == Detail::tracked) return;
    MemberResult& result = *member.result;
    move(result.x_min_px, lanes_.x_min_px);
    move(result.x_max_px, lanes_.x_max_px);
    move(result.y_min_px, lanes_.y_min_px);
    move(result.y_max_px, lanes_.y_max_px);
    move(result.speed_max_px_per_s, lanes_.speed_squared_max);
  }

  void load_clock(const MovingMember& member, std::size_t lane) {
    const std::uint64_t draws = member.jitter.kind == Jitter::Kind::normal ? 12 : 1;
    const auto frame = static_cast<std::uint64_t>(member.frame);
    lanes_.amount[lane] = member.jitter.amount;
    lanes_.draw[lane] = member.jitter.seed + frame * draws * 0x9E3779B97F4A7C15u;
    lanes_.frame[lane] = frame;
    lanes_.time_frames[lane] = static_cast<double>(member.timeline.frames);
  }

  // Of a block: the contacts that began, and when the anchor of rest moved.
  void take_track(const Leg& leg, std::size_t lane, std::int64_t steps, std::int64_t left) const {
    MovingMember& member = *leg.member;
    if (lanes_.begun[lane] != 0) add(member.result->contacts, unpacked(lanes_.begun[lane]), 1);
    if (clock_ != LaneClock::fixed || lanes_.moved[lane] == 0.0) return;
    const std::int64_t frames_before = leg.frames - left - steps;
    member.rest.t_s = time_after_s(member.timeline, leg.dt_s,
                                   frames_before + static_cast<std::int64_t>(lanes_.moved[lane]));
  }

  // How many of the `left` frames are still to be computed here. Left out are all of a sprite that lies on
  // the ground, whose x a simpler kernel moves afterwards (slides_), and whole blocks of one that repeats
  // itself.
  std::int64_t leave_out(const Leg& leg, std::size_t lane, std::int64_t steps, std::int64_t left) {
    if (is_in(lanes_.is_at_rest, lane) &&
        stays_inside(lanes_.constants, lanes_.x_px[lane], lanes_.vx_px_per_s[lane], leg.dt_s,
                     lanes_.right_px[lane])) {
      if (left % 2 != 0) lanes_.vy_px_per_s[lane] = lanes_.vy_before_px_per_s[lane];
      lanes_.walls[lane] = wall_bit(wall_index(Wall::ground));
      player_.slides_.push_back({leg.member, leg.dt_s, left});
      computed_ -= left;
      return 0;
    }
    const bool is_tracked = player_.detail_ != Detail::final;
    const std::uint32_t bit = std::uint32_t{1} << lane;
    const bool did_repeat =
        (std::exchange(repeated_, (lanes_.repeats & bit) | (repeated_ & ~bit)) & bit) != 0;
    if (!is_in(lanes_.repeats, lane)) return left;
    // Contacts of a block are those of the next ones only if its first row follows the same row as theirs.
    if (is_tracked && (!did_repeat || lanes_.moved[lane] != 0.0)) return left;
    const std::int64_t blocks = left / steps;
    if (is_tracked) add(leg.member->result->contacts, unpacked(lanes_.begun[lane]), blocks);
    computed_ -= blocks * steps;
    return left - blocks * steps;
  }

  void store(const Leg& leg, std::size_t lane) const {
    MovingMember& member = *leg.member;
    for_each_number(member, [lane](auto& number, const auto& of_lanes) { number = of_lanes[lane]; });
    member.frame += leg.frames;
    if (player_.detail_ == Detail::final) return;
    if (clock_ == LaneClock::fixed)
      member.timeline.play(leg.dt_s, leg.frames);
    else
      member.timeline.frames = static_cast<std::int64_t>(lanes_.time_frames[lane]);
  }

  LanePlayer& player_;
  Lanes& lanes_;
  std::span<const Leg> legs_;
  LaneClock clock_;
  std::int64_t computed_ = 0;
  std::uint32_t repeated_ = 0;  // Lanes whose state repeated in the block before.
};

// Members that slide on the ground: their y, vy, contacts and speed no longer matter. Their state is stored
// already; x and vx go on from there.
class LanePlayer::Sliding {
 public:
  explicit Sliding(LanePlayer& player) : player_(player), lanes_(player.lanes_) {}

  [[nodiscard]] std::int64_t frames(std::size_t index) const { return player_.slides_[index].frames; }
  void load(std::size_t index, std::size_t lane) {
    const Leg& slide = player_.slides_[index];
    lanes_.x_px[lane] = slide.member->world.state.x_px;
    lanes_.vx_px_per_s[lane] = slide.member->world.state.vx_px_per_s;
    lanes_.dt_s[lane] = slide.dt_s;
    lanes_.anchor_x_px[lane] = slide.member->rest.x_px;
  }
  void play(std::int64_t steps) { player_.kernels_.slide(lanes_, steps, is_tracked()); }
  [[nodiscard]] std::uint32_t visits() const { return is_tracked() ? ~std::uint32_t{0} : lanes_.is_at_rest; }

  std::int64_t after(std::size_t index, std::size_t lane, std::int64_t steps, std::int64_t left) {
    const Leg& slide = player_.slides_[index];
    if (is_tracked() && lanes_.moved[lane] != 0.0) {
      const std::int64_t frames_after = left + steps - static_cast<std::int64_t>(lanes_.moved[lane]);
      slide.member->rest.t_s = slide.member->timeline.time_s(-frames_after);  // It is at the end of the leg.
      slide.member->rest.y_px = slide.member->world.state.y_px;               // The ground of all its rows.
    }
    const bool stands = is_in(lanes_.is_at_rest, lane);
    if (left > 0 && !stands) return left;
    store(*slide.member, lane);
    if (left > 0) player_.slowing_.push_back({slide.member, slide.dt_s, left});
    return 0;
  }

 private:
  [[nodiscard]] bool is_tracked() const { return player_.detail_ != Detail::final; }

  void store(MovingMember& member, std::size_t lane) const {
    member.world.state.x_px = lanes_.x_px[lane];
    member.world.state.vx_px_per_s = lanes_.vx_px_per_s[lane];
    if (!is_tracked()) return;
    member.rest.x_px = lanes_.anchor_x_px[lane];
    member.result->include(member.world.state);
  }

  LanePlayer& player_;
  Lanes& lanes_;
};

// Members whose position no longer changes: only vx does, until it is as small as it gets.
class LanePlayer::Slowing {
 public:
  explicit Slowing(LanePlayer& player) : player_(player), lanes_(player.lanes_) {}

  [[nodiscard]] std::int64_t frames(std::size_t index) const { return player_.slowing_[index].frames; }
  void load(std::size_t index, std::size_t lane) {
    lanes_.vx_px_per_s[lane] = player_.slowing_[index].member->world.state.vx_px_per_s;
  }
  void play(std::int64_t steps) { player_.kernels_.slow_down(lanes_, steps); }
  [[nodiscard]] std::uint32_t visits() const { return lanes_.repeats; }
  std::int64_t after(std::size_t index, std::size_t lane, std::int64_t, std::int64_t left) {
    if (left > 0 && !is_in(lanes_.repeats, lane)) return left;
    player_.slowing_[index].member->world.state.vx_px_per_s = lanes_.vx_px_per_s[lane];
    return 0;
  }

 private:
  LanePlayer& player_;
  Lanes& lanes_;
};

StepTally LanePlayer::play(std::span<const Leg> legs, LaneClock clock, const double* trace) {
  slides_.clear();
  slowing_.clear();
  lanes_ = {};
  lanes_.trace = trace;
  lanes_.constants = constants_;
  StepTally tally;
  std::int64_t longest = 0;
  for (const Leg& leg : legs) {
    tally.steps += leg.frames;
    longest = std::max(longest, leg.frames);
  }
  Flying flying(*this, legs, clock);
  const bool has_short_blocks = clock == LaneClock::fixed && longest < kLongRun;
  play_all(flying, legs.size(), has_short_blocks ? kBlock : kLongBlock);
  tally.computed = flying.computed();
  Sliding sliding(*this);
  play_all(sliding, slides_.size(), kBlock);
  Slowing slowing(*this);
  play_all(slowing, slowing_.size(), kBlock);
  return tally;
}

}  // namespace hyrax
