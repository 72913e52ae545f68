#!/usr/bin/python3
"""A sweep by a program whose core is altered gives what that core gives, member by member: its kernels stand for the
listing alone."""

import h5py

from altered import altered_cores, run_altered
from program import AGREED, ProgramTest, fling, main

# Constants, the order and the kind of statements, a bound alone, a setter.
CORES = ("two_constants", "drag_before_gravity", "ground_not_strict", "speed_limited", "fling_adds")
# The last throw leaves the threshold of rest, to the bit.
EVENTS = [{"step": 20, "fling": {"vx_px_per_s": 200, "vy_px_per_s": -800}}, {"step": 90, "stop": {}},
          {"step": 120, "resize": {"window": {"width_px": 1400, "height_px": 700}}},
          {"step": 298, "fling": {"vx_px_per_s": 50, "vy_px_per_s": -11.658324991658324}}]


class AlteredSweep(ProgramTest):
    """A few members, each against its own run."""

    def test_every_member_is_its_run(self):
        self.assertLessEqual(set(CORES), set(altered_cores()))
        base = fling(events=EVENTS, steps=300)
        # Some start on the floor, where comparisons on the bound decide: gravity takes 20 px/s in a step.
        vary = {"/start/vx_px_per_s": {"uniform": [-4000, 4000]}, "/start/y_px": {"choice": [952, 500.25]},
                "/start/vy_px_per_s": {"choice": [-20, -700]}}
        sweep = self.write("sweep.json", {"format": "hyrax-sweep/1", "base": base, "members": 6, "seed": 2, "vary": vary,
                                          "keep": ["final", "contacts"]})
        members = [self.folder / f"member-{member}.json" for member in range(6)]
        for member, path in enumerate(members):
            self.expect(AGREED, "sweep", sweep, "--member", str(member), "-o", path)
        shipped = None
        for core in ("none", *CORES):
            with self.subTest(core=core):
                out = self.folder / f"{core}.h5"
                outcome = run_altered(core, "sweep", self.folder / sweep, "-o", out)
                self.assertEqual(outcome.exit_code, AGREED, outcome)
                with h5py.File(out) as file:
                    columns = [file["members"][name][:].tolist() for name in ("x", "y", "vx", "vy", "contacts")]
                runs = run_altered(core, "run", *members, "--json", "-o", f"{self.folder}/{core}/").json["runs"]
                found = list(map(list, zip(*columns)))
                self.assertEqual(found, [[*entry["final"].values(), list(entry["contacts"].values())] for entry in runs])
                shipped = found if core == "none" else shipped
                self.assertEqual(found == shipped, core == "none", "no member shows what is altered")


if __name__ == "__main__":
    main()
