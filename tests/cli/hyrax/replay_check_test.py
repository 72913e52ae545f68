#!/usr/bin/python3
"""hyrax-replay.exe check: the cases of the build for this machine, and the library of scenarios."""

import unittest

from hyrax_program import HYRAX_REPLAY, HyraxTest
from process import skip_without
from program import AGREED, SOURCE
from replay_check import ReplayCheckCases


class Check(ReplayCheckCases, HyraxTest):
    def run_replay(self, *arguments):
        return self.wine.run(HYRAX_REPLAY, *arguments, cwd=self.folder)

    def test_the_library_of_scenarios_agrees(self):
        found = self.wine.run(HYRAX_REPLAY, "check", cwd=SOURCE)
        count = len(list((SOURCE / "scenarios").rglob("*.json")))
        self.assertEqual((found.exit_code, found.out),
                         (AGREED, f"{count} checked: {count} agreed, 0 disagreed, 0 without golden file, 0 failed\n"))


if __name__ == "__main__":
    skip_without("wine")
    unittest.main()
