"""Edits of sim/physics/physics.h, each with what `check` must answer.

An edit is a list of replacements in the header's text; `names` is what the core's changes must name.
"""

import dataclasses

GRAVITY, DRAG_X, DRAG_Y = "m_vy += GRAVITY * dt;", "m_vx *= AIR_DRAG;", "m_vy *= AIR_DRAG;"
DRAG = f"{DRAG_X}\n    {DRAG_Y}"
MOVE_X = "m_x += m_vx * dt;"
TURN_X, TURN_Y = "m_vx = -m_vx * RESTITUTION;", "m_vy = -m_vy * RESTITUTION;"
LEFT, RIGHT = f"m_x = 0.0;\n      {TURN_X}", f"m_x = rightBound;\n      {TURN_X}"
FRICTION = "m_vx *= GROUND_FRICTION;"
BOTTOM_BOUND = "const double bottomBound = static_cast<double>(screenHeight - objHeight);"
X_WALLS = f"""    if (m_x < 0.0) {{
      {LEFT}
    }} else if (m_x > rightBound) {{
      {RIGHT}
    }}
"""
HELPERS = "  double x() const"


@dataclasses.dataclass(frozen=True)
class Edit:
    """What is replaced, and the answer: status of the core, what its changes name."""

    name: str
    replacements: tuple
    status: str
    names: tuple = ()

    def apply(self, header):
        """The header's text with the edit."""
        for old, new in self.replacements:
            if old not in header:
                raise ValueError(f"{self.name}: the header has no {old}")
            header = header.replace(old, new)
        return header


def changed(name, old, new, *names):
    """An edit that changes bits."""
    return Edit(name, ((old, new),), "changed", names)


def constant(name, before, after):
    return changed(f"{name}_{after}", f"{name} = {before}", f"{name} = {after}", f"{name} {float(before):g} -> {after.removesuffix('.0')}")


SINGLE = (
    constant("GRAVITY", "1200.0", "1250.0"),
    constant("RESTITUTION", "0.6", "0.55"),
    constant("GROUND_FRICTION", "0.8", "0.7"),
    constant("REST_THRESHOLD", "5.0", "7.0"),
    changed("no_drag_in_x", DRAG_X, "", DRAG_X),
    changed("drag_before_gravity", f"{GRAVITY}\n    {DRAG}", f"{DRAG}\n    {GRAVITY}", GRAVITY),
    changed("left_not_strict", "m_x < 0.0", "m_x <= 0.0", "m_x <= 0.0"),
    changed("rest_signed", "std::fabs(m_vy)", "m_vy", "if (m_vy < REST_THRESHOLD)"),
    changed("drag_by_time", DRAG, "m_vx *= std::pow(AIR_DRAG, 60.0 * dt);\n    m_vy *= std::pow(AIR_DRAG, 60.0 * dt);",
            "std::pow(AIR_DRAG, 60.0 * dt)"),
    changed("half_moves", MOVE_X, "m_x += m_vx * (dt / 2.0);\n    m_x += m_vx * (dt / 2.0);", "dt / 2.0"),
    changed("in_floats", DRAG_X, "m_vx = static_cast<float>(m_vx * AIR_DRAG);", "static_cast<float>"),
    changed("set_velocity_swapped", "m_vx = vx;\n    m_vy = vy;", "m_vx = vy;\n    m_vy = vx;", "m_vx = vy;"),
    changed("constructor_without_vy", "m_vy(vy) {}", "m_vy(0.0) {}", "m_vy(0.0)"),
    changed("whole_pixels", MOVE_X, "m_x = std::floor(m_x + m_vx * dt);", "std::floor"),
    changed("walls_of_a_wide_sprite", "} else if (m_x > rightBound)", "}\n    if (m_x > rightBound)", "if (m_x > rightBound)"),
)


def when(name, condition, effect="m_vx *= 0.9;"):
    """A statement in every step where a condition holds."""
    return changed(name, BOTTOM_BOUND, f"{BOTTOM_BOUND}\n    if ({condition}) {effect}", condition)


def at_ground(name, condition, effect="m_vx *= 0.9;"):
    return changed(name, FRICTION, f"{FRICTION}\n      if ({condition}) {effect}", condition)


# Most are in the unit test of sim/trace, which searches as `check` does; so are most texts of one meaning.
CONDITIONAL = (
    when("sprite_higher_than_wide", "objHeight > objWidth"),
    when("dt_below_1_ms", "dt < 0.001 && dt > 0.0"),
    at_ground("ground_slipping_slowly", "std::fabs(m_vx) < 0.5", "m_vx = 0.0;"),
    changed("rest_only_above_-600", "if (std::fabs(m_vy) < REST_THRESHOLD)",
            "if (std::fabs(m_vy) < REST_THRESHOLD && m_vx > -600.0)", "m_vx > -600.0"),
)


def equal(name, *replacements):
    """An edit that keeps every bit."""
    return Edit(name, replacements, "proved_equal")


EQUAL = (
    equal("comment", (GRAVITY, f"{GRAVITY}  // Downwards.")),
    equal("members_renamed", ("m_v", "speed_"), ("m_", "place_")),
    equal("constant_renamed", ("AIR_DRAG", "DRAG")),
    equal("turn_before_clamp", (RIGHT, f"{TURN_X}\n      m_x = rightBound;")),
    equal("helper_function", (HELPERS, f"  static double turned(double v) {{ return -v * RESTITUTION; }}\n{HELPERS}"),
          (TURN_X, "m_vx = turned(m_vx);"), (TURN_Y, "m_vy = turned(m_vy);")),
    equal("arrays", ("m_x(x), m_y(y), m_vx(vx), m_vy(vy) {}", "m_p{x, y}, m_v{vx, vy} {}"),
          ("  double m_x, m_y;\n  double m_vx, m_vy;", "  double m_p[2], m_v[2];"),
          ("m_vx", "m_v[0]"), ("m_vy", "m_v[1]"), ("m_x", "m_p[0]"), ("m_y", "m_p[1]")),
    equal("clamped_by_max", ("#include <cmath>", "#include <algorithm>\n#include <cmath>"),
          (LEFT, f"m_x = std::max(m_x, 0.0);\n      {TURN_X}")),
    equal("never_read", (GRAVITY, f"const double unused = m_vy * 3.0;\n    static_cast<void>(unused);\n    {GRAVITY}")),
    equal("both_walls_by_flags", (X_WALLS, "    const bool isLeft = m_x < 0.0, isRight = m_x > rightBound;\n"
                                  f"    if (isLeft | isRight) {{\n      m_x = isLeft ? 0.0 : rightBound;\n      {TURN_X}\n    }}\n")),
    # The same bits, by other operations: no text proves it, and no step refutes it.
    Edit("bound_of_doubles", (("static_cast<double>(screenWidth - objWidth)",
                               "static_cast<double>(screenWidth) - static_cast<double>(objWidth)"),), "not_proved"),
    Edit("walls_by_clamp", (("#include <cmath>", "#include <algorithm>\n#include <cmath>"),
                            (X_WALLS, "    const double clamped = std::clamp(m_x, 0.0, rightBound);\n"
                                      f"    if (clamped != m_x) {{\n      m_x = clamped;\n      {TURN_X}\n    }}\n")), "not_proved"),
    Edit("guard_against_nan", ((GRAVITY, f"if (std::isnan(m_vx)) m_vx = 0.0;\n    {GRAVITY}"),), "not_proved"),
    # Not traced: a reason is given.
    Edit("static_variable", ((GRAVITY, f"static double calls = 0.0;\n    calls += 1.0;\n    m_vx += calls;\n"
                              f"    {GRAVITY}"),), "not_proved",
         ("memory outside the body",)),
)


def pair(first, second):
    edits = {edit.name: edit for edit in SINGLE + CONDITIONAL}
    one, other = edits[first], edits[second]
    return Edit(f"{first}+{second}", one.replacements + other.replacements, "changed", one.names + other.names)


PAIRS = (
    pair("GRAVITY_1250.0", "GROUND_FRICTION_0.7"),
    pair("GRAVITY_1250.0", "REST_THRESHOLD_7.0"),
    pair("RESTITUTION_0.55", "left_not_strict"),
)

ALL = SINGLE + CONDITIONAL + EQUAL + PAIRS
EVERYDAY = ("walls_by_clamp", "drag_by_time", "rest_only_above_-600", "helper_function", "bound_of_doubles", "GRAVITY_1250.0+REST_THRESHOLD_7.0")
