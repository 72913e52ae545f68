"""Memory that commands use again: page faults, which are counted and not timed, do not grow with what is played."""

import json
import shutil

from process import run_measured
from program import AGREED, SOURCE, ProgramTest, fling

FLING = SOURCE / "scenarios/flings/first-fling.json"
JITTERED = ("--set", '/clock/jitter={"kind": "uniform", "fraction": 0.1, "seed": 1}', "--set", "/expect={}")


class PageFaults(ProgramTest):
    def expect_at_most(self, most, *arguments):
        _, _, faults = run_measured(self.program, *arguments, cwd=self.folder, exit_code=AGREED)
        self.assertLess(faults, most, arguments)

    def test_of_rows_that_are_written_and_compared(self):
        self.expect_at_most(5_000, "run", FLING, "--set", "/steps=1000000", *JITTERED, "-o", "long.h5")
        self.expect_at_most(5_000, "run", FLING, "--set", "/steps=400000", *JITTERED, "-o", "a.h5")
        shutil.copy(self.folder / "a.h5", self.folder / "b.h5")
        self.expect_at_most(8_000, "diff", "a.h5", "b.h5")

    def test_of_members_and_random_runs(self):
        sweep = {"format": "hyrax-sweep/1", "base": fling(steps=30), "members": 1_000_000, "seed": 1,
                 "vary": {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}}, "keep": ["final"]}
        (self.folder / "sweep.json").write_text(json.dumps(sweep), encoding="utf-8")
        for threads, most in ("1", 6_000), ("2", 8_000):
            self.expect_at_most(most, "sweep", "sweep.json", "-o", f"{threads}.h5", "--threads", threads)
        self.expect_at_most(2_500, "fuzz", "--runs", "2000", "--seed", "1")
