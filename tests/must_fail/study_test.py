#!/usr/bin/python3
"""A changed core turns the studies red, each change the rule that it breaks.
"""

import json
import pathlib

from altered import StudyControl
from program import AGREED, DISAGREED, SOURCE, main


class HardCases(StudyControl):
    """Each invariant is broken by a core that does not keep it."""

    # Short hard cases of every kind.
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
        outcome = self.study("none", "hard-cases", *self.CASES)
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

    def test_a_finding_that_is_gone_is_reported(self):
        broken = self.broken("no_gravity")  # Without it the sprite does come to a vertical speed of 0.
        self.assertIn(("rest/60-hz", "finding gone"), broken["comes-to-rest"])

    def test_the_sentence_names_case_invariant_size_and_row(self):
        sentences = self.study("right_wall_softer", "hard-cases", *self.CASES).json["broken"]
        self.assertTrue(any(": mirror is broken by " in sentence and " in row " in sentence
                            for sentence in sentences), json.dumps(sentences[:3]))


# Cores, and the claims that each flips. Every claim except those of NEVER_FLIPPED is flipped by one of them.
FLIPS = {
    "gravity_by_one_ulp": {"5-gravity": "does not hold"},
    "gravity_none": {"1-axes": "does not hold", "2.3-energy": "holds", "2.4-explicit": "does not hold"},
    "drag_before_gravity": {"2.1-gravity": "does not hold", "2.3-energy": "not measured",
                            "3-x-first": "not measured",
                            "4.3-damps-gain": "does not hold", "4.3-order-alters": "not measured",
                            "6-exactly": "does not hold"},
    "bounce_gains": {"3-restitution": "does not hold", "3.2.2-infinite-bounce": "does not hold",
                     "4.1-missed": "not measured", "5-restitution": "does not hold"},
    "drag_gains": {"2.2-exponential": "does not hold", "2.2-terminal": "does not hold",
                   "5-air-drag": "does not hold"},
    "drag_by_time": {"2.2-stokes": "holds", "6.1-frame-rate": "holds"},
    "drag_explicit": {"4.1-stable-dt": "holds"},
    "drag_on_vx_alone": {"2.2-both-components": "does not hold"},
    "friction_stronger": {"5-ground-friction": "does not hold"},
    "friction_left_out": {"3.2.2-friction": "does not hold"},
    "friction_on_all_walls": {"3.1-no-friction": "does not hold", "3.2.2-only-on-ground": "does not hold"},
    "rest_earlier": {"5-rest-threshold": "does not hold"},
    "rest_signed": {"3.2.2-signed": "holds"},
    "rest_rule_gone": {"3.2.2-infinite-bounce": "does not hold"},
    "right_wall_softer": {"3-restitution": "does not hold"},
    "ceiling_stops": {"3.2.1-top": "does not hold"},
    "ceiling_does_not_turn": {"3.2.1-top": "does not hold"},
    "no_losses": {"5-energy-retention": "holds"},
    "no_ceiling": {"4.1-missed": "does not hold"},
    "no_floor": {"3-exact-position": "does not hold", "4.2-tunnel": "holds", "4.2-rare": "does not hold",
                 "4.3-not-stuck": "does not hold"},
    "no_motion_in_x": {"1-axes": "does not hold", "6.2-drawing": "holds"},
    "position_before_velocity": {"2.3-oscillators": "does not hold"},
    "position_by_mean_velocity": {"2.3-oscillators": "does not hold", "2.4-first-order": "does not hold",
                                  "4.1-energy-drift": "does not hold"},
    "walls_twice": {"6.1-sizes": "holds"},
    "reset_keeps_vy": {"6.1-reset": "does not hold"},
    "y_before_x": {"6-exactly": "does not hold"},
    "y_sees_x": {"2.3-new-velocity": "does not hold"},
}
NEVER_FLIPPED = {
    "3-centre": "its throws start all over the window with every core",
    "7-fast": "judges a time; a unit test gives it a slow step",
}


class Paper(StudyControl):
    """A changed core flips the verdicts that its change is about, and the program reports which."""

    EXPECTED = str(SOURCE / "tests/cli/paper_verdicts.json")

    def expected(self):
        """{claim: verdict} of the paper's core."""
        return json.loads(pathlib.Path(self.EXPECTED).read_text(encoding="utf-8"))["verdicts"]

    def flipped(self, control):
        """The claims with another verdict than the paper's core has: {claim: verdict}."""
        outcome = self.study(control, "paper", "--expect", self.EXPECTED)
        expected = self.expected()
        flipped = {claim["claim"]: claim["verdict"] for claim in outcome.json["claims"]
                   if claim["verdict"] != expected[claim["claim"]]}
        self.assertEqual(outcome.exit_code, DISAGREED if flipped else AGREED, outcome)
        self.assertEqual(len(outcome.json["broken"]), len(flipped))
        return flipped

    def test_no_change_flips_nothing(self):
        self.assertEqual(self.flipped("none"), {})

    def test_each_change_flips_its_claims(self):
        for control, claims in FLIPS.items():
            with self.subTest(control=control):
                flipped = self.flipped(control)
                self.assertLessEqual(claims.items(), flipped.items())

    def test_each_claim_is_flipped_by_some_core(self):
        expected = self.expected()
        flipped = {claim for claims in FLIPS.values() for claim in claims}
        self.assertEqual(set(expected) - flipped, set(NEVER_FLIPPED))

    def remark(self, control, claim):
        """The remark on a claim."""
        claims = self.study(control, "paper", "--expect", self.EXPECTED).json["claims"]
        return next(entry["remark"] for entry in claims if entry["claim"] == claim)

    def test_remarks_follow_from_what_was_measured(self):
        for claim, text, core, other in (
                ("4.2-tunnel", "a clamp cannot be passed", "no_floor", "of "),
                ("5-energy-retention", "the ratio of speeds, 0.6, squared", "side_walls_softer", "nor its square"),
                ("3.2.2-signed", "it is |vy| that is compared", "rest_rule_gone", "|vy| is not compared, either"),
                ("2.2-exponential", "until it sticks at", "no_motion_in_x", "until it sticks at"),
                ("3.2.2-infinite-bounce", "but the position stands still", "bounce_gains", "some drops keep bouncing"),
                ("6.1-reset", "in the air gravity starts it again", "reset_keeps_vy", "it leaves (0, -300) px/s"),
                ("3-x-first", "nothing penetrates in either order", "y_before_x", "is not the listing's")):
            with self.subTest(claim=claim):
                self.assertIn(text, self.remark("none", claim))
                remark = self.remark(core, claim)
                self.assertIn(other, remark)
                if other != text:
                    self.assertNotIn(text, remark)

    def test_a_core_that_no_step_is_stable_for_has_no_largest_one(self):
        self.assertNotIn("4.1-stable-dt", self.flipped("bounce_explodes"))

    def test_constants_are_printed_with_all_digits(self):
        outcome = self.study("gravity_by_one_ulp", "paper", "--expect", self.EXPECTED)
        self.assertIn("1200.0000000000002", outcome.json["broken"][0])
        self.assertEqual(self.remark("gravity_by_one_ulp", "5-gravity"), "the paper has 1200")

    def test_a_changed_constant_flips_no_law(self):
        self.assertEqual(set(self.flipped("gravity_by_one_ulp")), {"5-gravity"})


class Rest(StudyControl):
    """The boundaries of rest follow from the laws; a core with other laws has others or none."""

    def boundaries(self, control, exit_code):
        """{boundary: (analytic, measured)} by the program with that change."""
        outcome = self.study(control, "rest")
        self.assertEqual(outcome.exit_code, exit_code, outcome)
        return [(entry["analytic_hz"], entry["measured_hz"]) for entry in outcome.json["boundaries"]]

    def test_no_change_is_green(self):
        for analytic, measured in self.boundaries("none", AGREED):
            self.assertAlmostEqual(analytic, measured, delta=1e-9 * analytic)

    def test_without_the_rest_rule_there_are_none(self):
        self.assertEqual([measured for _, measured in self.boundaries("rest_rule_gone", DISAGREED)], [None] * 3)

    def test_another_order_shifts_them_from_the_analytic_place(self):
        for analytic, measured in self.boundaries("drag_before_gravity", DISAGREED):
            self.assertGreater(abs(measured - analytic), 1e-4 * analytic)


class FrameRate(StudyControl):
    """The results for the step hold for the core, and drag by time changes them."""

    def test_no_change_is_green(self):
        outcome = self.study("none", "frame-rate")
        self.assertEqual(outcome.exit_code, AGREED, outcome)

    def test_a_core_with_drag_by_time_is_reported(self):
        outcome = self.study("drag_by_time", "frame-rate")
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        self.assertIn("are no more independent of the frame rate", outcome.json["broken"][0])

    def test_a_core_with_hidden_state_is_reported(self):
        outcome = self.study("hidden_state", "frame-rate")
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        self.assertIn("differs from the core", outcome.json["broken"][0])


class SpeedError(StudyControl):
    """The paper's step is where its closed forms have it, and a core of another flight is not."""

    def test_no_change_is_green(self):
        outcome = self.study("none", "speed-error")
        self.assertEqual(outcome.exit_code, AGREED, outcome)

    def test_another_flight_is_reported(self):
        for core in ("no_gravity", "drag_in_y_twice", "drag_before_gravity", "position_before_velocity"):
            with self.subTest(core=core):
                self.assertEqual(self.study(core, "speed-error").exit_code, DISAGREED)


if __name__ == "__main__":
    main()
