"""Threads, in a build with the thread sanitizer: `check --jobs` has no data race, and a program that has one is caught.

HYRAX_RACY names that program, racy.cpp.
"""

import os
import shutil

from process import run
from program import AGREED, SOURCE, ProgramTest, fling

RACY = os.environ["HYRAX_RACY"]
RACE_FOUND = 66  # The exit code of the sanitizer.


class Threads(ProgramTest):
    """Scenarios of every kind of verdict, checked by many threads."""

    def setUp(self):
        super().setUp()
        self.project(*(f"n{number}" for number in range(24)))
        for number in range(0, 24, 4):
            (self.folder / f"golden/n{number}.txt").unlink()  # Such a golden file is taken apart.
        self.write("scenarios/n1.json", fling(name="n1", start={"x_px": 0, "y_px": 0}))
        self.write("scenarios/n2.json", "{")
        shutil.copyfile(SOURCE / "tests/robustness/fuzz/found/golden/crash-in-heap-header.h5", self.folder / "golden/n3.h5")

    def test_check_of_every_verdict(self):
        one = self.hyrax_sim("check", "--json", "--jobs", "1")
        many = self.hyrax_sim("check", "--json", "--jobs", "8")
        self.assertNotIn("ThreadSanitizer", many.err)
        self.assertEqual((many.exit_code, many.out), (one.exit_code, one.out))

    def test_check_of_the_project_s_own_scenarios(self):
        outcome = self.expect(AGREED, "check", "--jobs", "4", cwd=SOURCE)
        self.assertEqual(outcome.err, "")

    def test_a_race_is_caught(self):
        self.assertIn("WARNING: ThreadSanitizer: data race", run(RACY, exit_code=RACE_FOUND).err)
