#!/usr/bin/python3
"""Contacts of edited cores: `run` prints what counters in the wall branches of their headers count."""

import json
import os

from core_edits import BOTTOM, DRAG, DRAG_X, DRAG_Y, FLAGS_X, FLAGS_Y, FMIN_AND_FMAX, GRAVITY, LEFT, MOVE_X, MOVE_Y, RIGHT, TOP
from process import succeed
from program import ProgramTest, fling, main
from traced import SHIPPED, SHIPPED_CORE, build, in_namespaces, traced

COUNTED = SHIPPED.replace("#pragma once\n", "#pragma once\n#ifndef MEET\n#define MEET(wall)\n#endif\n")
for _wall, _branch in enumerate((LEFT, RIGHT, TOP, BOTTOM)):
    COUNTED = COUNTED.replace(_branch, f"MEET({1 << _wall});\n      {_branch}")
COUNTED_X_WALLS = COUNTED[COUNTED.index("    if (m_x < 0.0)"):COUNTED.index("    if (m_y < 0.0)")]
STEP = COUNTED[COUNTED.index(f"    {GRAVITY}"):COUNTED.index("  }\n\n  double x()")]
MOVE = f"{MOVE_X}\n    {MOVE_Y}"

# What is replaced in the header, by what.
EDITS = {
    "half moves": ((MOVE, f"for (int half = 0; half < 2; ++half) {{\n{MOVE.replace('dt', '(dt / 2.0)')}\n}}"),),
    "exact flight": ((MOVE_Y, "m_y += m_vy * dt - 0.5 * GRAVITY * dt * dt;"),),
    "float": ((MOVE_X, "m_x = static_cast<float>(m_x + m_vx * dt);"),),
    "fused": ((MOVE_X, "m_x = std::fma(m_vx, dt, m_x);"), (MOVE_Y, "m_y = std::fma(m_vy, dt, m_y);")),
    "reflected": (("m_x = 0.0;", "m_x = -m_x;"), ("m_x = rightBound;", "m_x = 2.0 * rightBound - m_x;")),
    "from the bound on": (("m_y > bottomBound", "m_y >= bottomBound"), ("m_x > rightBound", "m_x >= rightBound")),
    "sub-steps": ((STEP, f"dt = dt / 2.0;\n    for (int part = 0; part < 2; ++part) {{\n{STEP}    }}\n"),),
    "drag by time": ((DRAG_X, "m_vx *= std::pow(AIR_DRAG, 60.0 * dt);"), (DRAG_Y, "m_vy *= std::pow(AIR_DRAG, 60.0 * dt);")),
    "walls in y first": ((COUNTED_X_WALLS, ""), ("  }\n\n  double x()", f"{COUNTED_X_WALLS}  }}\n\n  double x()")),
    "Verlet": ((GRAVITY, "m_vy += 0.5 * GRAVITY * dt;"), ("  }\n\n  double x()", "    m_vy += 0.5 * GRAVITY * dt;\n  }\n\n  double x()")),
    "snap to the left": ((COUNTED_X_WALLS, f"    if (m_x > 0.0 && m_x < 30.0 && std::fabs(m_vx) < 900.0) m_x = 0.0;\n{COUNTED_X_WALLS}"),),
    "walls by flags": (*FLAGS_X, *FLAGS_Y),
    "walls by fmin and fmax": (*FLAGS_X, *FMIN_AND_FMAX),
    "speed limit": ((MOVE, f"if (m_vx > 1500.0) m_vx = 1500.0;\n    {MOVE}"),),
    "quadratic drag": ((DRAG, "const double drag = 1.0 - 1e-4 * dt * std::sqrt(m_vx * m_vx + m_vy * m_vy);\n"
                              "    m_vx *= drag;\n    m_vy *= drag;"),),
}
EVERYDAY = ("reflected", "sub-steps")

STEPS = 900
# In the narrow window the first step ends beyond both walls.
START = {"x_px": -50.25, "y_px": 150.5, "vx_px_per_s": 2400, "vy_px_per_s": -900}
WINDOWS = ((1920, 1080), (300, 400), (100, 600))  # The last one is narrower than the sprite.
COUNTER = f"""template <class Body>
void count(int width, int height) {{
  Body body({START["x_px"]}, {START["y_px"]}, {START["vx_px_per_s"]}, {START["vy_px_per_s"]});
  for (int step = 0; step < {STEPS}; ++step) {{
    met = 0;
    body.update(1.0 / 60.0, width, height, 128, 128);
    std::printf("%d ", met);
  }}
  std::puts("");
}}
"""


def edited(edit):
    """The header's text with the edit."""
    text = COUNTED
    for old, new in EDITS[edit]:
        if text.count(old) != 1:
            raise ValueError(f"{edit}: {old}")
        text = text.replace(old, new)
    return text


PLAYED = {edit: traced(edited(edit)) for edit in (EDITS if "HYRAX_ALL_EDITS" in os.environ else EVERYDAY)}
HALF_MOVES = traced(edited("half moves"))
# More than 4,096 paths.
QUARTERS = traced(COUNTED.replace(STEP, f"for (int part = 0; part < 4; ++part) {{\n{STEP}    }}\n"))


def counted(folder):
    """{edit: for each window the walls that each step met, as a row's contact byte has them}, by their wall branches."""
    source, program = folder / "counter.cpp", folder / "counter"
    text = in_namespaces([core.header for core in PLAYED.values()], ("<cstdio>",), "HYRAX_CORE_HEADER")
    calls = "".join(f"  count<core_{core}::physics>({width}, {height});\n" for core in range(len(PLAYED)) for width, height in WINDOWS)
    source.write_text(f"static int met = 0;\n#define MEET(wall) (met |= (wall))\n{text}{COUNTER}int main() {{\n{calls}}}\n")
    build(source, program)
    lines = iter(succeed(program).out.splitlines())
    return {edit: [[int(met) for met in next(lines).split()] for _ in WINDOWS] for edit in PLAYED}


def played(core, window, folder):
    """The same by `run`, and its document."""
    scenario = fling(name="fling", start=START, steps=STEPS, window=dict(zip(("width_px", "height_px"), window)))
    path, csv = folder / "fling.json", folder / "run.csv"
    path.write_text(json.dumps(scenario), encoding="utf-8")
    document = core.run("run", path, "--json", "-o", csv).json["runs"][0]
    rows = csv.read_text(encoding="utf-8").splitlines()
    return [int(row.rsplit(",", 1)[1]) & 15 for row in rows[2:]], document


class Contacts(ProgramTest):
    """Edited headers, played as what they were traced to be."""

    def test_are_those_of_the_counters(self):
        for edit, by_window in counted(self.folder).items():
            for window, walls in zip(WINDOWS, by_window):
                with self.subTest(edit=edit, window=window):
                    found, document = played(PLAYED[edit], window, self.folder)
                    self.assertEqual(document["contacts_from"], "step", PLAYED[edit].why)
                    self.assertEqual(found, walls)
                    self.assertTrue(any(walls))
                    for wall, name in enumerate(("left", "right", "top", "ground")):
                        met = [byte >> wall & 1 for byte in (0, *walls)]
                        contacts = sum(now > before for before, now in zip(met, met[1:]))
                        self.assertEqual((document["clamped_steps"][name], document["contacts"][name]), (sum(met), contacts), name)

    def test_half_moves_move_no_contact(self):
        outcome = HALF_MOVES.run("check", "--json", "scenarios/flings")
        self.assertTrue(outcome.json["groups"], outcome)
        for group in outcome.json["groups"]:
            self.assertIn(group["class"], ("rounding", "values"))
            self.assertEqual(group["contacts_moved"], 0)
        command = ("run", "scenarios/flings/first-fling.json", "--json", "-o", self.folder / "run.h5")
        by_edited, by_shipped = (core.run(*command).json["runs"][0] for core in (HALF_MOVES, SHIPPED_CORE))
        self.assertEqual((by_edited["contacts"], by_edited["contacts_from"]), (by_shipped["contacts"], "step"))

    def test_rows_tell_those_of_a_step_that_is_not_complete(self):
        # The program plays the shipped step in its place.
        self.assertEqual(QUARTERS.why, "more than 4,096 paths")
        command = ("run", "scenarios/flings/first-fling.json", "-o", self.folder / "run.h5")
        self.assertIn("\n  contacts       right 1, ground 8; from the rows: the core's step is not complete: more than 4,096 "
                      "paths\n", QUARTERS.run(*command).out)
        self.assertEqual(QUARTERS.run(*command, "--json").json["runs"][0]["contacts_from"], "rows")
        self.assertRegex(QUARTERS.run("info").out, r"\ncontacts +from the rows\n")


if __name__ == "__main__":
    main()
