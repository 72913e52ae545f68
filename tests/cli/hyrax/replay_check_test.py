#!/usr/bin/python3
"""hyrax-replay.exe check: the cases of the build for this machine, under Wine."""

import unittest

from hyrax_program import HYRAX_REPLAY, HyraxTest
from process import skip_without
from replay_check import ReplayCheckCases


class Check(ReplayCheckCases, HyraxTest):
    def run_replay(self, *arguments, **options):
        return self.wine.run(HYRAX_REPLAY, *arguments, **{"cwd": self.folder, **options})


if __name__ == "__main__":
    skip_without("wine")
    unittest.main()
