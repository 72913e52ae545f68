"""fuzz: random scenarios, parts of them, rules left out, and what went. HYRAX_ALTERED_SIM is a
hyrax-sim with altered cores; must_fail/fuzz_test.py has what it finds."""

import os
import re

from process import run
from program import AGREED, BAD_INPUT, ProgramTest


class Fuzz(ProgramTest):
    def fuzz(self, *options, **arguments):
        """Without a failure: the document."""
        return self.expect(AGREED, "fuzz", "--json", *options, **arguments).json

    def test_no_rule_is_broken_in_many_runs_and_nothing_is_written(self):
        document = self.fuzz("--runs", "2500", "--seed", str(2 ** 64 - 1))
        self.assertEqual((document["seed"], document["runs"], document["failures"]), (2 ** 64 - 1, 2500, []))
        self.assertEqual(self.names(), [])

    def test_a_time_ends_it(self):
        for time, seconds in (("0.03", 0.03), ("0.03s", 0.03), ("0.001m", 0.06), ("0.00002h", 0.072)):
            document = self.fuzz("--time", time)
            self.assertGreater(document["runs"], 0)
            self.assertTrue(seconds <= document["elapsed_s"] < 20, document)

    def test_the_text_says_how_fast_it_is(self):
        said = self.expect(AGREED, "fuzz", "--time", "0.2s").out
        self.assertTrue(said.startswith("seed 1\n"), said)  # Before the runs: one that crashes is played again by it.
        runs, seconds, per_minute = map(float, re.search(r"(\d+) runs in (\S+) s \((\S+) per minute", said.replace(",", "")).groups())
        self.assertAlmostEqual(per_minute / (60 * runs / seconds), 1, delta=0.3)  # 0.2 s is printed with one digit.

    def test_parts_are_a_partition(self):
        runs = [self.fuzz("--runs", "100", "--part", f"{index}/3") for index in range(3)]
        self.assertEqual([document["runs"] for document in runs], [34, 33, 33])
        self.assertEqual(runs[1]["part"], {"index": 1, "count": 3})
        self.assertEqual(self.fuzz("--runs", "2", "--part", "2/3")["runs"], 0)
        self.assertEqual(self.expect(AGREED, "fuzz", "--runs", "2", "--part", "2/3", "-q").out, "nothing was tested\n")
        firsts = [self.first_failure("--part", f"{index}/3") for index in range(3)]
        self.assertEqual([first % 3 for first in firsts], [0, 1, 2])
        self.assertEqual(min(firsts), self.first_failure())
        self.assertNotIn(0, firsts, "any core fails there")
        self.assertEqual(len(self.names()), 4, "a failing scenario replaces no file, that of the same run either")

    def test_without_the_rules_that_a_core_breaks_it_finds_none(self):
        self.assertEqual(self.fuzz("--runs", "2", "--without", "mirror")["without"], ["mirror"])
        outcome = self.fuzz_altered("--without", "listing", "--without", "mirror")
        self.assertEqual((outcome.exit_code, outcome.json["failures"]), (AGREED, []))

    def fuzz_altered(self, *options):
        """By a core that differs on bounds only."""
        return run(os.environ["HYRAX_ALTERED_SIM"], "fuzz", "--runs", "1000", "--json", *options, cwd=self.folder,
                   env={**os.environ, "HYRAX_ALTERED_CORE": "ground_not_strict"})

    def first_failure(self, *options):
        """The first run in which that core breaks a rule."""
        failure, = self.fuzz_altered(*options).json["failures"]
        self.assertIn(f", {failure['steps_before']} frames: breaks ", (self.folder / failure["scenario"]).read_text())
        return failure["run"]

    def test_removed_options_are_refused_with_what_to_use_instead(self):
        instead = "was removed; `hyrax-sim shrink SCENARIO -o SMALL.json` keeps what `run` says of SCENARIO"
        for says, *command in (("was removed; `hyrax-sim check --core` judges another core", "fuzz", "--against", "x"),
                               (instead, "shrink", "a.json", "--fails", "test {}"), (instead, "shrink", "a.json", "--against", "x")):
            self.expect(BAD_INPUT, *command, says=f"hyrax-sim {command[0]}: {command[-2]}: {says}")
