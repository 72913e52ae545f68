#!/usr/bin/python3
"""Mutants of the core have all fates: a survivor is reported, and a broken build does not count as caught.

HYRAX_BUILD is a build of the project.
"""

import os
import pathlib
import re
import sys
import tempfile
import time
import unittest

from build_copy import BuildCopy, Verdict
from mutators import Mutant
from original_build import Build
from process import run
from program import SOURCE
from reasons import faults_of, read_reasons
from subjects import SUBJECTS, mutants_by_subject
from trials import batches_of

BUILD = pathlib.Path(os.environ["HYRAX_BUILD"])
TOOL = pathlib.Path(__file__).with_name("mutation.py")
CORE = SUBJECTS[0]
LINE = "m_x = rightBound;"


def change_of(line):
    """The core with another line where the right wall stops the sprite."""
    text = (SOURCE / CORE.path).read_text(encoding="utf-8")
    begin = text.index(LINE)
    return Mutant(CORE.path, "control", line, begin, begin + len(LINE), line)


class Fates(unittest.TestCase):
    """Each test is one change of the core."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="hyrax-test-")
        cls.addClassCleanup(folder.cleanup)
        cls.build = Build(SOURCE, BUILD, re.compile(r"unit\.physics"))
        cls.copy = BuildCopy(cls.build, pathlib.Path(folder.name), 60, time.monotonic() + 3600)
        by_subject = mutants_by_subject(cls.build)
        cls.everything = sum(by_subject.values(), [])
        cls.mutants = sum((mutants for (subject, _), mutants in by_subject.items() if subject.is_core), [])

    def fate(self, mutant, tests=()):
        """The verdict on a mutant, or on another line."""
        mutant = change_of(mutant) if isinstance(mutant, str) else mutant
        batches = batches_of(mutant, tests, dict.fromkeys((test.name for test in tests), 0.0))
        return self.copy.try_out(mutant, batches, CORE, "scenarios")

    def test_a_change_of_a_bit_is_caught_with_its_scenario_step_and_class(self):
        verdict = self.fate("m_x = std::nextafter(rightBound, 0.0);")
        self.assertEqual((verdict.fate, verdict.caught_by), ("caught", "check"))
        scenario, step, kind = verdict.difference.split()
        self.assertTrue((SOURCE / scenario).is_file(), verdict)
        self.assertGreater(int(step), 0)
        self.assertEqual(kind, "rounding")

    def test_a_change_without_effect_survives(self):
        self.assertEqual(self.fate("m_x = rightBound * 1.0;", self.build.tests), Verdict("survived"))

    def test_what_does_not_compile_is_not_caught(self):
        self.assertEqual(self.fate("m_x = rightBound").fate, "refused")

    def test_what_never_ends_hangs(self):
        self.assertEqual(self.fate("for (volatile bool again = true; again;) {}"), Verdict("caught", "check", "hangs"))

    def test_what_dies_crashes(self):
        self.assertEqual(self.fate("__builtin_trap();"), Verdict("caught", "check", "crashes"))

    def test_other_flags_are_caught(self):
        (fused,) = (mutant for mutant in self.mutants if mutant.path == CORE.path and mutant.flags)
        self.assertEqual(self.fate(fused).caught_by, "check")
        self.assertEqual(self.fate("m_x = rightBound * 1.0;"), Verdict("survived"), "the flags are left")

    def test_what_no_scenario_reaches_a_unit_test_catches(self):
        (unused,) = (mutant for mutant in self.mutants if mutant.name.endswith("-> physics() : physics(-0.0, 0.0) {}"))
        self.assertEqual(self.fate(unused).fate, "survived")
        self.assertEqual(self.fate(unused, self.build.tests), Verdict("caught", "unit.physics", "Failed"))

    def test_every_reason_is_of_a_mutant(self):
        self.assertEqual(faults_of(read_reasons(TOOL.with_name("reasons.json")), self.everything, {}), [])

    def test_every_mutant_has_a_unique_name(self):
        self.assertGreater(len(self.mutants), 600)
        self.assertEqual(len({(mutant.path, mutant.name) for mutant in self.mutants}), len(self.mutants))


class Tool(unittest.TestCase):
    """The tool as ctest calls it."""

    def run_tool(self, *options):
        """Exit code and standard output of a run for one mutant."""
        outcome = run(sys.executable, TOOL, "--build", BUILD, "--source", SOURCE, "--core", "--jobs", "1", "--only",
                      "physics.h: update: without m_vx .= AIR_DRAG", *options, timeout=900)
        return outcome.exit_code, outcome.out

    def test_a_survivor_fails_the_run(self):
        exit_code, said = self.run_tool("--scenarios", "tests/must_fail/mutation/scenarios")
        self.assertEqual(exit_code, 1)
        self.assertIn("Score: 0 of 1 caught", said)
        self.assertRegex(said, r"FAULT: sim/physics/physics\.h:\d+: update: without m_vx \*= AIR_DRAG;: survived; add a test")

    def test_without_scenarios_nothing_is_reported_as_caught(self):
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            exit_code, said = self.run_tool("--scenarios", folder)
        self.assertEqual(exit_code, 3)
        self.assertNotIn("caught", said)


if __name__ == "__main__":
    unittest.main()
