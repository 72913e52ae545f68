"""Candidate cores: the shipped header with some of its text replaced.

Each is a list of (text, replacement); a text that the header does not have is an error, so that no candidate is the
shipped core by mistake. COMPARED are cores whose results can be compared, REFUSED are not.
"""

DRAG = "    m_vx *= AIR_DRAG;\n    m_vy *= AIR_DRAG;\n"
MOVE = "    m_x += m_vx * dt;\n    m_y += m_vy * dt;\n"
FLY = "    m_vy += GRAVITY * dt;\n" + DRAG + "\n" + MOVE
UPDATE = "  void update(double dt,"
MEMBERS = "  double m_x, m_y;\n  double m_vx, m_vy;\n"
REST = "      if (std::fabs(m_vy) < REST_THRESHOLD) m_vy = 0.0;\n"

# The impact in x solved inside the frame, at the constant speed of the frame: what is left of it is flown back.
SOLVED = [
    ("      m_x = 0.0;\n      m_vx = -m_vx * RESTITUTION;\n",
     "      m_x = -m_x * RESTITUTION;\n      m_vx = -m_vx * RESTITUTION;\n"),
    ("      m_x = rightBound;\n      m_vx = -m_vx * RESTITUTION;\n",
     "      m_x = rightBound - (m_x - rightBound) * RESTITUTION;\n      m_vx = -m_vx * RESTITUTION;\n"),
]

# A wall counts only if the path of the frame crosses it: a sprite that already is outside flies on.
SWEPT = [
    ("    m_x += m_vx * dt;\n", "    const double fromX = m_x, fromY = m_y;\n    m_x += m_vx * dt;\n"),
    ("if (m_x < 0.0)", "if (m_x < 0.0 && fromX >= 0.0)"),
    ("if (m_x > rightBound)", "if (m_x > rightBound && fromX <= rightBound)"),
    ("if (m_y < 0.0)", "if (m_y < 0.0 && fromY >= 0.0)"),
    ("if (m_y > bottomBound)", "if (m_y > bottomBound && fromY <= bottomBound)"),
]

COMPARED = {
    "same": [],
    "renamed_members": [("m_v", "speed_")],
    "gravity_by_one_ulp": [("GRAVITY = 1200.0;", "GRAVITY = 1200.0000000000002;")],
    "gravity_stronger": [("GRAVITY = 1200.0;", "GRAVITY = 1250.0;")],
    "bounce_softer": [("RESTITUTION = 0.6;", "RESTITUTION = 0.55;")],
    "friction_wrong": [("GROUND_FRICTION = 0.8;", "GROUND_FRICTION = 0.7;")],
    "friction_none": [("      m_vx *= GROUND_FRICTION;\n", "")],
    "rest_threshold_8": [("REST_THRESHOLD = 5.0;", "REST_THRESHOLD = 8.0;")],
    "no_rest_rule": [(REST, "")],
    "drag_by_time": [(DRAG, "    const double drag = std::pow(AIR_DRAG, 60.0 * dt);\n    m_vx *= drag;\n    m_vy *= drag;\n")],
    "rearranged": [(DRAG, "    m_vx -= m_vx * (1.0 - AIR_DRAG);\n    m_vy -= m_vy * (1.0 - AIR_DRAG);\n")],
    "fused": [(MOVE, "    m_x = std::fma(m_vx, dt, m_x);\n    m_y = std::fma(m_vy, dt, m_y);\n")],
    "impact_solved": SOLVED,
    "swept_walls": SWEPT,
    "position_first": [(FLY, MOVE + "    m_vy += GRAVITY * dt;\n" + DRAG)],
    "lighter_in_a_small_window": [(DRAG, DRAG + "    if (screenWidth > 0 && screenWidth < 20) m_vy *= 0.5;\n")],
    "not_a_number": [("    m_vx *= AIR_DRAG;\n", "    m_vx *= AIR_DRAG;\n    if (m_vy > 1500.0) m_vx = std::sqrt(-1.0);\n")],
    "helper_of_the_same_name": [
        ("/// A body in", "namespace detail {\ninline double drag() { return 0.998; }\n}  // namespace detail\n/// A body in"),
        (DRAG, "    m_vx *= detail::drag();\n    m_vy *= detail::drag();\n")],
}

# The base of helper_of_the_same_name: the same inline function with another body.
HELPER_BASE = [
    ("/// A body in", "namespace detail {\ninline double drag() { return 0.999; }\n}  // namespace detail\n/// A body in"),
    (DRAG, "    m_vx *= detail::drag();\n    m_vy *= detail::drag();\n")]

# What is wrong, and a part of the reason that must be given.
REFUSED = {
    "counter_in_the_class": ([(UPDATE, "  int m_calls = 0;\n" + UPDATE),
                              (DRAG, DRAG + "    if (++m_calls % 1009 == 0) m_vx *= 0.5;\n")],
                             "keeps state between calls beyond x, y, vx and vy"),
    "unused_member": ([(MEMBERS, MEMBERS + "  double m_spare = 0.0;\n")], "an object has 40 bytes, four doubles have 32"),
    "long_double": ([(MEMBERS, "  long double m_x, m_y;\n  long double m_vx, m_vy;\n"),
                     ("double x() const { return m_x; }", "double x() const { return static_cast<double>(m_x); }"),
                     ("std::fabs(m_vy)", "std::fabs(static_cast<double>(m_vy))")],
                    "keeps state between calls beyond x, y, vx and vy"),
    "static_counter": ([(DRAG, DRAG + "    static int calls = 0;\n    if (++calls % 1009 == 0) m_vx *= 0.5;\n")],
                       "does not repeat"),
    "slow_static_counter": ([(DRAG, DRAG + "    static long calls = 0;\n    if (++calls == 2'000'000) m_vx *= 0.5;\n")],
                            "does not repeat"),
    "shared_between_bodies": ([(DRAG, DRAG + "    static const physics* last = this;\n"
                                      "    if (last != this) m_vx += 1e-9;\n    last = this;\n")],
                              "does not repeat|shares state between bodies"),
    "last_speed_of_any_body": ([(DRAG, DRAG + "    static double lastStep = dt;\n    m_x += (dt - lastStep) * 1e-9;\n"
                                       "    lastStep = dt;\n")],
                               "does not repeat|shares state between bodies"),
    "getter_rounds": ([("  double m_x, m_y;", "  mutable double m_x, m_y;"),
                       ("double x() const { return m_x; }", "double x() const { return m_x = m_x + 1e-9; }")],
                      "is changed by its getters"),
    "setters_in_order": ([("    m_vx = vx;\n", "    m_vx = m_x > 0.0 ? vx : 0.0;\n")], "depends on the order of its setters"),
    "drawn_at_start": ([("#include <cmath>\n", "#include <cmath>\n#include <random>\n"),
                        ("/// A body in", "static const double kDrawn = 1e-9 * std::random_device{}();\n/// A body in"),
                        (DRAG, DRAG + "    m_vx += kDrawn * dt;\n")],
                       "scenarios played again by another process differ"),
    "crashes_in_a_small_window": ([(DRAG, DRAG + "    if (screenWidth < 100) __builtin_trap();\n")],
                                  r"crashes in scenario [\w/-]+\.json, step \d+: SIGILL"),
    "hangs_in_a_small_window": ([(DRAG, DRAG + "    while (screenWidth < 100) screenHeight = *const_cast<volatile int*>"
                                        "(&screenHeight);\n")],
                                r"takes more than 20 s; ended in scenario [\w/-]+\.json, step \d+"),
    "crashes": ([(DRAG, DRAG + "    if (m_vy > 900.0) __builtin_trap();\n")], r"crashes in scenario [\w/-]+\.json, step \d+: SIGILL"),
    "divides_by_zero": ([(DRAG, DRAG + "    int none = m_vy > 900.0 ? 0 : 1;\n    asm volatile(\"\" : \"+r\"(none));\n"
                          "    m_vx += 0.0 * (7 / none);\n")], r"step \d+: SIGFPE"),
    "aborts": ([("#include <cmath>\n", "#include <cmath>\n#include <cstdlib>\n"),
                (DRAG, DRAG + "    if (m_vy > 900.0) std::abort();\n")], r"step \d+: SIGABRT"),
    "writes_elsewhere": ([(DRAG, DRAG + "    if (m_vy > 900.0) *static_cast<volatile int*>(nullptr) = 1;\n")],
                         r"step \d+: SIGSEGV"),
    "throws": ([(DRAG, DRAG + "    if (m_vy > 900.0) throw 1;\n")],
               r"throws an exception in scenario [\w/-]+\.json, step \d+$"),
    "exits": ([("#include <cmath>\n", "#include <cmath>\n#include <cstdlib>\n"),
               (DRAG, DRAG + "    if (m_x > 900.0) std::exit(0);\n")],
              r"ends the process in scenario [\w/-]+\.json, step \d+$"),
    "exits_late": ([("#include <cmath>\n", "#include <cmath>\n#include <unistd.h>\n"),
                    (DRAG, DRAG + "    static long calls = 0;\n    if (++calls == 3'000'000) _exit(0);\n")],
                   r"ends the process in .*, step \d+$"),
    "exits_when_loaded": ([("#include <cmath>\n", "#include <cmath>\n#include <cstdlib>\n"),
                           ("/// A body in", "static const int kNone = (std::exit(0), 0);\n/// A body in")],
                          "ends the process in its initialisation$"),
    "flushes_to_zero": ([("#include <cmath>\n", "#include <cmath>\n#include <immintrin.h>\n"),
                         (DRAG, DRAG + "    if (m_vy > 900.0) _mm_setcsr(_mm_getcsr() | 0x8040u);\n")],
                        r"changes how the processor computes .*: found after scenario [\w/-]+\.json, step \d+$"),
    "rounds_upward": ([("#include <cmath>\n", "#include <cfenv>\n#include <cmath>\n"),
                       (DRAG, DRAG + "    if (m_vy > 900.0) std::fesetround(FE_UPWARD);\n")],
                      "changes how the processor computes"),
}


def header(shipped, edits):
    """The text of the shipped header with the edits made."""
    for text, replacement in edits:
        assert text in shipped, text
        shipped = shipped.replace(text, replacement)
    return shipped
