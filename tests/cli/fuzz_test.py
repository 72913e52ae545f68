"""fuzz: random scenarios, parts of them, another program, bad options. HYRAX_ALTERED_SIM is a
hyrax-sim with altered cores; must_fail/fuzz_test.py has what it finds."""

import os
import re

from process import run
from program import AGREED, PROGRAM, ProgramTest


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

    def first_failure(self, *options):
        """The first run in which a core that differs on bounds only breaks a rule."""
        outcome = run(os.environ["HYRAX_ALTERED_SIM"], "fuzz", "--runs", "1000", "--json", *options, cwd=self.folder,
                      env={**os.environ, "HYRAX_ALTERED_CORE": "ground_not_strict"})
        failure, = outcome.json["failures"]
        self.assertIn(f", {failure['steps_before']} frames: breaks ", (self.folder / failure["scenario"]).read_text())
        return failure["run"]

    def test_another_program_that_does_not_end_is_not_waited_for(self):
        (self.folder / "other").write_text(f'#!/bin/sh\nmkdir asked 2>&- && exec {PROGRAM} "$@"\nexec sleep 600\n')
        (self.folder / "other").chmod(0o755)
        outcome = self.expect(AGREED, "fuzz", "--time", "0.4s", "--against", "./other", says="not compared: ")
        self.assertIn("which ./other did not end in the time that was left", outcome.err)
        self.assertIn("all invariants hold, the state hashes that were compared agree\n", outcome.out)
