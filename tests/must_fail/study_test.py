#!/usr/bin/python3
"""A changed core turns the studies red, each change the rule that it breaks."""

import json
import os
import re
import sys
from unittest import mock

import numpy

from altered import ALTERED, studied
from program import AGREED, DISAGREED, SOURCE, ProgramTest, main
from traced import SHIPPED, traced

sys.path.insert(0, str(SOURCE / "tests/oracle"))
# pylint: disable=wrong-import-position
import claims  # noqa: E402
import claims_test  # noqa: E402
import flings  # noqa: E402


# Cores of other constants, and the laws that the numbers of studies follow.
CORES = {"none": flings.Laws(), "gravity_stronger": flings.Laws(gravity=1250.0)}

# Cores, and claims that have another verdict with each.
FLIPS = {
    "gravity_upward": "1-axes 2.1-gravity 2.2-terminal 4.1-energy-drift 5-gravity", "drag_in_y_twice": "2.2-both-components",
    "drag_by_time": "2.2-stokes 2.4-first-order", "no_drag_in_x": "2.2-exponential", "drag_explicit": "4.1-stable-dt",
    "drag_before_gravity": "4.3-damps-gain 4.3-order-alters", "clock_and_drag": "5-air-drag", "y_sees_x": "2.3-new-velocity 6-exactly",
    "left_does_not_clamp": "3-exact-position 4.2-tunnel 4.2-rare 4.3-not-stuck", "ceiling_stops": "3-restitution 3.1-no-friction 3.2.1-top",
    "bounce_gains": "5-restitution", "friction_none": "3.2.2-friction 5-ground-friction", "friction_on_all_walls": "3.2.2-only-on-ground",
    "rest_signed": "3.2.2-signed", "rest_rule_gone": "3.2.2-infinite-bounce", "rest_earlier": "5-rest-threshold",
    "walls_before_flight": "6.1-sizes", "reset_does_nothing": "6.1-reset", "x_subtracted": "6.2-drawing",
}
NEVER_FLIPPED = {
    "3-centre": "its throws start all over the window with every core",
    **dict.fromkeys(("2.3-energy", "2.3-oscillators", "2.4-explicit", "3-x-first"), "of the second program's own steps"),
    **dict.fromkeys(("4.1-missed", "5-energy-retention", "6.1-frame-rate"), "other figures, the same verdict with all cores here"),
}


class Claims(ProgramTest):
    """A changed core turns the verdicts of the paper's claims that its change is about."""

    def test_each_change_turns_its_claims(self):
        page = {name: verdict for name, (verdict, _) in claims_test.cells_of(claims.PAGE.read_text(encoding="utf-8")).items()}
        with mock.patch.object(claims, "PROGRAM", ALTERED), mock.patch.dict(os.environ):
            for core, names in FLIPS.items():
                os.environ["HYRAX_ALTERED_CORE"] = core
                claims.all_throws.cache_clear()
                for name in names.split():
                    self.assertNotEqual(claims.CLAIMS[name]()[0], page[name], (core, name))

    def test_each_claim_is_turned_by_some_core(self):
        self.assertEqual(set(claims.CLAIMS) - set(" ".join(FLIPS.values()).split()), set(NEVER_FLIPPED))


class Gates(ProgramTest):
    """Other studies are red on a core that breaks what they are about. On the shipped core each is green: study.NAME."""

    def test_what_is_broken_is_reported(self):
        for study, core, says in (("frame-rate", "drag_by_time", "are no more independent of the frame rate"),
                                  ("frame-rate", "hidden_state", "differs from the core"),
                                  ("frame-rate", "bounce_gains", "100 of 101 flings have not settled within 16 s"),
                                  ("speed-error", "drag_before_gravity", "truncation is its closed form"),
                                  ("speed-error", "position_before_velocity", "truncation is its closed form")):
            with self.subTest(study=study, core=core):
                outcome = studied(core, study)
                self.assertEqual(outcome.exit_code, DISAGREED, outcome)
                self.assertRegex(outcome.json["broken"][0], says)


class Rounding(ProgramTest):
    """`study frame-rate` replays the traced step in wider arithmetic: what it says of headers that lose digits, and of those that do not."""

    MOVE = "m_x += m_vx * dt;"
    # Of each header what it says, and rounding in px at most and at least.
    HEADERS = {
        SHIPPED: (r"; no value loses half its digits\.\n", 1e-13, 1e-11),
        SHIPPED.replace("double", "float"): (r"; vy \+ float\(dt\) \* 1200 loses half its digits \(at 144 Hz, row \d+\)\. Does float matter here\? "
                                             r"No: that is less than half a pixel\.", 1e-4, 1e-2),
        SHIPPED.replace("double", "float").replace(MOVE, "m_x += (m_vx + 1e8f) * dt - 1e8f * dt;"): (r" Yes: that is more than half a pixel\.", 0.5, 100.0),
        SHIPPED.replace(MOVE, "m_x += (m_vx + 1e12) * dt - 1e12 * dt;"): (
            r"; dt \* \(vx \* 0\.999 \+ 1e\+12\) - dt \* 1e\+12 loses half its digits \(at 24 Hz, row 1\)\.\n", 1e-5, 1e-3),
        SHIPPED.replace(MOVE, "m_x += std::copysign(std::sqrt(m_vx * m_vx + 1.0), std::sin(m_vx / 1e6)) * dt;"): (r"; no value loses half its digits", 1e-13, 1e-9),
        SHIPPED.replace(MOVE, "m_x += m_vx * dt; if (1.0 + dt * 1e-20 > 1.0) m_x += 1.0;"): (r"; it decides a comparison \(at 24 Hz, row 1\)\.", 100.0, 1e6),
    }

    def test_what_rounding_does_is_said(self):
        cores = {header: traced(header) for header in self.HEADERS}
        for header, (says, low_px, high_px) in self.HEADERS.items():
            with self.subTest(says=says):
                outcome = cores[header].run("study", "frame-rate", "--quick", "--no-figures", "-o", self.folder)
                self.assertEqual(outcome.exit_code, AGREED, outcome)
                self.assertRegex(outcome.out, r"Rounding moves the fling by up to \S+ px \(at \d+ Hz, row \d+\).*" + says)
                self.assertTrue(low_px < float(re.search("by up to (.*) px", outcome.out)[1]) < high_px, outcome.out)


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

    def test_ends_of_flings(self):
        begin = numpy.concatenate([[[100.0], [100.0], [900.0], [-1200.0]], flings.starts(100)], axis=1)
        for core, laws in CORES.items():
            ends = self.rows(core, "frame-rate", "ends")
            for rate_hz in (24.0, 60.0, 144.0):
                played = flings.Flings(begin, laws, rate_hz).play(16.0)
                before = played.x.copy(), played.y.copy(), played.vx.copy(), played.vy.copy()
                time_s = played.anchor_s
                played.step()
                changed = [(abs(now - then) > 1e-9 * abs(then)).sum() for now, then in zip((played.x, played.y, played.vx, played.vy), before)]
                self.assert_numbers(ends["paper", "steady", rate_hz], settled=101, time_BAND_s=time_s, moves_px=0.0, x_changes=changed[0], y_changes=changed[1],
                                    vx_changes=changed[2], vy_changes=changed[3])

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

    def test_bounces_without_loss(self):
        scenario = "scenarios/hard/a-fling-a-minute.json"
        cases = [{case["case"]: case["invariants"] for case in studied(core, "hard-cases", scenario).json["cases"]} for core in CORES]
        start = json.loads((SOURCE / scenario).read_text(encoding="utf-8"))
        thrown = numpy.array([[600.0, 500.0, event["fling"]["vx_px_per_s"], event["fling"]["vy_px_per_s"]] for event in start["events"]]).T
        gravity = numpy.repeat([laws.gravity for laws in CORES.values()], thrown.shape[1])  # Flings of all cores at once.
        for rate_hz in (24, 144):
            played = flings.Flings(numpy.tile(thrown, len(CORES)), flings.Laws(gravity, 1.0, 1.0, 1.0, 0.0), float(rate_hz))
            begin = played.energy()
            for of_core, all_kept in zip(cases, numpy.split(played.play(600.0).energy() / begin, len(CORES))):
                for number, kept in enumerate(all_kept, 1):
                    row = of_core[f"a-fling-a-minute/lossless-{number}-{rate_hz}-hz"]["keeps-energy"]
                    self.assertAlmostEqual(row["margin"], kept - 0.5, delta=1e-9)


if __name__ == "__main__":
    main()
