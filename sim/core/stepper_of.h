// A stepper made of any core that has the interface of class physics.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

#include "sim/core/stepper.h"
#include "sim/motion/step.h"
#include "sim/scenario/apply.h"

namespace hyrax {

/// Whether the listing's step changes the bits of neither vx nor x in any frame of the stretch, though vx is
/// not zero. On the ground vx shrinks until rounding gives back what drag and friction take, at 1e-323 px/s;
/// some processors take up to 75 times as long for arithmetic with such subnormal numbers. With a zero of the
/// same sign in its place x, y and vy get the same bits. It is so if drag keeps vx, with friction and
/// without; if the longest frame does not move x, and so, as rounding is monotonic, no shorter one does; and
/// if x is within its bounds, so that no wall acts.
[[nodiscard]] inline bool has_stuck_vx(const Stretch& stretch, const State& body,
                                       const Constants& constants) {
  const double vx = body.vx_px_per_s;
  if (vx == 0.0 || !(std::fabs(vx) < std::numeric_limits<double>::min()) || stretch.is_held) return false;
  const double dragged = vx * constants.air_drag;
  if (dragged != vx || dragged * constants.ground_friction != vx) return false;
  const double right_px = bounds_of(stretch.window, stretch.sprite).right_px;
  if (!(body.x_px >= 0.0 && body.x_px <= right_px)) return false;
  const auto [least, most] =
      std::minmax_element(stretch.dt_s, stretch.dt_s + (stretch.is_dt_fixed ? 1 : stretch.frames));
  return *least >= 0.0 && same_bits(body.x_px + vx * *most, body.x_px);
}

/// The listing's step with the cores' constants, from which their contacts follow; std::monostate if they
/// have none.
template <class Cores>
[[nodiscard]] auto listing_of(const Cores& cores, const Bounds& bounds) {
  if constexpr (requires { cores.constants(); })
    return ListingStep(cores.constants(), AllParts{}, bounds);
  else
    return std::monostate();
}

/// What is known of a core's step before it is played.
struct StepFacts {
  /// It is the listing's with the core's constants, bit for bit: a stuck vx is not computed
  /// (has_stuck_vx).
  bool is_listing = false;
  /// A core may have members that no row shows: it goes on from stretch to stretch with all of them.
  bool has_further_members = false;
};

/// Of a core only update, x, y, vx, vy, setPos, setVelocity and resetVelocity are called. Which walls clamped
/// a step, the velocity with which it met them and how far it overshot follow from the listing's step
/// (sim/motion/step.h) with the core's constants: the core's own step must be that one bit for bit, or its
/// contacts come from ContactStepper (sim/core/contact_stepper.h).
/// @tparam Cores makes cores: `Cores::Core`, `Core make(const State&)` and `Constants constants()`. A core
/// that knows its walls tells them: `contact` and `meeting` as TracedBody's (sim/trace/step_player.h).
/// Without these there are no contacts.
template <class Cores>
class StepperOf final : public Stepper {
 public:
  explicit StepperOf(Cores cores = {}, const StepFacts& facts = {})
      : cores_(std::move(cores)), facts_(facts) {}

  void play(const Stretch& stretch, CoreBody& body, RestAnchor& rest, RowBlock& rows,
            StretchLog& log) const override {
    assert(stretch.frames >= 0 && static_cast<std::size_t>(stretch.frames) <= rows.room());
    log.frames = 0;
    log.met_anchor = false;
    log.had_friction = false;
    log.rows = {};
    log.changes.clear();
    log.moved_offset = -1;
    const std::size_t rows_before = rows.size();
    std::byte* const row = rows.extend(static_cast<std::size_t>(stretch.frames));
    if (skips_vx(stretch, body.state)) {
      play_without_vx(stretch, body.state, rest, row, log);
      body.object.clear();  // The listing has no further members.
    } else {
      body = body_of(play_any(stretch, core_of(body), rest, row, log));
    }
    rows.shrink(rows_before + static_cast<std::size_t>(log.frames));
  }

  void apply(const Action& action, Keyframe& now) const override {
    Body body{core_of({state_of(now.row), now.core_object}), now.window, now.sprite, now.is_held};
    hyrax::apply(action, body);
    set_state(now.row, state_of(body));
    now.core_object = body_of(static_cast<const Core&>(body)).object;
  }

  [[nodiscard]] State steps(const State& body, double dt_s, const Bounds& bounds,
                            std::int64_t steps) const override {
    const auto [right_px, bottom_px] = whole(bounds);
    Core moving = cores_.make(body);
    for (std::int64_t step = 0; step < steps; ++step) moving.update(dt_s, right_px, bottom_px, 0, 0);
    return state_of(moving);
  }
  [[nodiscard]] State played(const State& body, std::span<const double> frames_s, const Bounds& bounds,
                             int parts) const override {
    const auto [right_px, bottom_px] = whole(bounds);
    Core moving = cores_.make(body);
    if (parts == 1) {
      for (const double frame_s : frames_s) moving.update(frame_s, right_px, bottom_px, 0, 0);
    } else {
      for (const double frame_s : frames_s)
        for (int part = 0; part < parts; ++part) moving.update(frame_s / parts, right_px, bottom_px, 0, 0);
    }
    return state_of(moving);
  }

 private:
  using Core = typename Cores::Core;
  using PaperStep = decltype(listing_of(std::declval<const Cores&>(), Bounds()));
  static constexpr bool kTellsContacts = !std::is_same_v<PaperStep, std::monostate>;
  static constexpr bool kKnowsContacts = requires(const Core core) { core.contact(); };

  // The core with the rest of the world, as hyrax::apply takes it.
  struct Body : Core {
    Size& window;
    Size& sprite;
    bool& is_held;
  };

  static State state_of(const Core& core) { return {core.x(), core.y(), core.vx(), core.vy()}; }
  static State state_of(const Row& row) { return hyrax::state_of(row); }
  static Size whole(const Bounds& bounds) {
    assert(bounds.right_px == std::trunc(bounds.right_px) &&
           bounds.bottom_px == std::trunc(bounds.bottom_px));
    return {static_cast<std::int32_t>(bounds.right_px), static_cast<std::int32_t>(bounds.bottom_px)};
  }

  // The object goes on from stretch to stretch, with all its members; a keyframe of a file has none.
  [[nodiscard]] Core core_of(const CoreBody& body) const {
    Core core = cores_.make(body.state);
    if (!facts_.has_further_members || body.object.size() != sizeof(Core)) return core;
    Core kept = core;
    std::memcpy(static_cast<void*>(&kept), body.object.data(), sizeof(Core));
    return same_bits(state_of(kept), body.state) ? kept : core;
  }
  [[nodiscard]] CoreBody body_of(Core core) const {
    CoreBody body{state_of(core)};
    if (!facts_.has_further_members) return body;
#ifdef __has_builtin
#if __has_builtin(__builtin_clear_padding)
    __builtin_clear_padding(&core);
#endif
#endif
    body.object.resize(sizeof(Core));
    std::memcpy(body.object.data(), &core, sizeof(Core));
    return body;
  }
  // The bits of all members.
  [[nodiscard]] bool is_at(const Core& core, const CoreBody& anchor) const {
    return same_bits(state_of(core), anchor.state) &&
           (!facts_.has_further_members || has_object(core, anchor));
  }
  // Apart from the loop of steps, and with a copy, so that the core there stays in registers.
  [[nodiscard, gnu::noinline]] bool has_object(Core core, const CoreBody& anchor) const {
    return body_of(core).object == body_of(core_of(anchor)).object;
  }

  // Frames of one dt repeat themselves instead (Replay::Player), which looks at all of the state.
  [[nodiscard]] bool skips_vx(const Stretch& stretch, const State& body) const {
    if constexpr (requires { cores_.constants(); })
      return facts_.is_listing && !stretch.is_dt_fixed && has_stuck_vx(stretch, body, cores_.constants());
    else
      return false;
  }

  // REQUIRES: skips_vx. Its vx is put back into what was logged.
  void play_without_vx(const Stretch& stretch, State& body, RestAnchor& rest, std::byte* row,
                       StretchLog& log) const {
    const double vx = body.vx_px_per_s;
    body.vx_px_per_s = std::copysign(0.0, vx);
    body = state_of(play_any(stretch, cores_.make(body), rest, row, log));
    body.vx_px_per_s = vx;
    const std::byte* const end = row + static_cast<std::size_t>(log.frames) * kPackedRowBytes;
    for (; row != end; row += kPackedRowBytes) set_packed_vx(row, vx);
    for (ContactChange& change : log.changes)
      if (change.begins) change.contact.vx_before_px_per_s = change.contact.vx_after_px_per_s = vx;
    log.had_friction = log.rows_with(bit(Wall::ground)) > 0;
  }

  // Contact byte of the step that ended in `after`. A clamp corrects the position, so it shows in the
  // difference to the flight without walls. Branches serve better than selects here: bounces come seldom,
  // and rest repeats itself.
  static std::uint8_t contact_of(const State& flight, const Core& after) {
    std::uint8_t contact = 0;
    if (flight.y_px > after.y())
      contact = static_cast<std::uint8_t>(bit(Wall::ground) | (after.vy() == 0.0 ? kRestBit : 0));
    else if (flight.y_px < after.y())
      contact = bit(Wall::top);
    if (flight.x_px < after.x()) return static_cast<std::uint8_t>(contact | bit(Wall::left));
    if (flight.x_px > after.x()) return static_cast<std::uint8_t>(contact | bit(Wall::right));
    return contact;
  }
  static constexpr std::uint8_t bit(Wall wall) { return static_cast<std::uint8_t>(wall); }

  // A step in which walls begin or cease to clamp; seldom, so it is kept out of the loop. It takes copies:
  // a state whose address is known elsewhere could not stay in registers.
  [[gnu::noinline]] static void log_change(PaperStep listing, std::uint8_t contact_before,
                                           std::uint8_t contact, State before, double dt_s, State after,
                                           std::int64_t offset, StretchLog& log) {
    log_contact_changes(contact_before, contact, after, offset, log,
                        [&](Wall wall) { return listing_meeting(listing, wall, before, dt_s, after); });
  }

  // The constants are asked for here, where the compiler may know them: then the flight of a clamped step
  // shares its operations with update. State and anchor stay in locals, which nothing else points to, so that
  // they can live in registers.
  template <bool kIsDtFixed, bool kSeeksAnchor>
  Core play_free(const Stretch& stretch, Core body, RestAnchor& rest_anchor, std::byte* row,
                 StretchLog& log) const {
    const Size window = stretch.window;
    const Size sprite = stretch.sprite;
    const Bounds bounds = bounds_of(window, sprite);
    const PaperStep listing = listing_of(cores_, bounds);
    const std::int64_t frames = stretch.frames;
    const double* const frame_dt_s = stretch.dt_s;
    const double fixed_dt_s = frame_dt_s[0];
    RestAnchor rest = rest_anchor;
    std::int64_t moved_offset = -1;
    std::uint8_t contact = stretch.contact_before;
    std::int64_t frame = 0;
    while (frame < frames) {
      const double dt_s = kIsDtFixed ? fixed_dt_s : frame_dt_s[frame];
      const Core before = body;
      const std::uint8_t contact_before = contact;
      body.update(dt_s, window.width_px, window.height_px, sprite.width_px, sprite.height_px);
      contact = 0;
      if constexpr (kTellsContacts) {
        // Only a clamp, or great chance, puts the sprite onto a bound. One branch, not four.
        const unsigned is_on_a_bound = unsigned{body.x() == 0.0} | unsigned{body.x() == bounds.right_px} |
                                       unsigned{body.y() == 0.0} | unsigned{body.y() == bounds.bottom_px};
        if (is_on_a_bound != 0) {
          State flight = state_of(before);
          listing.fly(flight, dt_s);
          contact = contact_of(flight, body);
          ++log.rows[contact];
          log.had_friction |= touches(contact, Wall::ground) && flight.vx_px_per_s != 0.0;
        }
      }
      if constexpr (kKnowsContacts) {
        contact = body.contact();
        if (contact != 0) ++log.rows[contact];
        log.had_friction |= touches(contact, Wall::ground) && before.vx() != 0.0;
        if (is_contact_change(contact_before, contact))
          log_contact_changes(contact_before, contact, state_of(body), frame, log,
                              [&](Wall wall) { return before.meeting(wall, dt_s, window, sprite); });
      }
      pack_row(row, dt_s, body.x(), body.y(), body.vx(), body.vy(), contact);
      row += kPackedRowBytes;
      if constexpr (kTellsContacts)
        if (is_contact_change(contact_before, contact))
          log_change(listing, contact_before, contact, state_of(before), dt_s, state_of(body), frame, log);
      if (rest.moves_to(body.x(), body.y())) moved_offset = frame;
      ++frame;
      if (kSeeksAnchor && is_at(body, *stretch.anchor)) {
        log.met_anchor = true;
        break;
      }
    }
    log.frames = frame;
    log.moved_offset = moved_offset;
    rest_anchor = rest;
    return body;
  }

  // Frames pass, no update, contact 0.
  void play_held(const Stretch& stretch, const Core& body, RestAnchor& rest, std::byte* row,
                 StretchLog& log) const {
    log_contact_changes(stretch.contact_before, 0, {}, 0, log, [](Wall) { return WallMeeting(); });
    if (rest.moves_to(body.x(), body.y())) log.moved_offset = 0;
    while (log.frames < stretch.frames && !log.met_anchor) {
      pack_row(row, stretch.dt_s[stretch.is_dt_fixed ? 0 : log.frames], body.x(), body.y(), body.vx(),
               body.vy(), 0);
      row += kPackedRowBytes;
      ++log.frames;
      log.met_anchor = stretch.anchor != nullptr && is_at(body, *stretch.anchor);
    }
  }

  Core play_any(const Stretch& stretch, const Core& body, RestAnchor& rest, std::byte* row,
                StretchLog& log) const {
    if (stretch.is_held) {
      play_held(stretch, body, rest, row, log);
      return body;
    }
    if (!stretch.is_dt_fixed) return play_free<false, false>(stretch, body, rest, row, log);
    if (stretch.anchor == nullptr) return play_free<true, false>(stretch, body, rest, row, log);
    return play_free<true, true>(stretch, body, rest, row, log);
  }

  static_assert(std::is_trivially_copyable_v<Core>, "a run goes on with a copy of the core's object");

  Cores cores_;
  StepFacts facts_;
};

}  // namespace hyrax
