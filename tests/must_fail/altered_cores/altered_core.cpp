#include "tests/must_fail/altered_cores/altered_core.h"

#include <cstdio>
#include <cstdlib>

namespace hyrax {
namespace {

constexpr AlteredCore kCores[] = {
    {"none", "nothing", "the listing", {}},

    // Each constant, by much and by little.
    {"gravity_by_one_ulp", "gravity", "1200.0000000000002 for 1200", {.gravity = 1200.0000000000002}},
    {"gravity_stronger", "gravity", "1250 for 1200", {.gravity = 1250.0}},
    {"gravity_none", "gravity", "0 for 1200", {.gravity = 0.0}},
    {"gravity_upward", "gravity", "-1200 for 1200", {.gravity = -1200.0}},
    {"restitution_softer", "restitution", "0.55 for 0.6", {.restitution = 0.55}},
    {"bounce_gains", "restitution", "1.1 for 0.6", {.restitution = 1.1}},
    {"bounce_explodes", "restitution", "1e30 for 0.6", {.restitution = 1e30}},
    {"drag_stronger", "drag", "0.998 for 0.999", {.air_drag = 0.998}},
    {"drag_gains", "drag", "1.001 for 0.999", {.air_drag = 1.001}},
    {"friction_stronger", "friction", "0.7 for 0.8", {.ground_friction = 0.7}},
    {"friction_none", "friction", "1 for 0.8", {.ground_friction = 1.0}},
    {"rest_earlier", "rest rule", "7 px/s for 5", {.rest_threshold = 7.0}},
    {"rest_later", "rest rule", "4 px/s for 5", {.rest_threshold = 4.0}},

    // Each comparison, not strict and turned.
    {"left_not_strict", "left wall", "x <= 0 for x < 0", {.left_claims = Claim::on_bound_too}},
    {"right_not_strict", "right wall", "x >= right for x > right", {.right_claims = Claim::on_bound_too}},
    {"top_not_strict", "ceiling", "y <= 0 for y < 0", {.top_claims = Claim::on_bound_too}},
    {"ground_not_strict", "ground", "y >= bottom for y > bottom", {.ground_claims = Claim::on_bound_too}},
    {"left_turned", "left wall", "x > 0 for x < 0", {.left_claims = Claim::before_bound}},
    {"ground_turned", "ground", "y < bottom for y > bottom", {.ground_claims = Claim::before_bound}},
    {"rest_not_strict", "rest rule", "|vy| <= threshold for |vy| < threshold", {.ground = "ctfe"}},
    {"rest_signed", "rest rule", "vy < threshold for |vy| < threshold", {.ground = "ctfS"}},
    {"rest_turned", "rest rule", "|vy| > threshold for |vy| < threshold", {.ground = "ctfl"}},

    // Each statement left out.
    {"no_gravity", "gravity", "left out", {.fly = "XYxy"}},
    {"no_drag_in_x", "drag", "left out in x", {.fly = "gYxy"}},
    {"no_drag_in_y", "drag", "left out in y", {.fly = "gXxy"}},
    {"no_motion_in_x", "position", "left out in x", {.fly = "gXYy"}},
    {"no_motion_in_y", "position", "left out in y", {.fly = "gXYx"}},
    {"no_left_wall", "left wall", "left out", {.collide = "Ry"}},
    {"no_right_wall", "right wall", "left out", {.collide = "Ly"}},
    {"no_ceiling", "ceiling", "left out", {.collide = "xB"}},
    {"no_ground", "ground", "left out", {.collide = "xT"}},
    {"left_does_not_clamp", "left wall", "turns the speed, leaves the position", {.left = "t"}},
    {"ceiling_does_not_clamp", "ceiling", "turns the speed, leaves the position", {.top = "t"}},
    {"no_floor", "ground", "turns the speed, leaves the position", {.ground = "tfr"}},
    {"left_does_not_turn", "left wall", "leaves the speed", {.left = "c"}},
    {"right_does_not_turn", "right wall", "leaves the speed", {.right = "c"}},
    {"ceiling_does_not_turn", "ceiling", "leaves the speed", {.top = "c"}},
    {"ground_does_not_turn", "ground", "leaves vy, except by the rest rule", {.ground = "cfr"}},
    {"friction_left_out", "friction", "left out", {.ground = "ctr"}},
    {"rest_rule_gone", "rest rule", "left out", {.ground = "ctf"}},

    // Each statement twice.
    {"gravity_twice", "gravity", "twice", {.fly = "ggXYxy"}},
    {"drag_twice", "drag", "twice", {.fly = "gXXYYxy"}},
    {"drag_in_x_twice", "drag", "twice in x", {.fly = "gXXYxy"}},
    {"drag_in_y_twice", "drag", "twice in y", {.fly = "gXYYxy"}},
    {"motion_in_x_twice", "position", "twice in x", {.fly = "gXYxxy"}},
    {"motion_in_y_twice", "position", "twice in y", {.fly = "gXYxyy"}},
    {"left_turns_twice", "left wall", "speed turned twice", {.left = "ctt"}},
    {"ceiling_turns_twice", "ceiling", "speed turned twice", {.top = "ctt"}},
    {"ground_turns_twice", "ground", "speed turned twice", {.ground = "cttfr"}},
    {"friction_twice", "friction", "twice", {.ground = "ctffr"}},
    {"walls_twice", "order", "collide runs twice", {.update = "FCC"}},

    // Another order.
    {"drag_before_gravity", "order", "drag, gravity, position", {.fly = "XYgxy"}},
    {"position_before_velocity", "order", "position, gravity, drag: explicit Euler", {.fly = "xygXY"}},
    {"x_by_old_vx", "order", "x before drag, by the old vx", {.fly = "xgXYy"}},
    {"y_by_old_vy", "order", "y before gravity and drag, by the old vy", {.fly = "ygXYx"}},
    {"position_before_drag", "order", "gravity, position, drag", {.fly = "gxyXY"}},
    {"y_before_x", "order", "walls in y before those in x", {.collide = "yx"}},
    {"y_moves_before_x", "order", "y += vy dt before x += vx dt", {.fly = "gXYyx"}},
    {"walls_before_flight", "order", "collide before fly", {.update = "CF"}},
    {"friction_before_restitution", "order", "friction, then restitution", {.ground = "cftr"}},
    {"rest_before_restitution", "order", "rest rule, then restitution", {.ground = "crtf"}},
    {"turn_before_clamp",
     "order",
     "speed before position at every wall",
     {.left = "tc", .right = "tc", .top = "tc", .ground = "tcfr"}},
    {"ground_before_top", "order", "y > bottom is tested before y < 0", {.collide = "xY"}},
    {"walls_each_asked", "order", "if for else if: both walls of an axis may act", {.collide = "LRTB"}},

    // Signs.
    {"gravity_subtracted", "gravity", "vy -= G dt", {.fly = "uXYxy"}},
    {"x_subtracted", "position", "x -= vx dt", {.fly = "gXY<y"}},
    {"y_subtracted", "position", "y -= vy dt", {.fly = "gXYx^"}},
    {"left_keeps_direction", "left wall", "vx * restitution for -vx * restitution", {.left = "ck"}},
    {"ceiling_keeps_direction", "ceiling", "vy * restitution for -vy * restitution", {.top = "ck"}},
    {"ground_keeps_direction", "ground", "vy * restitution for -vy * restitution", {.ground = "ckfr"}},

    // x for y.
    {"gravity_on_vx", "gravity", "acts on vx", {.fly = "GXYxy"}},
    {"drag_on_vx_alone", "drag", "acts on vx twice, on vy never", {.fly = "gXXxy"}},
    {"x_moved_by_vy", "position", "x += vy dt", {.fly = "gXYay"}},
    {"y_moved_by_vx", "position", "y += vx dt", {.fly = "gXYxb"}},
    {"friction_on_vy", "friction", "acts on vy", {.ground = "ctFr"}},
    {"rest_rule_on_vx", "rest rule", "sets vx to 0", {.ground = "ctfq"}},
    {"bounds_exchanged",
     "bounds",
     "the right one from the heights, the bottom one from the widths",
     {.turns_bounds = true}},

    // A wall that is unlike the listing's.
    {"right_wall_softer", "right wall", "restitution 0.5", {.right = "ch"}},
    {"side_walls_softer", "side walls", "restitution 0.5", {.left = "ch", .right = "ch"}},
    {"ceiling_softer", "ceiling", "restitution 0.5", {.top = "ch"}},
    {"ceiling_stops", "ceiling", "sets vy to 0", {.top = "cs"}},
    {"ceiling_elastic", "ceiling", "restitution 1", {.top = "ci"}},
    {"ground_stops", "ground", "sets vy to 0", {.ground = "csf"}},
    {"friction_on_side_walls", "friction", "acts along the side walls, too", {.left = "ctf", .right = "ctf"}},
    {"friction_on_ceiling", "friction", "acts along the ceiling, too", {.top = "ctf"}},
    {"friction_on_all_walls",
     "friction",
     "acts along every wall",
     {.left = "ctf", .right = "ctf", .top = "ctf"}},
    {"rest_rule_on_ceiling", "rest rule", "holds at the ceiling, too", {.top = "ctr"}},
    {"mirrored_at_walls",
     "all walls",
     "p = 2 bound - p for p = bound",
     {.left = "mt", .right = "mt", .top = "mt", .ground = "mtfr"}},
    {"turns_if_outwards",
     "all walls",
     "speed turned only where it leads outwards",
     {.left = "co", .right = "co", .top = "co", .ground = "cofr"}},
    {"bounds_without_sprite", "bounds", "screen for screen - sprite", {.sprite_sides = 0}},
    {"bounds_of_two_sprites", "bounds", "screen - 2 sprite for screen - sprite", {.sprite_sides = 2}},

    // Other laws.
    {"drag_needs_time", "drag", "none in a zero-length frame", {.fly = "gdxy"}},
    {"drag_by_time", "drag", "drag^(60 dt)", {.fly = "gDxy"}},
    {"losses_by_time", "drag", "drag^(60 dt), friction^(60 dt)", {.fly = "gDxy", .ground = "ctpr"}},
    {"drag_explicit", "drag", "v (1 - 60 dt), unstable in frames above 1/30 s", {.fly = "gExy"}},
    {"position_by_mean_velocity", "position", "by the mean of old and new velocity", {.fly = "gXYv"}},
    {"no_losses",
     "constants",
     "no drag, no friction, restitution 1, no rest rule",
     {.restitution = 1.0, .air_drag = 1.0, .ground_friction = 1.0, .rest_threshold = 0.0}},
    {"speed_limited", "drag", "vx limited to 1500 px/s as well", {.fly = "gXYlxy"}},
    {"y_sees_x", "position", "y += vy dt + 1e-9 vx", {.fly = "gXYxs"}},
    {"update_alone", "update", "x to the next double after both halves", {.update = "FCn"}},
    {"hidden_state", "update", "halves vx in every 1009th step", {.update = "FCh"}},

    // Setters.
    {"reset_keeps_vy", "resetVelocity", "sets vx alone to 0", {.reset_velocity = "x"}},
    {"reset_does_nothing", "resetVelocity", "does nothing", {.reset_velocity = ""}},
    {"fling_adds", "setVelocity", "adds for sets", {.set_velocity = "+"}},
    {"place_keeps_y", "setPos", "sets x alone", {.set_pos = "x"}},
    {"fling_swapped", "setVelocity", "sets vx to vy and vy to vx", {.set_velocity = "w"}},

    // Frame times and inputs.
    {"frames_by_one_ulp", "clock", "dt to the next double", {.frame_factor = 1.0000000000000002}},
    {"frames_longer", "clock", "dt 1 % longer", {.frame_factor = 1.01}},
    {"jitter_longer", "clock", "jittered dt 1 % longer", {.jitter_factor = 1.01}},
    {"jitter_of_first_frame", "clock", "jittered dt of frame 0 1 % longer", {.first_jitter_factor = 1.01}},
    {"jitter_shifted", "clock", "the jitter of the next frame", {.jitter_shift = 1}},
    {"inputs_late", "inputs", "one frame late", {.inputs_late = 1}},
    {"inputs_later", "inputs", "five frames late", {.inputs_late = 5}},
    {"last_input_late", "inputs", "the last one a frame late", {.last_input_late = 1}},

    {"first_frame_longer", "clock", "dt of frame 0 1 % longer", {.first_frame_factor = 1.01}},

    // Outside the core and what it is fed.
    {"comparer_blind", "comparer", "blind in velocity", {.is_comparer_blind = true}},
    {"columns_swapped", "writer", "writes vx as vy and vy as vx", {.swaps_columns = true}},

    // Two at once.
    {"comparer_and_gravity",
     "comparer and gravity",
     "blind in velocity, gravity 1250",
     {.gravity = 1250.0, .is_comparer_blind = true}},
    {"comparer_and_rest_rule",
     "comparer and rest rule",
     "blind in velocity, no rest rule",
     {.ground = "ctf", .is_comparer_blind = true}},
    {"clock_and_drag",
     "clock and drag",
     "dt 1 % longer, drag 0.998",
     {.air_drag = 0.998, .frame_factor = 1.01}},
    {"inputs_and_friction",
     "inputs and friction",
     "one frame late, no friction",
     {.ground = "ctr", .inputs_late = 1}},
    {"two_constants", "constants", "gravity 1250, friction 0.7", {.gravity = 1250.0, .ground_friction = 0.7}},
    {"order_and_constant",
     "order and constant",
     "drag before gravity, restitution 0.55",
     {.restitution = 0.55, .fly = "XYgxy"}},
    {"wall_and_rest", "ceiling and rest rule", "ceiling stops, no rest rule", {.top = "cs", .ground = "ctf"}},
    {"two_statements", "drag and friction", "both twice", {.fly = "gXXYYxy", .ground = "ctffr"}},
};

[[noreturn]] void end_with(int exit_code, std::FILE* stream) {
  std::fflush(stream);
  std::_Exit(exit_code);
}

const AlteredCore& chosen() {
  const char* const variable = std::getenv("HYRAX_ALTERED_CORE");
  const std::string_view name = variable == nullptr ? "none" : variable;
  for (const AlteredCore& core : kCores)
    if (core.name == name) return core;
  if (name != "list") {
    std::fprintf(stderr, "HYRAX_ALTERED_CORE: unknown altered core (found %s); `list` prints them\n",
                 variable);
    end_with(2, stderr);
  }
  for (const AlteredCore& core : kCores)
    std::printf("%s\t%s\t%s\n", core.name.data(), core.operation.data(), core.change.data());
  end_with(0, stdout);
}

}  // namespace

const AlteredCore& altered_core() {
  static const AlteredCore& core = chosen();
  return core;
}

}  // namespace hyrax
