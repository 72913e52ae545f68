#!/usr/bin/python3
"""`study subnormals`: where vx ends on the floor, and what a step costs then."""

import math

import h5py

from program import AGREED, ProgramTest, main

UNIT = 5e-324


def steps_to_subnormal(start):
    """Steps on the floor, each by the factor 0.999 * 0.8."""
    return math.log(start / 2.2250738585072014e-308) / -math.log(0.999 * 0.8)


class Subnormals(ProgramTest):
    """The study and its files."""

    def study(self, *arguments):
        """Runs the quick study without figures; its output goes into out/."""
        return self.expect(AGREED, "study", "subnormals", "--quick", "--no-figures", "--gate", "-o", "out", *arguments)

    def test_vx_ends_at_two_units_of_the_last_place_at_every_rate(self):
        for end in self.study("--json").json["ends"]:
            self.assertEqual(abs(end["stuck_vx_px_per_s"]), 2 * UNIT, end)
            self.assertEqual(end["moves_px"], 0)
            self.assertAlmostEqual(end["subnormal_after_s"], end["subnormal_from_row"] / end["rate_hz"], delta=1e-9)
            # From a speed that the walls and the first contacts leave, between 1 and 900 px/s.
            self.assertGreater(end["subnormal_from_row"], steps_to_subnormal(1))
            # Then 52 binades down to the last place, less the last few in which rounding already gives back.
            down = end["stuck_from_row"] - end["subnormal_from_row"]
            self.assertAlmostEqual(down, 51 * math.log(2) / -math.log(0.999 * 0.8), delta=5)

    def test_costs_are_intervals_relative_to_vx_0(self):
        costs = self.study("--json").json["costs"]
        self.assertEqual(len(costs), 5)
        if costs[0]["cost_ns"] is None:
            self.skipTest("the clock is not steady")
        for cost in costs:
            self.assertGreater(cost["cost_low_ns"], 0)
            self.assertLessEqual(cost["cost_low_ns"], cost["cost_ns"])
            self.assertLessEqual(cost["cost_ns"], cost["cost_high_ns"])
            self.assertLessEqual(cost["ratio_low"], cost["ratio"])
            self.assertLessEqual(cost["ratio"], cost["ratio_high"])
            if cost["with"] == "vx = 0":
                self.assertEqual((cost["ratio_low"], cost["ratio"], cost["ratio_high"]), (1, 1, 1))

    def test_tables_and_text(self):
        self.assertIn("vx of a fling never becomes 0; it is stuck at 9.881e-324 px/s or less", self.study().out)
        with h5py.File(self.folder / "out/subnormals.h5") as file:
            self.assertLessEqual({"ends", "costs"}, set(file))


if __name__ == "__main__":
    main()
