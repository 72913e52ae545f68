#!/usr/bin/python3
"""`study rest`: the map of final states, and the boundaries that divide it."""

import h5py
import numpy

from program import AGREED, BAD_INPUT, SOURCE, ProgramTest, main

# drag * gravity over a step's gain, at thresholds over restitution 5 / 0.6: the paper's constants.
KEPT = 0.999 * 0.6
BOUNDARIES_HZ = [0.999 * 1200 * 0.6 / 5 * factor for factor in (1, 1 / (1 + KEPT), 1 - KEPT)]


class Rest(ProgramTest):
    """The study and its files."""

    def study(self, *arguments):
        """Runs the quick study without figures; its output goes into out/."""
        return self.expect(AGREED, "study", "rest", "--quick", "--no-figures", "--gate", "-o", "out", *arguments)

    def test_boundaries_are_where_theory_has_them(self):
        for entry, rate_hz in zip(self.study("--json").json["boundaries"], BOUNDARIES_HZ, strict=True):
            self.assertAlmostEqual(entry["measured_hz"], rate_hz, delta=1e-6)
            self.assertTrue(entry["agrees"])

    def test_each_region_of_the_map_has_its_ends(self):
        self.study()
        with h5py.File(self.folder / "out/rest.h5") as file:
            table = {name: file[f"final_states/{name}"][:] for name in ("rate", "rest", "cycle", "buzz", "moving")}
        rate = table["rate"]
        self.assertTrue((table["moving"] == 0).all())
        rest, buzz_below, cycle_above = BOUNDARIES_HZ
        self.assertTrue((table["rest"][rate > rest] > 0).all())
        self.assertTrue((table["rest"][rate < rest] == 0).all())
        self.assertTrue((table["buzz"][rate > buzz_below] == 0).all())
        self.assertTrue((table["cycle"][rate < cycle_above] == 0).all())
        both = (rate > cycle_above + 1) & (rate < buzz_below - 10)
        self.assertTrue((table["buzz"][both] > 0).any() and (table["cycle"][both] > 0).any())

    def test_a_bounce_keeps_more_the_later_it_is_seen(self):
        self.study()
        with h5py.File(self.folder / "out/rest.h5") as file:
            rate, phase, kept = (file[f"bounces/{name}"][:] for name in ("rate", "phase", "restitution"))
        for rate_hz in numpy.unique(rate):
            here = rate == rate_hz
            order = numpy.argsort(phase[here])
            self.assertTrue((numpy.diff(kept[here][order]) > 0).all(), rate_hz)
        spread = {rate_hz: numpy.ptp(kept[rate == rate_hz]) for rate_hz in (30.0, 60.0)}
        self.assertAlmostEqual(spread[30.0] / spread[60.0], 2.0, delta=0.2)

    def test_the_verdict_is_one_screen_in_plain_terms(self):
        text = self.study().out
        for part in ("The position stands still", "zero speed above, two-cycle below", "143.856000", "agrees",
                     "residual speed, %", "effective restitution"):
            self.assertIn(part, text)
        self.assertNotIn("buzz", text)
        self.assertLessEqual(len(text.splitlines()), 40)

    def test_three_pictures(self):
        self.expect(AGREED, "study", "rest", "--quick", "-o", "out")
        self.assertEqual([name for name in self.names("out") if name.endswith(".svg")],
                         ["rest-restitution.svg", "rest-time.svg", "rest.svg"])
        picture = (self.folder / "out/rest.svg").read_text(encoding="utf-8")
        for text in ("143.86", "The position stands still in all three", "residual speed", "two-cycle", "zero speed"):
            self.assertIn(text, picture)

    def test_scenarios_are_refused(self):
        self.expect(BAD_INPUT, "study", "rest", SOURCE / "scenarios/hard/rest.json", says="takes no scenarios")


if __name__ == "__main__":
    main()
