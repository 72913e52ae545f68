"""`fuzz` finds each altered core that breaks an invariant, and writes a small scenario that still fails; of other constants,
`check --core` says what changed, and `shrink` keeps the difference.

HYRAX_ALL_EDITS is set: all cores are tried, else some of them.
"""

import json
import os
import re
import shutil

from altered import ALTERED, ONLY_CONSTANTS, SAME_BITS, changed_steps, run_altered
from process import run
from program import AGREED, DISAGREED, PROGRAM, SOURCE, ProgramTest, fling

# What it does depends on the steps of other runs, so that no scenario shows it alone.
HIDDEN_STATE = {"hidden_state"}
RUNS = "30"  # Of tests/README.md.
TRIES_ALL = "HYRAX_ALL_EDITS" in os.environ
CORES_EVERY = 1 if TRIES_ALL else 6


class Fuzz(ProgramTest):
    """Each altered core."""

    def failure(self, outcome, core):
        """The one failure of the outcome, with the scenario that was written."""
        self.assertEqual(outcome.exit_code, DISAGREED, f"{core}: {outcome}")
        failure, = outcome.json["failures"]
        scenario = json.loads((self.folder / failure["scenario"]).read_text())
        self.assertIn(f"Run {failure['run']} of hyrax-sim fuzz --seed 1", scenario["description"])
        self.expect(AGREED, "validate", failure["scenario"])
        return failure

    def fuzz_altered(self, core, *options):
        """`fuzz` by the program with that core, in the test's folder."""
        return run_altered(core, "fuzz", "--json", "-o", core, *options, cwd=self.folder)

    def test_every_core_that_breaks_an_invariant_is_found_and_shrunk(self):
        for core in sorted(set(changed_steps()) - SAME_BITS - ONLY_CONSTANTS - HIDDEN_STATE)[::CORES_EVERY]:
            with self.subTest(core=core):
                failure = self.failure(self.fuzz_altered(core, "--runs", RUNS), core)
                self.assertTrue(failure["fails_again"])
                self.assertLessEqual(failure["steps"], 3)
                self.assertLessEqual(failure["events"], 1)
                small = self.folder / failure["scenario"]
                study = ("study", "hard-cases", small, "--gate", "--no-figures", "--json", "-o", self.folder / "study")
                case = run_altered(core, *study, exit_code=DISAGREED).json["cases"][0]  # Others are made from it.
                self.assertEqual(case["invariants"][failure["rule"]]["verdict"], "broken")
                self.expect(AGREED, *study)  # By the shipped core.

    def test_the_readme_counts_them(self):
        runs, cores, table = re.search(r"`fuzz --runs (\d+)` on each of the (\d+) \[altered cores\].*?\n\n((?:\|.*\n)+)",
                                       (SOURCE / "tests/README.md").read_text(encoding="utf-8"), re.DOTALL).groups()
        counts = [len(set(changed_steps()) - SAME_BITS - ONLY_CONSTANTS - HIDDEN_STATE), *map(len, (ONLY_CONSTANTS, SAME_BITS - {"none"}, HIDDEN_STATE))]
        self.assertEqual([runs, int(cores), *map(int, re.findall(r"\| (\d+) \|", table))], [RUNS, sum(counts), *counts])

    def test_no_other_core_breaks_one(self):
        for core in SAME_BITS | ONLY_CONSTANTS:
            with self.subTest(core=core):
                self.assertEqual(self.fuzz_altered(core, "--runs", "3000").exit_code, AGREED)

    def test_hidden_state_is_found_and_said_not_to_fail_again(self):
        failure = self.failure(self.fuzz_altered("hidden_state", "--runs", RUNS), "hidden_state")
        self.assertFalse(failure["fails_again"])

    def test_other_constants_break_no_invariant_and_are_found_by_check_and_by_shrink(self):
        shutil.copytree(SOURCE / "golden/core", self.folder / "golden/core")
        path = self.folder / self.write("scenarios/fling.json", fling(steps=600))
        for core in sorted(ONLY_CONSTANTS):
            with self.subTest(core=core):
                small = self.folder / f"{core}.json"
                outcome = run_altered(core, "shrink", path, "-o", small, "--json", exit_code=AGREED)
                self.assertEqual((outcome.json["kept"], outcome.json["complete"]), ("other bits than the accepted core's", True))
                self.assertLessEqual(outcome.json["after"]["steps"], 3)
                hashes = {run(program, "run", small, "--json", "-o", "run.h5", cwd=self.folder, env={**os.environ, "HYRAX_ALTERED_CORE": core})
                          .json["runs"][0]["state_hash"] for program in (PROGRAM, ALTERED)}
                self.assertEqual(len(hashes), 2, f"{core}: both programs agree on the shrunk scenario")
