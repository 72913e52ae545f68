#!/usr/bin/python3
"""A changed core turns the studies red, each change the rule that it breaks."""

import json
import re
import sys

import numpy

from altered import studied
from program import AGREED, DISAGREED, SOURCE, ProgramTest, main

sys.path.insert(0, str(SOURCE / "tests/oracle"))
import flings  # noqa: E402 pylint: disable=wrong-import-position


# Cores of other constants, and the laws that the numbers of studies follow.
CORES = {"none": flings.Laws(), "gravity_stronger": flings.Laws(gravity=1250.0)}

# Cores, the claims that each flips, and what is said of one. Of other cores: tests/unit/sim/study/approved/paper-of-others.txt.
FLIPS = {
    "drag_by_time": {"2.2-stokes": "holds"},
    "drag_explicit": {"4.1-stable-dt": "holds"},
    "friction_on_all_walls": {"3.2.2-only-on-ground": "does not hold"},
    "no_floor": {"4.2-rare": "does not hold"},
    "y_before_x": {"6-exactly": "does not hold"},
    "y_sees_x": {"2.3-new-velocity": "does not hold"},
}
NEVER_FLIPPED = {
    "3-centre": "its throws start all over the window with every core",
    "7-fast": "judges a time; a unit test gives it a slow step",
}


class Paper(ProgramTest):
    """A changed core flips the verdicts that its change is about, and the program reports which."""

    EXPECTED = SOURCE / "tests/cli/paper_verdicts.json"

    def expected(self):
        """{claim: verdict} of the paper's core."""
        return json.loads(self.EXPECTED.read_text(encoding="utf-8"))["verdicts"]

    def flipped(self, control):
        """The claims with another verdict than the paper's core has, {claim: verdict}; and the document."""
        outcome = studied(control, "paper", "--expect", str(self.EXPECTED))
        document, expected = outcome.json, self.expected()
        flipped = {claim["claim"]: claim["verdict"] for claim in document["claims"]
                   if claim["verdict"] != expected[claim["claim"]]}
        self.assertEqual(outcome.exit_code, DISAGREED if flipped else AGREED, outcome)
        self.assertEqual(len(document["broken"]), len(flipped))
        return flipped, document

    def test_each_change_flips_its_claims(self):
        for control, claims in FLIPS.items():
            with self.subTest(control=control):
                self.assertLessEqual(claims.items(), self.flipped(control)[0].items())
        self.assertNotIn("4.1-stable-dt", self.flipped("bounce_explodes")[0], "no step is stable")

    def test_each_claim_is_flipped_by_some_core(self):
        expected = self.expected()
        others = (SOURCE / "tests/unit/sim/study/approved/paper-of-others.txt").read_text(encoding="utf-8")
        flipped = {claim for claim, verdict in re.findall(r"^  (\S+): ([^,]+),", others, re.MULTILINE) if verdict != expected[claim]}
        self.assertEqual(set(expected) - flipped.union(*FLIPS.values()), set(NEVER_FLIPPED))

    def test_a_remark_follows_from_what_was_measured(self):
        for core, says in (("none", "it is |vy| that is compared"), ("rest_rule_gone", "|vy| is not compared, either")):
            remarks = {claim["claim"]: claim["remark"] for claim in self.flipped(core)[1]["claims"]}
            self.assertIn(says, remarks["3.2.2-signed"])

    def test_a_constant_by_one_ulp_flips_no_law_and_is_printed_with_all_digits(self):
        flipped, document = self.flipped("gravity_by_one_ulp")
        self.assertEqual(flipped, {"5-gravity": "does not hold"})
        self.assertIn("1200.0000000000002", document["broken"][0])


class Gates(ProgramTest):
    """Other studies are red on a core that breaks what they are about. On the shipped core each is green: study.NAME."""

    def test_what_is_broken_is_reported(self):
        for study, core, says in (("rest", "rest_rule_gone", "measured none"),
                                  ("rest", "drag_before_gravity", r"analytic \S+ Hz, measured \d\S+ Hz"),
                                  ("frame-rate", "drag_by_time", "are no more independent of the frame rate"),
                                  ("frame-rate", "hidden_state", "differs from the core"),
                                  ("speed-error", "drag_before_gravity", "of velocity is its closed form"),
                                  ("speed-error", "position_before_velocity", "of first order")):
            with self.subTest(study=study, core=core):
                outcome = studied(core, study)
                self.assertEqual(outcome.exit_code, DISAGREED, outcome)
                self.assertRegex(outcome.json["broken"][0], says)


class Numbers(ProgramTest):
    """What studies print of many flings is what tests/oracle/flings.py computes, with the constants of the core. What a study says
    of another step: Gates."""

    def rows(self, core, study, table):
        """A table of the study's document, as {key: row}."""
        keys = ("problem", "method", "clock", "rate_hz")
        return {tuple(row[key] for key in keys if key in row): row for row in studied(core, study).json[table]}

    def assert_numbers(self, row, **numbers):
        """Counts; and of values of all flings median, 10 and 90 %, as far as the row has columns of these names."""
        for name, values in numbers.items():
            columns = zip((name.replace("BAND", part) for part in ("median", "low", "high")), flings.band(values)) if "BAND" in name else [(name, values)]
            for column, number in columns:
                if column in row or "median" in column:
                    self.assertAlmostEqual(row[column], number, delta=1e-6 * max(1.0, number), msg=(row, column))

    def test_rest(self):
        for core, laws in CORES.items():
            rates = self.rows(core, "rest", "rates")
            for rate_hz in (24.0, 60.0, 75.0, 144.0):
                played = flings.Flings(flings.starts(100), laws, rate_hz).play(15.0)
                vy = played.vy
                played.step()
                zero, cycle = ((vy == 0.0) & (played.vy == 0.0)).sum(), ((vy == 0.0) != (played.vy == 0.0)).sum()
                self.assert_numbers(rates[rate_hz,], rest=zero, cycle=cycle, buzz=100 - zero - cycle, time_BAND_s=played.anchor_s)

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


if __name__ == "__main__":
    main()
