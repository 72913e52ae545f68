"""Candidate cores: the shipped header with some of its text replaced.

Each is a list of (text, replacement); a text that the header does not have is an error, so that no candidate is the
shipped core by mistake. COMPARED are cores whose results can be compared, REFUSED are not.
"""

DRAG = "    m_vx *= AIR_DRAG;\n    m_vy *= AIR_DRAG;\n"
MOVE = "    m_x += m_vx * dt;\n    m_y += m_vy * dt;\n"
FLY = "    m_vy += GRAVITY * dt;\n" + DRAG + "\n" + MOVE
REST = "      if (std::fabs(m_vy) < REST_THRESHOLD) m_vy = 0.0;\n"

COMPARED = {
    "same": [],
    "gravity_by_one_ulp": [("GRAVITY = 1200.0;", "GRAVITY = 1200.0000000000002;")],
    "bounce_softer": [("RESTITUTION = 0.6;", "RESTITUTION = 0.55;")],
    "no_rest_rule": [(REST, "")],
    "drag_by_time": [(DRAG, "    const double drag = std::pow(AIR_DRAG, 60.0 * dt);\n    m_vx *= drag;\n    m_vy *= drag;\n")],
    "rearranged": [(DRAG, "    m_vx -= m_vx * (1.0 - AIR_DRAG);\n    m_vy -= m_vy * (1.0 - AIR_DRAG);\n")],
    "position_first": [(FLY, MOVE + "    m_vy += GRAVITY * dt;\n" + DRAG)],
    "lighter_in_a_small_window": [(DRAG, DRAG + "    if (screenWidth > 0 && screenWidth < 20) m_vy *= 0.5;\n")],
    "helper_of_the_same_name": [
        ("/// A body in", "namespace detail {\ninline double drag() { return 0.998; }\n}  // namespace detail\n/// A body in"),
        (DRAG, "    m_vx *= detail::drag();\n    m_vy *= detail::drag();\n")],
}

# The base of helper_of_the_same_name: the same inline function with another body.
HELPER_BASE = [
    ("/// A body in", "namespace detail {\ninline double drag() { return 0.999; }\n}  // namespace detail\n/// A body in"),
    (DRAG, "    m_vx *= detail::drag();\n    m_vy *= detail::drag();\n")]

# What is wrong, and a part of the reason that must be given. Others: core_defect_test, compared_core_test and core_process_test.
REFUSED = {
    "static_counter": ([(DRAG, DRAG + "    static int calls = 0;\n    if (++calls % 1009 == 0) m_vx *= 0.5;\n")],
                       "does not repeat"),
    "drawn_at_start": ([("#include <cmath>\n", "#include <cmath>\n#include <random>\n"),
                        ("/// A body in", "static const double kDrawn = 1e-9 * std::random_device{}();\n/// A body in"),
                        (DRAG, DRAG + "    m_vx += kDrawn * dt;\n")],
                       "scenarios played again by another process differ"),
    "hangs_in_a_small_window": ([(DRAG, DRAG + "    while (screenWidth < 100) screenHeight = *const_cast<volatile int*>"
                                        "(&screenHeight);\n")],
                                r"takes more than 20 s; ended in scenario [\w/-]+\.json, step \d+"),
    "exits_when_loaded": ([("#include <cmath>\n", "#include <cmath>\n#include <cstdlib>\n"),
                           ("/// A body in", "static const int kNone = (std::exit(0), 0);\n/// A body in")],
                          "ends the process in its initialisation$"),
    "flushes_to_zero": ([("#include <cmath>\n", "#include <cmath>\n#include <immintrin.h>\n"),
                         (DRAG, DRAG + "    if (m_vy > 900.0) _mm_setcsr(_mm_getcsr() | 0x8040u);\n")],
                        r"changes how the processor computes .*: found after scenario [\w/-]+\.json, step \d+$"),
}


def header(shipped, edits):
    """The text of the shipped header with the edits made."""
    for text, replacement in edits:
        assert text in shipped, text
        shipped = shipped.replace(text, replacement)
    return shipped
