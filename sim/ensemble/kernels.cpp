// The kernels, compiled once for every instruction set. Each operation is the listing's (sim/motion/step.h),
// in its order: + - * and comparison, rounded one by one (-ffp-contract=off keeps them apart here as well).
//
// A clamp is a comparison and a selection, so that NaN, -0 and bounds below 0 take the ways that they take in
// the listing. `-v * RESTITUTION` is `v * -RESTITUTION`: rounding is symmetric.
#include <array>
#include <vector>

#include "sim/ensemble/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/ensemble/kernels.cpp"
// SSSE3 is left to the baseline; vectors of unknown length cannot be kept in arrays.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hyrax::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Reals = hn::ScalableTag<double>;
using Words = hn::ScalableTag<std::uint64_t>;
using Integers = hn::ScalableTag<std::int64_t>;
using Real = hn::Vec<Reals>;
using Word = hn::Vec<Words>;
using Mask = hn::Mask<Reals>;

constexpr std::size_t kWidth = hn::MaxLanes(Reals());
// Vectors that are in flight at once, to hide the latency of a step.
constexpr std::size_t kAtOnce = kLanes / kWidth < 4 ? kLanes / kWidth : 4;

HWY_INLINE Real real(double value) { return hn::Set(Reals(), value); }
HWY_INLINE Word word(std::uint64_t value) { return hn::Set(Words(), value); }
HWY_INLINE Real load(const Lanes::Reals& from, std::size_t lane) {
  return hn::LoadU(Reals(), from.data() + lane);
}
HWY_INLINE Word load(const Lanes::Bits& from, std::size_t lane) {
  return hn::LoadU(Words(), from.data() + lane);
}
HWY_INLINE void store(Real value, Lanes::Reals& to, std::size_t lane) {
  hn::StoreU(value, Reals(), to.data() + lane);
}
HWY_INLINE void store(Word value, Lanes::Bits& to, std::size_t lane) {
  hn::StoreU(value, Words(), to.data() + lane);
}
HWY_INLINE Word bits(Real value) { return hn::BitCast(Words(), value); }
HWY_INLINE Mask has_same_bits(Real a, Real b) { return hn::RebindMask(Reals(), hn::Eq(bits(a), bits(b))); }
HWY_INLINE Word word_if(Mask mask, std::uint64_t value) {
  return hn::IfThenElseZero(hn::RebindMask(Words(), mask), word(value));
}
HWY_INLINE std::uint32_t lane_bits(Mask mask, std::size_t lane) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Reals(), mask, bytes);
  return static_cast<std::uint32_t>(bytes[0]) << lane;
}

// The constants, in every lane.
struct Laws {
  explicit HWY_INLINE Laws(const Constants& constants)
      : gravity(real(constants.gravity_px_per_s2)),
        bounce(real(-constants.restitution)),
        drag(real(constants.air_drag)),
        friction(real(constants.ground_friction)),
        rest_threshold(real(constants.rest_threshold_px_per_s)) {}

  Real gravity, bounce, drag, friction, rest_threshold;
};

// The bodies of one vector of lanes.
struct Bodies {
  Real x, y, vx, vy, right, bottom;
};

// What a step met.
struct StepContact {
  Mask left, right, top, ground;
};

HWY_INLINE StepContact step(const Laws& laws, Bodies& b, Real dt, Real gravity_dt) {
  const Real zero = hn::Zero(Reals());
  b.vy = hn::Mul(hn::Add(b.vy, gravity_dt), laws.drag);
  b.vx = hn::Mul(b.vx, laws.drag);
  b.x = hn::Add(b.x, hn::Mul(b.vx, dt));
  b.y = hn::Add(b.y, hn::Mul(b.vy, dt));
  const StepContact c{hn::Lt(b.x, zero), hn::Gt(b.x, b.right), hn::Lt(b.y, zero), hn::Gt(b.y, b.bottom)};
  b.x = hn::IfThenElse(c.left, zero, hn::IfThenElse(c.right, b.right, b.x));
  b.vx = hn::IfThenElse(hn::Or(c.left, c.right), hn::Mul(b.vx, laws.bounce), b.vx);
  b.y = hn::IfThenElse(c.top, zero, hn::IfThenElse(c.ground, b.bottom, b.y));
  b.vy = hn::IfThenElse(hn::Or(c.top, c.ground), hn::Mul(b.vy, laws.bounce), b.vy);
  const Mask ground = hn::AndNot(c.top, c.ground);
  b.vx = hn::IfThenElse(ground, hn::Mul(b.vx, laws.friction), b.vx);
  const Mask rest = hn::And(ground, hn::Lt(hn::Abs(b.vy), laws.rest_threshold));
  b.vy = hn::IfThenElse(rest, zero, b.vy);
  return {c.left, hn::AndNot(c.left, c.right), c.top, ground};
}

// Contacts and the anchor of rest.
struct Track {
  Word walls, begun;
  Real anchor_x, anchor_y, moved;

  HWY_INLINE Mask take(const Bodies& b, const StepContact& c, Real step_number) {
    const Word now = hn::Or(hn::Or(word_if(c.left, wall_bit(0)), word_if(c.right, wall_bit(1))),
                            hn::Or(word_if(c.top, wall_bit(2)), word_if(c.ground, wall_bit(3))));
    begun = hn::Add(begun, hn::AndNot(walls, now));
    walls = now;
    const Real still = real(0.5);  // RestAnchor::kStill_px.
    const Mask moves = hn::Or(hn::Gt(hn::Abs(hn::Sub(b.x, anchor_x)), still),
                              hn::Gt(hn::Abs(hn::Sub(b.y, anchor_y)), still));
    anchor_x = hn::IfThenElse(moves, b.x, anchor_x);
    anchor_y = hn::IfThenElse(moves, b.y, anchor_y);
    moved = hn::IfThenElse(moves, step_number, moved);
    return moves;
  }
};

struct Extremes {
  Real x_min, x_max, y_min, y_max, speed_squared;

  HWY_INLINE void take(const Bodies& b) {
    x_min = hn::IfThenElse(hn::Lt(b.x, x_min), b.x, x_min);
    x_max = hn::IfThenElse(hn::Gt(b.x, x_max), b.x, x_max);
    y_min = hn::IfThenElse(hn::Lt(b.y, y_min), b.y, y_min);
    y_max = hn::IfThenElse(hn::Gt(b.y, y_max), b.y, y_max);
    const Real squared = hn::Add(hn::Mul(b.vx, b.vx), hn::Mul(b.vy, b.vy));
    speed_squared = hn::IfThenElse(hn::Gt(squared, speed_squared), squared, speed_squared);
  }
};

// The time of a run whose frames differ: as Timeline in sim/scenario/frame_clock.h.
struct Times {
  Real base, comp, dt, frames, anchor_t;

  HWY_INLINE void play(Real frame_dt) {
    const Mask goes_on = has_same_bits(frame_dt, dt);
    const Real length = hn::Mul(frames, dt);
    const Real sum = hn::Add(base, length);
    const Mask is_base_larger = hn::Ge(base, length);
    const Real larger = hn::IfThenElse(is_base_larger, base, length);
    const Real smaller = hn::IfThenElse(is_base_larger, length, base);
    const Real closed_comp = hn::Add(comp, hn::Add(hn::Sub(larger, sum), smaller));
    base = hn::IfThenElse(goes_on, base, sum);
    comp = hn::IfThenElse(goes_on, comp, closed_comp);
    frames = hn::Add(hn::IfThenElseZero(goes_on, frames), real(1.0));
    dt = frame_dt;
  }
  [[nodiscard]] HWY_INLINE Real now() const { return hn::Add(hn::Add(base, comp), hn::Mul(frames, dt)); }
};

// SplitMix64 (sim/scenario/split_mix64.h), a draw after the other.
struct Draws {
  Word state;

  HWY_INLINE Real unit() {
    state = hn::Add(state, word(0x9E3779B97F4A7C15u));
    Word z = state;
    z = hn::Mul(hn::Xor(z, hn::ShiftRight<30>(z)), word(0xBF58476D1CE4E5B9u));
    z = hn::Mul(hn::Xor(z, hn::ShiftRight<27>(z)), word(0x94D049BB133111EBu));
    z = hn::Xor(z, hn::ShiftRight<31>(z));
    const auto upper = hn::BitCast(Integers(), hn::ShiftRight<11>(z));
    return hn::Mul(hn::ConvertTo(Reals(), upper), real(0x1p-53));
  }
};

// The dt of a lane's next frame; operations as in sim/scenario/frame_clock.cpp.
struct LaneFrameClock {
  Real dt, amount;
  Draws draws;
  Word frame;
  const double* trace;

  HWY_INLINE Real next(LaneClock clock) {
    Real jittered = dt;
    switch (clock) {
      case LaneClock::fixed:
        break;
      case LaneClock::uniform: {
        const Real centred = hn::Sub(hn::Mul(real(2.0), draws.unit()), real(1.0));
        jittered = hn::Mul(dt, hn::Add(real(1.0), hn::Mul(amount, centred)));
        break;
      }
      case LaneClock::normal: {
        Real sum = hn::Zero(Reals());
        for (int draw = 0; draw < 12; ++draw) sum = hn::Add(sum, draws.unit());
        jittered = hn::Add(dt, hn::Mul(amount, hn::Sub(sum, real(6.0))));
        jittered = hn::IfThenElse(hn::Le(jittered, hn::Zero(Reals())), hn::Zero(Reals()), jittered);
        break;
      }
      case LaneClock::missed_frames:
        jittered = hn::IfThenElse(hn::Lt(draws.unit(), amount), hn::Mul(dt, real(2.0)), dt);
        break;
      case LaneClock::trace:
        jittered = hn::GatherIndex(Reals(), trace, hn::BitCast(Integers(), frame));
        frame = hn::Add(frame, word(1));
        return jittered;
    }
    const Real longest = real(1e9);  // kFrameMax_s.
    return hn::IfThenElse(hn::Gt(jittered, longest), longest, jittered);
  }
};

// All of one vector of lanes: what a detail does not need is never loaded.
template <Detail kDetail, bool kIsFixed>
struct Group {
  static constexpr bool kIsTracked = kDetail != Detail::final;
  static constexpr bool kHasExtremes = kDetail == Detail::extremes;

  Bodies b;
  Real dt, gravity_dt;
  LaneFrameClock frame_clock;
  Track track;
  Times times;
  Extremes extremes;

  HWY_INLINE void load_from(const Laws& laws, const Lanes& lanes, std::size_t lane) {
    b = {load(lanes.x_px, lane),        load(lanes.y_px, lane),     load(lanes.vx_px_per_s, lane),
         load(lanes.vy_px_per_s, lane), load(lanes.right_px, lane), load(lanes.bottom_px, lane)};
    dt = load(lanes.dt_s, lane);
    gravity_dt = hn::Mul(laws.gravity, dt);
    if constexpr (!kIsFixed)
      frame_clock = {
          dt, load(lanes.amount, lane), {load(lanes.draw, lane)}, load(lanes.frame, lane), lanes.trace};
    if constexpr (kIsTracked)
      track = {load(lanes.walls, lane), hn::Zero(Words()), load(lanes.anchor_x_px, lane),
               load(lanes.anchor_y_px, lane), hn::Zero(Reals())};
    if constexpr (kIsTracked && !kIsFixed)
      times = {load(lanes.time_base_s, lane), load(lanes.time_comp_s, lane), load(lanes.time_dt_s, lane),
               load(lanes.time_frames, lane), load(lanes.anchor_t_s, lane)};
    if constexpr (kHasExtremes)
      extremes = {load(lanes.x_min_px, lane), load(lanes.x_max_px, lane), load(lanes.y_min_px, lane),
                  load(lanes.y_max_px, lane), load(lanes.speed_squared_max, lane)};
  }

  HWY_INLINE void store_to(Lanes& lanes, std::size_t lane) const {
    store(b.x, lanes.x_px, lane);
    store(b.y, lanes.y_px, lane);
    store(b.vx, lanes.vx_px_per_s, lane);
    store(b.vy, lanes.vy_px_per_s, lane);
    if constexpr (!kIsFixed) {
      store(frame_clock.draws.state, lanes.draw, lane);
      store(frame_clock.frame, lanes.frame, lane);
    }
    if constexpr (kIsTracked) {
      store(track.walls, lanes.walls, lane);
      store(track.begun, lanes.begun, lane);
      store(track.anchor_x, lanes.anchor_x_px, lane);
      store(track.anchor_y, lanes.anchor_y_px, lane);
      store(track.moved, lanes.moved, lane);
    }
    if constexpr (kIsTracked && !kIsFixed) {
      store(times.base, lanes.time_base_s, lane);
      store(times.comp, lanes.time_comp_s, lane);
      store(times.dt, lanes.time_dt_s, lane);
      store(times.frames, lanes.time_frames, lane);
      store(times.anchor_t, lanes.anchor_t_s, lane);
    }
    if constexpr (kHasExtremes) {
      store(extremes.x_min, lanes.x_min_px, lane);
      store(extremes.x_max, lanes.x_max_px, lane);
      store(extremes.y_min, lanes.y_min_px, lane);
      store(extremes.y_max, lanes.y_max_px, lane);
      store(extremes.speed_squared, lanes.speed_squared_max, lane);
    }
  }

  HWY_INLINE Mask play(const Laws& laws, LaneClock clock, double step_number) {
    if constexpr (!kIsFixed) {
      dt = frame_clock.next(clock);
      gravity_dt = hn::Mul(laws.gravity, dt);
    }
    const StepContact contact = step(laws, b, dt, gravity_dt);
    if constexpr (kIsTracked) {
      if constexpr (!kIsFixed) times.play(dt);
      const Mask moves = track.take(b, contact, real(step_number));
      if constexpr (!kIsFixed) times.anchor_t = hn::IfThenElse(moves, times.now(), times.anchor_t);
    }
    if constexpr (kHasExtremes) extremes.take(b);
    return contact.ground;
  }
};

template <Detail kDetail, bool kIsFixed>
using Groups = std::array<Group<kDetail, kIsFixed>, kAtOnce>;

template <Detail kDetail, bool kIsFixed>
HWY_INLINE void play_steps(const Laws& laws, Groups<kDetail, kIsFixed>& groups, LaneClock clock,
                           std::int64_t steps) {
  for (std::int64_t at = 0; at < steps; ++at)
    for (std::size_t g = 0; g < kAtOnce; ++g) groups[g].play(laws, clock, static_cast<double>(at + 1));
}

// The last two steps of a block at fixed dt, and what they tell: see Lanes.
template <Detail kDetail>
HWY_INLINE void play_last_two(const Laws& laws, Groups<kDetail, true>& groups, Lanes& lanes,
                              std::size_t first_lane, std::int64_t at) {
  for (std::size_t g = 0; g < kAtOnce; ++g) {
    const std::size_t lane = first_lane + g * kWidth;
    Group<kDetail, true>& group = groups[g];
    const Bodies two_before = group.b;
    const Mask ground_before = group.play(laws, LaneClock::fixed, static_cast<double>(at + 1));
    store(group.b.vy, lanes.vy_before_px_per_s, lane);
    const Mask ground = group.play(laws, LaneClock::fixed, static_cast<double>(at + 2));
    const Mask is_as_before =
        hn::And(has_same_bits(group.b.y, two_before.y), has_same_bits(group.b.vy, two_before.vy));
    lanes.is_at_rest |= lane_bits(hn::And(hn::And(ground, ground_before), is_as_before), lane);
    const Mask repeats = hn::And(hn::And(has_same_bits(group.b.x, load(lanes.x_px, lane)),
                                         has_same_bits(group.b.y, load(lanes.y_px, lane))),
                                 hn::And(has_same_bits(group.b.vx, load(lanes.vx_px_per_s, lane)),
                                         has_same_bits(group.b.vy, load(lanes.vy_px_per_s, lane))));
    lanes.repeats |= lane_bits(repeats, lane);
  }
}

template <Detail kDetail, bool kIsFixed>
void play_as(const Laws& laws, Lanes& lanes, std::int64_t steps, LaneClock clock) {
  lanes.is_at_rest = 0;
  lanes.repeats = 0;
  const bool has_last_two = kIsFixed && steps >= 2;
  for (std::size_t lane = 0; lane < kLanes; lane += kAtOnce * kWidth) {
    Groups<kDetail, kIsFixed> groups;
    for (std::size_t g = 0; g < kAtOnce; ++g) groups[g].load_from(laws, lanes, lane + g * kWidth);
    play_steps<kDetail, kIsFixed>(laws, groups, clock, has_last_two ? steps - 2 : steps);
    if constexpr (kIsFixed)
      if (has_last_two) play_last_two<kDetail>(laws, groups, lanes, lane, steps - 2);
    for (std::size_t g = 0; g < kAtOnce; ++g) groups[g].store_to(lanes, lane + g * kWidth);
  }
}

template <Detail kDetail>
void play_detail(const Laws& laws, Lanes& lanes, std::int64_t steps, LaneClock clock) {
  if (clock == LaneClock::fixed)
    play_as<kDetail, true>(laws, lanes, steps, clock);
  else
    play_as<kDetail, false>(laws, lanes, steps, clock);
}

void play(Lanes& lanes, std::int64_t steps, Detail detail, LaneClock clock) {
  const Laws laws(lanes.constants);
  switch (detail) {
    case Detail::final:
      return play_detail<Detail::final>(laws, lanes, steps, clock);
    case Detail::tracked:
      return play_detail<Detail::tracked>(laws, lanes, steps, clock);
    case Detail::extremes:
      return play_detail<Detail::extremes>(laws, lanes, steps, clock);
  }
}

// On the ground in every step, away from the walls in x.
struct Slider {
  Real x, vx, dt, anchor_x, moved;

  template <bool kIsTracked>
  HWY_INLINE void play(const Laws& laws, double step_number) {
    vx = hn::Mul(vx, laws.drag);
    x = hn::Add(x, hn::Mul(vx, dt));
    vx = hn::Mul(vx, laws.friction);
    if constexpr (kIsTracked) {
      const Mask moves = hn::Gt(hn::Abs(hn::Sub(x, anchor_x)), real(0.5));  // RestAnchor::kStill_px.
      anchor_x = hn::IfThenElse(moves, x, anchor_x);
      moved = hn::IfThenElse(moves, real(step_number), moved);
    }
  }
};

template <bool kIsTracked>
void slide_as(Lanes& lanes, std::int64_t steps) {
  const Laws laws(lanes.constants);
  lanes.is_at_rest = 0;
  for (std::size_t first = 0; first < kLanes; first += kAtOnce * kWidth) {
    std::array<Slider, kAtOnce> sliders;
    for (std::size_t g = 0; g < kAtOnce; ++g) {
      const std::size_t lane = first + g * kWidth;
      sliders[g] = {load(lanes.x_px, lane), load(lanes.vx_px_per_s, lane), load(lanes.dt_s, lane),
                    load(lanes.anchor_x_px, lane), hn::Zero(Reals())};
    }
    for (std::int64_t at = 0; at + 1 < steps; ++at)
      for (std::size_t g = 0; g < kAtOnce; ++g)
        sliders[g].template play<kIsTracked>(laws, static_cast<double>(at + 1));
    for (std::size_t g = 0; g < kAtOnce; ++g) {
      const std::size_t lane = first + g * kWidth;
      const Real x_before = sliders[g].x;
      sliders[g].template play<kIsTracked>(laws, static_cast<double>(steps));
      lanes.is_at_rest |= lane_bits(has_same_bits(sliders[g].x, x_before), lane);
      store(sliders[g].x, lanes.x_px, lane);
      store(sliders[g].vx, lanes.vx_px_per_s, lane);
      store(sliders[g].anchor_x, lanes.anchor_x_px, lane);
      store(sliders[g].moved, lanes.moved, lane);
    }
  }
}

void slide(Lanes& lanes, std::int64_t steps, bool is_tracked) {
  is_tracked ? slide_as<true>(lanes, steps) : slide_as<false>(lanes, steps);
}

HWY_INLINE Real slowed(const Laws& laws, Real vx) { return hn::Mul(hn::Mul(vx, laws.drag), laws.friction); }

void slow_down(Lanes& lanes, std::int64_t steps) {
  const Laws laws(lanes.constants);
  lanes.repeats = 0;
  for (std::size_t first = 0; first < kLanes; first += kAtOnce * kWidth) {
    std::array<Real, kAtOnce> vx;
    for (std::size_t g = 0; g < kAtOnce; ++g) vx[g] = load(lanes.vx_px_per_s, first + g * kWidth);
    for (std::int64_t at = 0; at + 1 < steps; ++at)
      for (std::size_t g = 0; g < kAtOnce; ++g) vx[g] = slowed(laws, vx[g]);
    for (std::size_t g = 0; g < kAtOnce; ++g) {
      const Real last = slowed(laws, vx[g]);
      lanes.repeats |= lane_bits(has_same_bits(last, vx[g]), first + g * kWidth);
      store(last, lanes.vx_px_per_s, first + g * kWidth);
    }
  }
}

}  // namespace

extern const KernelSet kKernels;
const KernelSet kKernels{nullptr, play, slide, slow_down};

}  // namespace hyrax::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hyrax {
namespace {

void add(std::vector<KernelSet>& sets, bool is_supported, const char* name, KernelSet kernels) {
  if (!is_supported) return;
  kernels.name = name;
  sets.push_back(kernels);
}

std::vector<KernelSet> find_kernel_sets() {
  std::vector<KernelSet> sets;
#if HWY_TARGETS & HWY_AVX3
  add(sets,
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
          __builtin_cpu_supports("avx512cd"),
      "AVX-512", N_AVX3::kKernels);
#endif
#if HWY_TARGETS & HWY_AVX2
  add(sets,
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
          __builtin_cpu_supports("bmi2"),
      "AVX2", N_AVX2::kKernels);
#endif
#if HWY_TARGETS & HWY_SSE4
  add(sets, __builtin_cpu_supports("sse4.2"), "SSE4", N_SSE4::kKernels);
#endif
  add(sets, true, "baseline", HWY_STATIC_DISPATCH(kKernels));
  return sets;
}

}  // namespace

std::span<const KernelSet> kernel_sets() {
  static const std::vector<KernelSet> sets = find_kernel_sets();
  return sets;
}

}  // namespace hyrax
#endif  // HWY_ONCE
