#!/usr/bin/python3
"""A changed core turns the studies red, each change the rule that it breaks.

HYRAX_CONTROLS is the folder of the programs with a changed core: control_NAME.
"""

import json
import os
import pathlib
import subprocess

from program import AGREED, DISAGREED, SOURCE, Outcome, ProgramTest, main

CONTROLS = pathlib.Path(os.environ["HYRAX_CONTROLS"])


class StudyControl(ProgramTest):
    """A study by a program with a changed core."""

    def study(self, control, name, *options):
        """What the program with that change says."""
        command = [str(CONTROLS / f"control_{control}"), "study", name, "--quick", "--gate", "--no-figures", "--json",
                   "-o", str(self.folder), *options]
        return Outcome(subprocess.run(command, cwd=SOURCE, capture_output=True, check=False))


class HardCases(StudyControl):
    """Each invariant is broken by a core that does not keep it."""

    # Hard in every way, and short.
    CASES = [f"scenarios/hard/{name}.json" for name in (
        "any-frame", "any-speed", "corners", "frames-of-no-time", "grazing", "on-a-bound", "rest",
        "trace-of-extremes")]

    def broken(self, control):
        """The invariants that are broken, and the findings that are gone: {invariant: {case}}."""
        outcome = self.study(control, "hard-cases", *self.CASES)
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        broken = {}
        for case in outcome.json["cases"]:
            for name, entry in case["invariants"].items():
                if entry["verdict"] in ("broken", "finding gone"):
                    broken.setdefault(name, set()).add((case["case"], entry["verdict"]))
        return broken

    def test_no_change_is_green(self):
        outcome = self.study("unchanged", "hard-cases", *self.CASES)
        self.assertEqual(outcome.exit_code, AGREED, outcome)

    def test_each_change_breaks_its_invariant(self):
        for control, invariants in (("bounce_explodes", {"finite"}),
                                    ("bounce_gains", {"step-energy", "energy-ceiling"}),
                                    ("no_floor", {"in-bounds", "clamp"}),
                                    ("drag_before_gravity", {"speed"}),
                                    ("ground_not_strict", {"clamp"}),
                                    ("right_wall_softer", {"mirror"}),
                                    ("y_sees_x", {"y-alone"}),
                                    ("hidden_state", {"repeated", "resumed"}),
                                    ("rest_rule_gone", {"comes-to-rest"}),
                                    ("bounce_gains", {"expectations"})):
            with self.subTest(control=control):
                self.assertLessEqual(invariants, set(self.broken(control)))

    def test_one_wall_that_is_softer_breaks_the_mirror_and_no_law_of_energy(self):
        broken = self.broken("right_wall_softer")
        self.assertNotIn("step-energy", broken)
        self.assertNotIn("speed", broken)

    def test_a_finding_that_is_gone_is_told(self):
        broken = self.broken("drag_needs_time")
        self.assertIn(("frames-of-no-time", "finding gone"), broken["no-time"])

    def test_the_sentence_names_case_invariant_size_and_row(self):
        sentences = self.study("right_wall_softer", "hard-cases", *self.CASES).json["broken"]
        self.assertTrue(any(": mirror is broken by " in sentence and " in row " in sentence
                            for sentence in sentences), json.dumps(sentences[:3]))


if __name__ == "__main__":
    main()
