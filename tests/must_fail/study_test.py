#!/usr/bin/python3
"""A changed core turns the studies red, each change the rule that it breaks.
"""

import json
import pathlib
import sys

import numpy

from altered import StudyControl
from program import AGREED, DISAGREED, SOURCE, main

sys.path.insert(0, str(SOURCE / "tests/oracle"))
import flings  # noqa: E402 pylint: disable=wrong-import-position


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


# Cores of other constants, and the laws that the numbers of studies follow.
CORES = {"none": flings.Laws(), "gravity_stronger": flings.Laws(gravity=1250.0)}

# Cores, and the claims that each flips. Every claim except those of NEVER_FLIPPED is flipped by one of them.
FLIPS = {
    "gravity_by_one_ulp": {"5-gravity": "does not hold"},
    "gravity_none": {"1-axes": "does not hold", "2.3-energy": "holds", "2.2-terminal": "not measured",
                     "2.4-explicit": "not measured"},
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


class Numbers(StudyControl):
    """What studies print of many flings is what tests/oracle/flings.py computes, with the constants of the core; other constants
    move every median, and another step does."""

    def rows(self, core, study, table):
        """A table of the study's document, as {key: row}."""
        keys = ("problem", "method", "clock", "rate_hz")
        return {tuple(row[key] for key in keys if key in row): row for row in self.study(core, study).json[table]}

    def assert_numbers(self, row, **numbers):
        """Counts; and of values of all flings median, 10 and 90 %, as far as the row has columns of these names."""
        for name, values in numbers.items():
            columns = zip((name.replace("BAND", part) for part in ("median", "low", "high")), flings.band(values)) if "BAND" in name else [(name, values)]
            for column, number in columns:
                if column in row or "median" in column:
                    self.assertAlmostEqual(row[column], number, delta=1e-6 * max(1.0, number), msg=(row, column))

    def assert_moved(self, study, table, core, method, *columns):
        """By that core most rows of the method have another number in these columns: times come in frames."""
        moved = self.rows(core, study, table)
        for column in columns:
            pairs = [(row[column], moved[key][column]) for key, row in self.rows("none", study, table).items() if method in (*key, "")]
            self.assertGreater(2 * sum(abs(b - a) > 1e-6 for a, b in pairs), len(pairs), (core, column))

    def test_rest(self):
        for core, laws in CORES.items():
            rates = self.rows(core, "rest", "rates")
            for rate_hz in (24.0, 60.0, 75.0, 144.0):
                played = flings.Flings(flings.starts(100), laws, rate_hz).play(15.0)
                vy = played.vy
                played.step()
                zero, cycle = ((vy == 0.0) & (played.vy == 0.0)).sum(), ((vy == 0.0) != (played.vy == 0.0)).sum()
                self.assert_numbers(rates[rate_hz,], rest=zero, cycle=cycle, buzz=100 - zero - cycle, time_BAND_s=played.anchor_s)
        for core in ("gravity_stronger", "drag_before_gravity"):
            self.assert_moved("rest", "rates", core, "", "time_median_s")

    def test_frame_rate(self):
        begin = numpy.concatenate([[[100.0], [100.0], [900.0], [-1200.0]], flings.starts(100)], axis=1)
        exact = [flings.ExactFling(*each).at(16.0)[0] for each in begin.T]
        for core, laws in CORES.items():
            shifts = self.rows(core, "frame-rate", "shifts")
            for method, by_time in (("paper", None), ("normalised-drag", flings.Laws())):  # By time as by the paper's laws.
                played = {rate_hz: flings.Flings(begin, by_time or laws, rate_hz, by_time=by_time is not None).play(16.0)
                          for rate_hz in (60.0, 24.0, 240.0)}
                for rate_hz, each in played.items():
                    self.assert_numbers(shifts[method, "steady", rate_hz], shift_BAND_px=abs(each.x - played[60.0].x), off_BAND_px=abs(each.x - exact),
                                        other_contacts=(each.contacts[:3] != played[60.0].contacts[:3]).any(axis=0).sum())
        self.assert_moved("frame-rate", "shifts", "gravity_stronger", "paper", "shift_median_px", "off_median_px")

    def test_speed_error(self):
        begin = flings.starts_like(60.0, 900.0, 1000.0, -1350.0, 120)
        exact = [flings.ExactFling(*each) for each in begin.T]
        places = numpy.array([[each.at(row / 60.0)[:2] for each in exact] for row in range(1, 481)])
        for method in ("paper", "normalised-drag"):
            played, apart = flings.Flings(begin, flings.Laws(), 60.0, by_time=method != "paper"), []
            for place in places:
                played.step()
                apart.append(numpy.hypot(played.x - place[:, 0], played.y - place[:, 1]))
            row = self.rows("none", "speed-error", "bands")["fling", method, 60.0]
            self.assert_numbers(row, position_error_BAND_px=numpy.max(apart, axis=0), end_error_BAND_px=apart[-1])
        for core in ("drag_in_y_twice", "drag_before_gravity"):
            self.assert_moved("speed-error", "bands", core, "paper", "position_error_median_px", "end_error_median_px")

    def test_bounces(self):
        for core, laws in CORES.items():
            rates = self.rows(core, "bounces", "rates")
            lossless = flings.Laws(laws.gravity, 1.0, 1.0, 1.0, 0.0)
            for method in ("paper", "explicit-euler"):
                played = flings.Flings(flings.starts(100), lossless, 24.0, moves_first=method != "paper")
                begin = played.energy()
                for name, duration_s in (("minute", 60.0), ("ten_minutes", 540.0)):
                    kept = played.play(duration_s).energy() / begin
                    self.assert_numbers(rates[method, 24.0], **dict(zip((name, f"{name}_low", f"{name}_high"), flings.band(kept))))
                self.assert_numbers(rates[method, 24.0], about_kept=((kept >= 0.5) & (kept <= 2.0)).sum())
        self.assert_moved("bounces", "rates", "gravity_stronger", "paper", "ten_minutes")


if __name__ == "__main__":
    main()
