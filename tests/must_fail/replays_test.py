#!/usr/bin/python3
"""No run is played twice: counts the updates of a program."""

import os
import re

from altered import ALTERED
from process import run
from program import ProgramTest, fling, main

STEPS = 3000


class Replays(ProgramTest):
    """The listing, as a core that counts its updates."""

    def updates(self, *arguments):
        """How many updates `hyrax-sim ARGUMENTS` makes."""
        environment = {**os.environ, "HYRAX_ALTERED_CORE": "none", "HYRAX_COUNT_UPDATES": "1"}
        outcome = run(ALTERED, *arguments, cwd=self.folder, env=environment)
        self.assertEqual(outcome.exit_code, 0, outcome)
        return int(re.search(r"^updates: (\d+)$", outcome.err, re.MULTILINE).group(1))

    def scenario(self):
        """A run that never repeats, which bounds an error against the reference."""
        return self.write("fling.json", fling(steps=STEPS, expect={"implementation_px_max": 1e-3}, clock={
            "rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 7}}))

    def test_a_run_is_played_once_for_all_outputs(self):
        for options in ((), ("--figure", "fling.svg"), ("--drift",), ("--drift", "--rows", "--figure", "fling.svg"),
                        ("--drift", "--reference", "gsl"), ("-o", "fling.csv", "--drift")):
            with self.subTest(options=options):
                self.assertEqual(self.updates("run", self.scenario(), *options), STEPS)

    def test_a_second_replay_would_be_counted(self):
        self.assertGreaterEqual(self.updates("drift", self.scenario()), STEPS + 1000)


if __name__ == "__main__":
    main()
