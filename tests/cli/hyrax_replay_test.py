"""hyrax-replay: the hash of every row, on every target that can be built for."""

import os

from process import preloading, run
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, NOT_STRICT, SOURCE, ProgramTest, fling
from replay_check import ReplayCheckCases

REPLAY = os.environ["HYRAX_REPLAY"]
DISTURBED_ARITHMETIC = os.environ["HYRAX_DISTURBED_ARITHMETIC"]


class HyraxReplay(ProgramTest):
    """The console twin, by its exit code and its output."""

    def replay(self, exit_code, *arguments, says="", **options):
        """Runs hyrax-replay in the folder; expects this exit code, and `says` on stderr."""
        outcome = run(REPLAY, *arguments, cwd=self.folder, **options)
        self.assertEqual(outcome.exit_code, exit_code, str(outcome))
        self.assertIn(says, outcome.err)
        return outcome

    def test_what_a_terminal_obeys_is_escaped_and_with_one_bad_scenario_the_others_still_run(self):
        self.write("a\x1b[31m.json", "{")
        self.write("b\x1b[31m.json", fling(name="fling"))
        outcome = self.replay(BAD_INPUT, ".", says="./a\\u001b[31m.json: line 1")
        self.assertIn("./b\\u001b[31m.json\n", outcome.out)
        self.assertNotIn("\x1b", outcome.out + outcome.err)

    def test_the_hash_is_compared_with_the_expected_one(self):
        other = "0" * 32
        found = self.replay(DISAGREED, self.write("fling.json", fling(expect={"state_hash": other}))).out.split()[0]
        self.replay(DISAGREED, "fling.json", says=f"fling.json: /expect/state_hash: differs from the run (found {other}); the run has {found}\n")
        self.assertEqual(self.replay(AGREED, self.write("fling.json", fling(expect={"state_hash": found}))).out, f"{found}  fling.json\n")

    def test_help_and_version(self):
        self.assertEqual(self.replay(AGREED, "fling.json", "--help").out, (SOURCE / "tools/hyrax-replay/help.txt").read_text())
        info = self.expect(AGREED, "info").out.splitlines()
        self.assertEqual([line.split(maxsplit=1) for line in self.replay(AGREED, "--version").out.splitlines()],
                         [line.split(maxsplit=1) for line in info[:5]])

    def test_bad_usage_is_reported(self):
        self.replay(BAD_INPUT, "", says="hyrax-replay: SCENARIO: must not be empty")
        self.replay(BAD_INPUT, "check", "", says="hyrax-replay check: SCENARIO or DIR: must not be empty; see `hyrax-replay --help`")
        self.replay(BAD_INPUT, "check", "--golden", "", says="hyrax-replay check: --golden: must not be empty; see")
        self.replay(BAD_INPUT, "--", says="SCENARIO is missing")
        for path in ("--help", "--"):
            self.replay(CANNOT_ACCESS, "--", path, says=f"{path}: cannot be read")
        self.replay(CANNOT_ACCESS, "none.json", says="none.json: cannot be read")
        self.replay(BAD_INPUT, ".", says=".: no scenario found")

    def test_disturbed_arithmetic_is_refused(self):
        path = self.write("fling.json", fling())
        for how, fault in (("flush", "flushed to zero"), ("round", "not rounded to nearest")):
            environment = {**os.environ, **preloading(DISTURBED_ARITHMETIC), "HYRAX_DISTURBED": how}
            self.assertEqual(self.replay(NOT_STRICT, path, says=fault, env=environment).out, "")
            self.assertEqual(self.replay(NOT_STRICT, "check", path, says=fault, env=environment).out, "")
            self.replay(AGREED, "--help", env=environment)


class Check(ReplayCheckCases, ProgramTest):
    def run_replay(self, *arguments, **options):
        return run(REPLAY, *arguments, **{"cwd": self.folder, **options})
