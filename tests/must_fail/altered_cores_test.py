"""The list of altered cores: each is chosen by its name.

`study hard-cases --gate` is red on every one that changes results, except those that are named here with the reason.
"""

import re
import unittest

from altered import CONTROLS, ONLY_CONSTANTS, SAME_BITS, changed_steps, run_altered, studied
from process import succeed
from program import AGREED, DISAGREED, SOURCE, ProgramTest, fling

# Short scenarios: hard cases, a stop and a grab.
CASES = [f"scenarios/{name}.json" for name in (
    "hard/any-speed", "hard/corners", "hard/frames-of-no-time", "hard/grazing", "hard/hitch", "hard/on-a-bound", "hard/rest",
    "hard/sprite-larger-than-window", "hard/trace-of-extremes", "flings/grab-and-throw", "flings/stop-in-flight")]

# A bounce from the floor that leaves the threshold itself: 5 px/s, to the bit.
THRESHOLD = fling(name="threshold", steps=20,
                  start={"x_px": 896, "y_px": 952, "vx_px_per_s": 0, "vy_px_per_s": -11.658324991658324})

# What the hard cases break of a few cores, besides other invariants.
INVARIANTS = {
    "bounce_explodes": {"finite"},
    "bounce_gains": {"step-energy", "energy-ceiling"},
    "no_floor": {"in-bounds", "listing"},
    "drag_before_gravity": {"speed"},
    "ground_not_strict": {"listing"},
    "right_wall_softer": {"mirror"},
    "y_sees_x": {"listing"},
    "hidden_state": {"repeated", "resumed"},
    "rest_rule_gone": {"comes-to-rest"},
    "mirrored_at_walls": {"stays-at-rest"},  # Frames of uneven length move it.
    "rest_signed": {"stays-at-rest"},  # A long frame does not throw it: the expected failure is gone.
}


class OneCore(unittest.TestCase):
    """No program has two definitions of class physics."""

    def test_one_source_includes_the_core(self):
        paths = [path for folder in ("sim", "tools/app", "tools/hyrax-sim") for path in (SOURCE / folder).rglob("*")
                 if path.suffix in (".cpp", ".h")]
        users = [path for path in paths if '\n#include "sim/physics/physics.h"' in "\n" + path.read_text(encoding="utf-8")]
        self.assertEqual(users, [SOURCE / "sim/core/shipped_core.cpp"])

    def test_programs_with_another_core_do_not_link_it(self):
        for control, has_it in (("altered", False), ("traced", False), ("contracted", True)):
            symbols = succeed("nm", "-C", CONTROLS / f"control_{control}").out
            self.assertEqual("hyrax::shipped_core()" in symbols, has_it, control)


class EveryCore(ProgramTest):
    """What each core changes, and which test detects it."""

    def red(self, core):
        """The invariants of hard-cases that this core breaks, without the expected failures of the scenarios."""
        outcome = studied(core, "hard-cases", *CASES, self.folder / self.write("threshold.json", THRESHOLD))
        self.assertIn(outcome.exit_code, (AGREED, DISAGREED), outcome)
        broken = {name for case in outcome.json["cases"] for name, entry in case["invariants"].items()
                  if entry["verdict"] in ("broken", "finding gone")}
        self.assertEqual(outcome.exit_code == DISAGREED, bool(broken), core)
        return broken - {"expectations"}

    def test_hard_cases_detect_it_or_the_reason_is_listed(self):
        for core in changed_steps():
            with self.subTest(core=core):
                broken = self.red(core)
                self.assertEqual(broken == set(), core in SAME_BITS | ONLY_CONSTANTS)
                self.assertLessEqual(INVARIANTS.get(core, set()), broken)
                if core == "right_wall_softer":
                    self.assertTrue(broken.isdisjoint({"step-energy", "speed"}), "it gains no energy")

    def test_check_is_red_on_what_hard_cases_do_not_see(self):
        """And names the constants, as `check --core` does alone."""
        for core in ONLY_CONSTANTS:
            with self.subTest(core=core):
                outcome, of_core = run_altered(core, "check", "scenarios/flings", exit_code=DISAGREED), run_altered(core, "check", "--core")
                named = re.findall(r"constant: ([A-Z_]+) \S+ -> \S+", of_core.out)
                self.assertEqual((of_core.out[:14], len(named)), ("core: changed\n", 2 if core == "two_constants" else 1), of_core)
                self.assertTrue(all(f"constant: {name} " in outcome.out for name in named), outcome)
