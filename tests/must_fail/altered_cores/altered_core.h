// Cores that are wrong on purpose, for checks that must notice them: the listing's step with its operations
// as data, and a table of what is changed in them.
#pragma once

#include <cstdint>
#include <string_view>

namespace hyrax {

/// When a wall claims the sprite.
enum class Claim { beyond_bound, on_bound_too, before_bound };

/// The step as lists of operations, a letter each, which run in order. The defaults are the listing.
struct AlteredStep {
  double gravity = 1200.0;
  double restitution = 0.6;
  double air_drag = 0.999;
  double ground_friction = 0.8;
  double rest_threshold = 5.0;

  /// F: fly. C: collide. n: x to the next double. h: hidden state, halves vx in every 1009th step.
  std::string_view update = "FC";
  /// g: vy += G dt. G: vx += G dt.
  /// X, Y: vx, vy *= drag. d: both, if dt > 0. D: both by time, drag^(60 dt).
  /// E: both times 1 - 60 dt, unstable in frames above 1/30 s.
  /// x, y: x += vx dt, y += vy dt. <: x -= vx dt. a: x += vy dt.
  /// l: vx within -1500 .. 1500. s: y += vy dt + 1e-9 vx.
  std::string_view fly = "gXYxy";
  /// x: left wall, else right. y: top, else ground. L, R, T, B: left, right, top, ground alone.
  /// Y: ground, else top.
  std::string_view collide = "xy";
  /// With p, v position and speed against the wall, w the speed along it, b the bound:
  /// c: p = b. m: p = 2 b - p. t: v = -v restitution. k: v *= restitution. s: v = 0. h: v = -0.5
  /// v. o: as t, if v leads outwards. f: w *= friction. F: v *= friction. r: v = 0 if |v| < threshold.
  /// e: <= for <. S: v for |v|. q: w = 0 if |v| < threshold.
  std::string_view left = "ct";
  std::string_view right = "ct";
  std::string_view top = "ct";
  std::string_view ground = "ctfr";
  Claim left_claims = Claim::beyond_bound;
  Claim ground_claims = Claim::beyond_bound;
  /// The bounds are screen - sprite_sides * sprite; turned: the right one from heights, the bottom from
  /// widths.
  int sprite_sides = 1;
  bool turns_bounds = false;

  /// x, y: sets that component. w: each to the other's. +: adds both instead. z: sets both to 0.
  std::string_view set_pos = "xy";
  std::string_view set_velocity = "xy";
  std::string_view reset_velocity = "z";

  /// What the step is fed: every base dt times this, every jittered dt times that, inputs so many frames
  /// late.
  double frame_factor = 1.0;
  double jitter_factor = 1.0;
  std::int64_t inputs_late = 0;
  double first_jitter_factor = 1.0;  ///< Of frame 0 alone.
  std::int64_t jitter_shift = 0;     ///< Every frame has the jitter of the one so many later.
  std::int64_t last_input_late = 0;
  double first_frame_factor = 1.0;  ///< Of frame 0 of a clock without jitter.

  /// Golden files are compared without vx and vy.
  bool is_comparer_blind = false;

  bool operator==(const AlteredStep&) const = default;
};

struct AlteredCore {
  std::string_view name;
  std::string_view operation;  ///< What of the step is changed.
  AlteredStep step;
};

/// The one that the environment variable HYRAX_ALTERED_CORE names, `none` where it is not set. `list` prints
/// all as name and operation, separated by a tab, and ends the program with 0; an unknown name ends
/// it with 2.
[[nodiscard]] const AlteredCore& altered_core();
[[nodiscard]] inline const AlteredStep& altered_step() { return altered_core().step; }

/// A body as the altered steps move it.
struct AlteredBody {
  double x, y, vx, vy;
};
void update(AlteredBody& body, double dt, int screen_width, int screen_height, int sprite_width,
            int sprite_height);
void set(double& x, double& y, std::string_view operations, double to_x, double to_y);

}  // namespace hyrax
