"""Where arithmetic is not strict IEEE-754, nothing is computed: exit 5, found at start.

HYRAX_DISTURBED_ARITHMETIC names the library that changes it, disturbed_arithmetic.c.
"""

import os

from process import preloading
from program import AGREED, NOT_STRICT, ProgramTest

LIBRARY = os.environ["HYRAX_DISTURBED_ARITHMETIC"]


class Disturbed(ProgramTest):
    """The program, with a library in its process that changed the arithmetic before main."""

    def disturbed(self, how):
        """The environment in which it runs."""
        return {**os.environ, **preloading(LIBRARY), "HYRAX_DISTURBED": how}

    def setUp(self):
        super().setUp()
        self.project("fling")
        self.write("fling.h5", "what was there before")
        self.before = self.state_of(".")
        if self.hyrax_sim("--version", env=self.disturbed("flush")).exit_code == 77:
            self.skipTest("no way is known here to flush subnormals to zero")

    def test_every_command_that_computes_refuses_and_touches_nothing(self):
        for how, fault in (("flush", "subnormal numbers are flushed to zero"), ("round", "not rounded to nearest")):
            for arguments in (("run", "scenarios/fling.json"), ("check",),
                              ("bless", "scenarios", "--reason", "x"), ("diff", "golden/fling.h5", "golden/fling.h5"),
                              ("validate", "scenarios")):
                outcome = self.expect(NOT_STRICT, *arguments, env=self.disturbed(how), says=("hyrax-sim: ", fault))
                self.assertEqual(outcome.out, "")
                self.assertEqual(outcome.err.count("\n"), 1)
        self.assertEqual(self.state_of("."), self.before)
        self.write("scenarios/bad.json", "{")  # It is the most serious outcome.
        self.expect(NOT_STRICT, "check", "scenarios", "none.json", env=self.disturbed("flush"))

    def test_help_version_and_info_work_all_the_same(self):
        for how in ("flush", "round"):
            for arguments in (("--help",), ("--version",), ("run", "--help"), ("info", "--json")):
                self.expect(AGREED, *arguments, env=self.disturbed(how))
        text = self.expect(AGREED, "info", env=self.disturbed("flush")).out
        self.assertRegex(text, r"self_test +subnormal numbers are flushed to zero")

    def test_an_undisturbed_process_with_the_library_computes(self):
        self.expect(AGREED, "check", env=self.disturbed("not at all"))
