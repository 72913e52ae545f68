"""hyrax-replay.exe check: the cases of the build for this machine, under Wine."""

from hyrax_program import HYRAX_REPLAY, HyraxTest
from replay_check import ReplayCheckCases


class Check(ReplayCheckCases, HyraxTest):
    def run_replay(self, *arguments, **options):
        return self.wine.run(HYRAX_REPLAY, *arguments, **{"cwd": self.folder, **options})
