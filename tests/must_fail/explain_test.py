#!/usr/bin/python3
"""What `check` says of every altered core: the cause where a single change gives the new bits, else "unknown".

    explain_test.py             tests, and compares README.md beside this file with the table
    explain_test.py --update    writes the table into README.md
"""

import functools
import json
import re
import sys
import tempfile
import unittest

from altered import CONTROLS, altered_cores, run_altered
from process import run
from program import SOURCE, main

README = SOURCE / "tests/must_fail/README.md"
BEGIN, END = "<!-- table of explain_test.py -->\n", "<!-- end of the table -->\n"

SCENARIOS = ["scenarios/flings", *(f"scenarios/{name}.json" for name in (
    "paper/exact-bounds", "paper/corner-x-before-y", "hard/corners", "hard/rest", "hard/on-a-bound", "hard/grazing",
    "hard/sprite-larger-than-window", "hard/frames-of-no-time", "hard/trace-of-extremes", "clocks/jitter-normal",
    "clocks/jitter-uniform", "clocks/missed-frames"))]

# The same arithmetic in another order: no bit of any run changes.
SAME_BITS = {"friction_before_restitution", "turn_before_clamp", "y_moves_before_x"}

# What one change of the listing, or of what it is fed, reproduces: operation and kind.
SINGLE = {
    "constant": {"gravity": "gravity_by_one_ulp gravity_stronger gravity_none gravity_upward",
                 "restitution": "restitution_softer bounce_gains bounce_explodes right_wall_softer side_walls_softer "
                                "ceiling_softer ceiling_elastic",
                 "drag": "drag_stronger drag_gains", "friction": "friction_stronger friction_none",
                 "rest_rule": "rest_earlier rest_later", "several": "no_losses two_constants"},
    "comparison": {"wall_x": "left_not_strict right_not_strict left_turned",
                   "wall_y": "top_not_strict ground_not_strict ground_turned",
                   "rest_rule": "rest_not_strict rest_signed rest_turned ground_stops"},
    "dropped": {"gravity": "no_gravity", "drag": "no_drag_in_x no_drag_in_y",
                "position": "no_motion_in_x no_motion_in_y",
                "wall_x": "no_left_wall no_right_wall left_does_not_clamp",
                "wall_y": "no_ceiling no_ground ceiling_does_not_clamp no_floor",
                "restitution": "left_does_not_turn right_does_not_turn ceiling_does_not_turn ground_does_not_turn",
                "friction": "friction_left_out", "rest_rule": "rest_rule_gone"},
    "doubled": {"gravity": "gravity_twice", "drag": "drag_twice drag_in_x_twice drag_in_y_twice",
                "position": "motion_in_x_twice motion_in_y_twice",
                "restitution": "left_turns_twice ceiling_turns_twice ground_turns_twice", "friction": "friction_twice"},
    "added": {"friction": "friction_on_side_walls friction_on_ceiling", "rest_rule": "rest_rule_on_ceiling"},
    "order": {"drag": "drag_before_gravity",
              "position": "position_before_velocity x_by_old_vx y_by_old_vy position_before_drag",
              "wall_y": "y_before_x ground_before_top", "several": "walls_before_flight",
              "rest_rule": "rest_before_restitution"},
    "sign": {"gravity": "gravity_subtracted", "position": "x_subtracted y_subtracted",
             "restitution": "left_keeps_direction ceiling_keeps_direction ground_keeps_direction"},
    "swapped": {"gravity": "gravity_on_vx", "drag": "drag_on_vx_alone", "position": "x_moved_by_vy y_moved_by_vx",
                "friction": "friction_on_vy", "rest_rule": "rest_rule_on_vx", "several": "bounds_exchanged"},
    "changed": {"clock": "frames_by_one_ulp frames_longer jitter_longer", "input": "inputs_late inputs_later"},
}
EXPECTED = {core: (operation, kind) for kind, operations in SINGLE.items()
            for operation, cores in operations.items() for core in cores.split()}

# Which runs it changes depends on the runs before and beside them, so that the table has no row of it.
NOT_REPEATABLE = {"hidden_state"}

# Cores of several changes that declare other constants.
WITH_OTHER_CONSTANTS = {"order_and_constant", "clock_and_drag"}

# Laws and setters that no single change of the listing has: nothing is claimed.
NOTHING = {"position_by_mean_velocity", "y_sees_x", "update_alone",
           "mirrored_at_walls", "bounds_without_sprite", "fling_adds", "reset_does_nothing", "place_keeps_y"}


@functools.cache
def groups_of(core):
    """What is said of a core, or of the fused build: (number of scenarios that differ, groups)."""
    arguments = ("check", "--json", *SCENARIOS)
    if core == "contracted":
        outcome = run(CONTROLS / "control_contracted", *arguments, cwd=SOURCE)
    else:
        outcome = run_altered(core, *arguments)
    document = json.loads(outcome.out)
    return document["disagreed"], document["groups"]


def claims(core):
    """The groups whose cause is told."""
    return [group for group in groups_of(core)[1] if group["kind"] != "unknown"]


@functools.cache
def hashes(core, scenarios):
    """State hashes of scenarios, played with a core."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        runs = json.loads(run_altered(core, "run", *scenarios, "--json", "-o", folder + "/").out)["runs"]
    return [entry["state_hash"] for entry in runs]


def said(groups):
    """The groups in a cell of the table."""
    texts = []
    for group in groups:
        detail = re.sub(r"[|`]", "", group["detail"]) if group["kind"] != "unknown" else ""
        cause = "unknown" if group["kind"] == "unknown" else f"{group['operation']}, {group['kind']}"
        count = len(group["scenarios"])
        if texts and cause == "unknown" and texts[-1][0] == cause:
            texts[-1] = (cause, texts[-1][1] + count, "")
        else:
            texts.append((cause, count, f": `{detail}`" if detail else ""))
    return "; ".join(f"{count} {cause}{detail}" for cause, count, detail in texts) or "no bit differs"


def table():
    """A row for each altered core, and the fused build."""
    rows = ["| altered core | what is changed | differ | what `check` says of them |\n", "|---|---|---|---|\n"]
    cores = {**altered_cores(), "contracted": ("build", "multiply-adds fused by the compiler")}
    for core, (operation, change) in cores.items():
        if core not in NOT_REPEATABLE | {"none"}:
            differing, groups = groups_of(core)
            rows.append(f"| `{core}` | {operation}: {change.replace('|', chr(92) + '|')} | {differing} | {said(groups)} |\n")
    return "".join(rows)


class Explained(unittest.TestCase):
    """Each altered core, by what is said of it."""

    maxDiff = None

    def test_there_are_enough_of_every_kind(self):
        self.assertGreaterEqual(len(EXPECTED), 60)
        self.assertLessEqual(set(EXPECTED) | NOTHING | SAME_BITS, set(altered_cores()))

    def test_a_single_change_is_named(self):
        for core, cause in EXPECTED.items():
            with self.subTest(core=core):
                differing, groups = groups_of(core)
                self.assertGreater(differing, 0)
                self.assertEqual([(group["operation"], group["kind"]) for group in groups], [cause])
                self.assertEqual(groups[0]["reproduced"], differing)

    def test_the_same_bits_are_green(self):
        for core in SAME_BITS:
            with self.subTest(core=core):
                self.assertEqual(groups_of(core), (0, []))

    def test_what_no_single_change_has_is_unknown(self):
        for core in NOTHING:
            with self.subTest(core=core):
                self.assertGreater(groups_of(core)[0], 0)
                self.assertEqual(claims(core), [])

    def test_of_all_others_a_part_is_unknown(self):
        for core in set(altered_cores()) - set(EXPECTED) - NOTHING - SAME_BITS - {"none"}:
            with self.subTest(core=core):
                self.assertIn("unknown", [group["kind"] for group in groups_of(core)[1]])

    def test_every_claim_is_reproduced_by_the_core_that_has_this_change_alone(self):
        core_of = {claims(core)[0]["detail"]: core for core, (_, kind) in EXPECTED.items()
                   if kind != "changed" and claims(core)}
        checked = 0
        for core in altered_cores():
            for group in claims(core):
                other = core_of.get(group["detail"])
                # A number in the place of a constant has as many values as there are numbers: no core for each.
                is_number = group["kind"] == "constant" and core not in EXPECTED
                if group["kind"] == "changed" or other == core or (is_number and core not in WITH_OTHER_CONSTANTS):
                    continue
                with self.subTest(core=core, claim=group["detail"]):
                    scenarios = tuple(group["scenarios"])
                    self.assertIsNotNone(other, "the list has no core with this change alone")
                    self.assertEqual(hashes(core, scenarios), hashes(other, scenarios))
                    checked += 1
        self.assertGreater(checked, 0)

    def test_a_fused_build_is_told_from_a_changed_source(self):
        differing, _ = groups_of("contracted")
        if differing == 0:
            self.skipTest("this compiler or processor fuses nothing")
        found = claims("contracted")
        self.assertEqual({group["kind"] for group in found}, {"fused"})
        self.assertEqual(found[0]["operation"], "several")
        self.assertGreaterEqual(sum(group["reproduced"] for group in found), 0.9 * differing)

    def test_the_table_in_the_readme_is_this_one(self):
        text = README.read_text(encoding="utf-8")
        self.assertEqual(text[text.index(BEGIN) + len(BEGIN):text.index(END)], table())


def update():
    """Writes the table into README.md."""
    text = README.read_text(encoding="utf-8")
    README.write_text(text[:text.index(BEGIN)] + BEGIN + table() + text[text.index(END):], encoding="utf-8")


if __name__ == "__main__":
    if "--update" in sys.argv:
        update()
    else:
        main()
