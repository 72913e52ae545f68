#include "tests/must_fail/altered_cores/altered_core.h"

#include <cstdio>
#include <cstdlib>

namespace hyrax {
namespace {

constexpr AlteredCore kCores[] = {
    {"none", "nothing", {}},

    // Each constant, by much and by little.
    {"gravity_by_one_ulp", "gravity", {.gravity = 1200.0000000000002}},
    {"gravity_stronger", "gravity", {.gravity = 1250.0}},
    {"gravity_upward", "gravity", {.gravity = -1200.0}},
    {"restitution_softer", "restitution", {.restitution = 0.55}},
    {"bounce_gains", "restitution", {.restitution = 1.1}},
    {"bounce_explodes", "restitution", {.restitution = 1e30}},
    {"friction_stronger", "friction", {.ground_friction = 0.7}},
    {"friction_none", "friction", {.ground_friction = 1.0}},
    {"rest_earlier", "rest rule", {.rest_threshold = 7.0}},

    // Each comparison, not strict and turned.
    {"left_not_strict", "left wall", {.left_claims = Claim::on_bound_too}},
    {"ground_not_strict", "ground", {.ground_claims = Claim::on_bound_too}},
    {"ground_turned", "ground", {.ground_claims = Claim::before_bound}},
    {"rest_not_strict", "rest rule", {.ground = "ctfe"}},
    {"rest_signed", "rest rule", {.ground = "ctfS"}},

    // Each statement left out.
    {"no_gravity", "gravity", {.fly = "XYxy"}},
    {"no_drag_in_x", "drag", {.fly = "gYxy"}},
    {"no_motion_in_x", "position", {.fly = "gXYy"}},
    {"no_right_wall", "right wall", {.collide = "Ly"}},
    {"no_ceiling", "ceiling", {.collide = "xB"}},
    {"no_ground", "ground", {.collide = "xT"}},
    {"left_does_not_clamp", "left wall", {.left = "t"}},
    {"no_floor", "ground", {.ground = "tfr"}},
    {"right_does_not_turn", "right wall", {.right = "c"}},
    {"ceiling_does_not_turn", "ceiling", {.top = "c"}},
    {"ground_does_not_turn", "ground", {.ground = "cfr"}},
    {"friction_left_out", "friction", {.ground = "ctr"}},
    {"rest_rule_gone", "rest rule", {.ground = "ctf"}},

    // Each statement twice.
    {"drag_in_y_twice", "drag", {.fly = "gXYYxy"}},
    {"left_turns_twice", "left wall", {.left = "ctt"}},
    {"walls_twice", "order", {.update = "FCC"}},

    // Another order.
    {"drag_before_gravity", "order", {.fly = "XYgxy"}},
    {"position_before_velocity", "order", {.fly = "xygXY"}},
    {"x_by_old_vx", "order", {.fly = "xgXYy"}},
    {"position_before_drag", "order", {.fly = "gxyXY"}},
    {"y_before_x", "order", {.collide = "yx"}},
    {"y_moves_before_x", "order", {.fly = "gXYyx"}},
    {"walls_before_flight", "order", {.update = "CF"}},
    {"friction_before_restitution", "order", {.ground = "cftr"}},
    {"rest_before_restitution", "order", {.ground = "crtf"}},
    {"turn_before_clamp", "order", {.left = "tc", .right = "tc", .top = "tc", .ground = "tcfr"}},
    {"ground_before_top", "order", {.collide = "xY"}},
    {"walls_each_asked", "order", {.collide = "LRTB"}},

    // Signs.
    {"x_subtracted", "position", {.fly = "gXY<y"}},
    {"ground_keeps_direction", "ground", {.ground = "ckfr"}},

    // x for y.
    {"gravity_on_vx", "gravity", {.fly = "GXYxy"}},
    {"x_moved_by_vy", "position", {.fly = "gXYay"}},
    {"friction_on_vy", "friction", {.ground = "ctFr"}},
    {"rest_rule_on_vx", "rest rule", {.ground = "ctfq"}},
    {"bounds_exchanged", "bounds", {.turns_bounds = true}},

    // A wall that is unlike the listing's.
    {"right_wall_softer", "right wall", {.right = "ch"}},
    {"side_walls_softer", "side walls", {.left = "ch", .right = "ch"}},
    {"ceiling_stops", "ceiling", {.top = "cs"}},
    {"friction_on_all_walls", "friction", {.left = "ctf", .right = "ctf", .top = "ctf"}},
    {"mirrored_at_walls", "all walls", {.left = "mt", .right = "mt", .top = "mt", .ground = "mtfr"}},
    {"turns_if_outwards", "all walls", {.left = "co", .right = "co", .top = "co", .ground = "cofr"}},
    {"bounds_without_sprite", "bounds", {.sprite_sides = 0}},

    // Other laws.
    {"drag_needs_time", "drag", {.fly = "gdxy"}},
    {"drag_by_time", "drag", {.fly = "gDxy"}},
    {"drag_explicit", "drag", {.fly = "gExy"}},
    {"speed_limited", "drag", {.fly = "gXYlxy"}},
    {"y_sees_x", "position", {.fly = "gXYxs"}},
    {"update_alone", "update", {.update = "FCn"}},
    {"hidden_state", "update", {.update = "FCh"}},

    // Setters.
    {"reset_does_nothing", "resetVelocity", {.reset_velocity = ""}},
    {"fling_adds", "setVelocity", {.set_velocity = "+"}},
    {"place_keeps_y", "setPos", {.set_pos = "x"}},
    {"fling_swapped", "setVelocity", {.set_velocity = "w"}},

    // Frame times and inputs.
    {"frames_by_one_ulp", "clock", {.frame_factor = 1.0000000000000002}},
    {"frames_longer", "clock", {.frame_factor = 1.01}},
    {"jitter_longer", "clock", {.jitter_factor = 1.01}},
    {"jitter_of_first_frame", "clock", {.first_jitter_factor = 1.01}},
    {"jitter_shifted", "clock", {.jitter_shift = 1}},
    {"inputs_late", "inputs", {.inputs_late = 1}},
    {"inputs_later", "inputs", {.inputs_late = 5}},
    {"last_input_late", "inputs", {.last_input_late = 1}},

    {"first_frame_longer", "clock", {.first_frame_factor = 1.01}},

    // Outside the core and what it is fed.
    {"comparer_blind", "comparer", {.is_comparer_blind = true}},

    // Two at once.
    {"comparer_and_gravity", "comparer and gravity", {.gravity = 1250.0, .is_comparer_blind = true}},
    {"comparer_and_rest_rule", "comparer and rest rule", {.ground = "ctf", .is_comparer_blind = true}},
    {"clock_and_drag", "clock and drag", {.air_drag = 0.998, .frame_factor = 1.01}},
    {"inputs_and_friction", "inputs and friction", {.ground = "ctr", .inputs_late = 1}},
    {"two_constants", "constants", {.gravity = 1250.0, .ground_friction = 0.7}},
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
  for (const AlteredCore& core : kCores) std::printf("%s\t%s\n", core.name.data(), core.operation.data());
  end_with(0, stdout);
}

}  // namespace

const AlteredCore& altered_core() {
  static const AlteredCore& core = chosen();
  return core;
}

}  // namespace hyrax
