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


class Paper(StudyControl):
    """A changed core flips the verdicts that its change is about, and the author is told which."""

    EXPECTED = SOURCE / "tests/tools/hyrax-sim/paper_verdicts.json"

    def flipped(self, control):
        """The claims with another verdict than the paper's core has: {claim: verdict}."""
        outcome = self.study(control, "paper", "--expect", str(self.EXPECTED))
        expected = json.loads(self.EXPECTED.read_text(encoding="utf-8"))["verdicts"]
        flipped = {claim["claim"]: claim["verdict"] for claim in outcome.json["claims"]
                   if claim["verdict"] != expected[claim["claim"]]}
        self.assertEqual(outcome.exit_code, DISAGREED if flipped else AGREED, outcome)
        self.assertEqual(len(outcome.json["broken"]), len(flipped))
        return flipped

    def test_no_change_flips_nothing(self):
        self.assertEqual(self.flipped("unchanged"), {})

    def test_each_change_flips_its_claims(self):
        for control, claims in (
                ("gravity_by_one_ulp", {"5-gravity": "does not hold"}),
                ("drag_before_gravity", {"4.3-damps-gain": "does not hold", "6-exactly": "does not hold",
                                         "2.4-first-order": "does not hold", "2.3-energy": "not measured"}),
                ("bounce_gains", {"3-restitution": "does not hold", "5-restitution": "does not hold",
                                  "3.2.2-infinite-bounce": "does not hold"}),
                ("rest_rule_gone", {"3.2.2-infinite-bounce": "does not hold"}),
                ("right_wall_softer", {"3-restitution": "does not hold"}),
                ("no_floor", {"3-exact-position": "does not hold", "4.2-tunnel": "holds",
                              "4.2-rare": "does not hold", "4.3-not-stuck": "does not hold"}),
                ("ground_not_strict", {"6-exactly": "does not hold"}),
                ("drag_needs_time", {"6-exactly": "does not hold"}),
                ("y_sees_x", {"2.3-new-velocity": "does not hold"})):
            with self.subTest(control=control):
                flipped = self.flipped(control)
                self.assertLessEqual(claims.items(), flipped.items())

    def test_a_constant_alone_flips_no_law(self):
        self.assertEqual(set(self.flipped("gravity_by_one_ulp")), {"5-gravity"})


class Rest(StudyControl):
    """The boundaries of rest are where the laws put them, and a core of other laws has others or none."""

    def boundaries(self, control, exit_code):
        """{boundary: (analytic, measured)} by the program with that change."""
        outcome = self.study(control, "rest")
        self.assertEqual(outcome.exit_code, exit_code, outcome)
        return [(entry["analytic_hz"], entry["measured_hz"]) for entry in outcome.json["boundaries"]]

    def test_no_change_is_green(self):
        for analytic, measured in self.boundaries("unchanged", AGREED):
            self.assertAlmostEqual(analytic, measured, delta=1e-9 * analytic)

    def test_without_the_rest_rule_there_are_none(self):
        self.assertEqual([measured for _, measured in self.boundaries("rest_rule_gone", DISAGREED)], [None] * 3)

    def test_another_order_shifts_them_from_the_analytic_place(self):
        for analytic, measured in self.boundaries("drag_before_gravity", DISAGREED):
            self.assertGreater(abs(measured - analytic), 1e-4 * analytic)


class FrameRate(StudyControl):
    """The study's own copy of the paper's step is held to the core."""

    def test_no_change_is_green(self):
        outcome = self.study("unchanged", "frame-rate")
        self.assertEqual(outcome.exit_code, AGREED, outcome)

    def test_another_core_is_told(self):
        outcome = self.study("drag_before_gravity", "frame-rate")
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        self.assertIn("is not the core, bit for bit", outcome.json["broken"][0])


if __name__ == "__main__":
    main()
