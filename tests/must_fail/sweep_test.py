#!/usr/bin/python3
"""A sweep by a program whose core is altered gives what that core gives, member by member: its kernels stand for the
listing alone."""

import h5py

from altered import altered_cores, run_altered
from program import AGREED, ProgramTest, fling, main

# One of each kind of change that a step or a setter can have; `ground_not_strict` differs on a bound alone.
CORES = ("gravity_stronger", "two_constants", "drag_before_gravity", "y_before_x", "ground_not_strict", "rest_not_strict",
         "friction_on_vy", "friction_none", "speed_limited", "bounds_without_sprite", "fling_adds", "reset_does_nothing")
EVENTS = [{"step": 20, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -800}}, {"step": 90, "stop": {}},
          {"step": 120, "resize": {"window": {"width_px": 900, "height_px": 700}}}]


class AlteredSweep(ProgramTest):
    """A few members, each against its own run."""

    def test_every_member_is_its_run(self):
        self.assertLessEqual(set(CORES), set(altered_cores()))
        base = fling(events=EVENTS, steps=300)
        # Some start on the floor, where comparisons on the bound decide.
        vary = {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/start/y_px": {"choice": [952, 500.25, 0]},
                "/start/vy_px_per_s": {"choice": [0, -700]}}
        sweep = self.write("sweep.json", {"format": "hyrax-sweep/1", "base": base, "members": 6, "seed": 3, "vary": vary,
                                          "keep": ["final", "contacts"]})
        members = [self.folder / f"member-{member}.json" for member in range(6)]
        for member, path in enumerate(members):
            self.expect(AGREED, "sweep", sweep, "--member", str(member), "-o", path)
        for core in ("none", *CORES):
            with self.subTest(core=core):
                out = self.folder / f"{core}.h5"
                outcome = run_altered(core, "sweep", self.folder / sweep, "-o", out)
                self.assertEqual(outcome.exit_code, AGREED, outcome)
                with h5py.File(out) as file:
                    columns = [file["members"][name][:].tolist() for name in ("x", "y", "vx", "vy", "contacts")]
                runs = run_altered(core, "run", *members, "--json", "-o", f"{self.folder}/{core}/").json["runs"]
                self.assertEqual(list(map(list, zip(*columns))),
                                 [[*entry["final"].values(), list(entry["contacts"].values())] for entry in runs])


if __name__ == "__main__":
    main()
