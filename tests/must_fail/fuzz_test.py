#!/usr/bin/python3
"""`fuzz` finds each altered core that breaks an invariant, and any other one against the shipped core; what it writes
is a small scenario that still fails.

HYRAX_ALL_EDITS is set: all cores are tried, else some of them.
"""

import json
import os
import re
import shlex

from altered import ALTERED, ONLY_CONSTANTS, SAME_BITS, changed_steps, run_altered
from process import run
from program import AGREED, DISAGREED, PROGRAM, SOURCE, ProgramTest, main

# What it does depends on the steps of other runs, so that no scenario shows it alone.
HIDDEN_STATE = {"hidden_state"}
RUNS = "30"  # Of tests/README.md.
TRIES_ALL = "HYRAX_ALL_EDITS" in os.environ
CORES_EVERY = 1 if TRIES_ALL else 6
# Each by another rule or operation.
SOME_AGAINST = ("gravity_by_one_ulp", "rest_earlier", "friction_none", "two_constants", "ground_not_strict", "y_sees_x")


class Fuzz(ProgramTest):
    """Each altered core."""

    def failure(self, outcome, core):
        """The one failure of the outcome, with the scenario that was written."""
        self.assertEqual(outcome.exit_code, DISAGREED, f"{core}: {outcome}")
        failure, = outcome.json["failures"]
        scenario = json.loads((self.folder / failure["scenario"]).read_text())
        self.assertIn(f"Run {failure['run']} of hyrax-sim fuzz --seed 1", scenario["description"])
        self.assertEqual(run(PROGRAM, "validate", failure["scenario"], cwd=self.folder).exit_code, AGREED)
        return failure

    def fuzz_altered(self, core, *options):
        """`fuzz` by the program with that core, in the test's folder."""
        return run(ALTERED, "fuzz", "--json", "-o", core, *options, cwd=self.folder,
                   env={**os.environ, "HYRAX_ALTERED_CORE": core})

    def test_every_core_that_breaks_an_invariant_is_found_and_shrunk(self):
        for core in sorted(set(changed_steps()) - SAME_BITS - ONLY_CONSTANTS - HIDDEN_STATE)[::CORES_EVERY]:
            with self.subTest(core=core):
                failure = self.failure(self.fuzz_altered(core, "--runs", RUNS), core)
                self.assertTrue(failure["fails_again"])
                self.assertLessEqual(failure["steps"], 3)
                self.assertLessEqual(failure["events"], 1)
                small = self.folder / failure["scenario"]
                study = run_altered(core, "study", "hard-cases", small, "--gate", "--no-figures", "--json", "-o",
                                    self.folder / "study")
                self.assertEqual(study.exit_code, DISAGREED, core)
                case = study.json["cases"][0]  # Others are made from it.
                self.assertIn(case["invariants"][failure["rule"]]["verdict"], ("broken",))
                shipped = run(PROGRAM, "study", "hard-cases", small, "--gate", "--no-figures", "--json", "-o",
                              self.folder / "study", cwd=SOURCE)
                self.assertEqual(shipped.exit_code, AGREED, f"{core}: the shipped core fails, too")

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

    def wrapper(self, core):
        """A program that is the altered core, whatever the environment says."""
        path = self.folder / f"program-{core}"
        path.write_text(f'#!/bin/sh\nHYRAX_ALTERED_CORE={core} exec {shlex.quote(str(ALTERED))} "$@"\n')
        path.chmod(0o755)
        return path

    def test_against_the_shipped_core_any_change_of_bits_is_found_and_shrunk(self):
        cores = sorted(set(changed_steps()) - SAME_BITS - HIDDEN_STATE) if TRIES_ALL else SOME_AGAINST
        for core in cores:
            with self.subTest(core=core):
                outcome = run(PROGRAM, "fuzz", "--runs", "5000", "--json", "--against", self.wrapper(core), "-o", core,
                              cwd=self.folder)
                failure = self.failure(outcome, core)
                self.assertEqual(failure["rule"], "state-hash")
                self.assertLessEqual(failure["steps"], 3)
                hashes = {self.state_hash(program, failure["scenario"]) for program in (PROGRAM, self.wrapper(core))}
                self.assertEqual(len(hashes), 2, f"{core}: both programs agree on the shrunk scenario")

    def test_a_program_that_crashes_differs(self):
        """It crashes on folders with a scenario that has a grab; which one is found by playing each alone."""
        path = self.folder / "crashes"
        path.write_text(f'#!/bin/sh\ngrep -rq grab "$2" && kill -SEGV $$\nexec {shlex.quote(str(PROGRAM))} "$@"\n')
        path.chmod(0o755)
        outcome = run(PROGRAM, "fuzz", "--runs", "40", "--json", "--against", path, cwd=self.folder)
        failure = self.failure(outcome, "a crash")
        self.assertIn("signal 11 (exit code 139) there", failure["found"])
        self.assertEqual((failure["steps"], failure["events"]), (1, 1))

    def state_hash(self, program, scenario):
        outcome = run(program, "run", scenario, "--json", "-o", "run.h5", cwd=self.folder)
        return outcome.json["runs"][0]["state_hash"]


if __name__ == "__main__":
    main()
