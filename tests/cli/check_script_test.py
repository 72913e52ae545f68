#!/usr/bin/python3
"""tools/check builds hyrax-sim and passes on its verdict; --watch repeats that after a change. What tools/run refuses.

Runs a copy of the scripts in a project whose build folder has a ninja file of one target: it copies the program.
"""

import os
import re
import signal
import time

from process import Process, run, skip_unless_installed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, PROGRAM, SOURCE, ProgramTest, fling, main


class CheckScript(ProgramTest):
    """A project with a build folder that is configured."""

    def setUp(self):
        skip_unless_installed("ninja")
        super().setUp()
        self.scenario, = self.project("one")
        for script in ("check", "setup.sh"):
            self.write(f"tools/{script}", (SOURCE / "tools" / script).read_text())
        (self.folder / "tools/check").chmod(0o755)
        self.write("CMakeLists.txt", "")
        self.write("sim/source.txt", "1")
        self.write("build/tools/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder.resolve()}\n")
        self.write_build(f"cp {PROGRAM} bin/hyrax-sim")

    def write_build(self, command):
        """A command makes the program whenever sim/source.txt has changed."""
        self.write("build/tools/build.ninja",
                   f"rule make\n  command = {command}\nbuild bin/hyrax-sim: make ../../sim/source.txt\n"
                   "build hyrax-sim: phony bin/hyrax-sim\n")

    def check(self, *arguments):
        """Runs the script."""
        return run("tools/check", *arguments, cwd=self.folder)

    def test_help_builds_nothing(self):
        done = self.check("--help")
        self.assertEqual((done.exit_code, done.err), (0, ""))
        for part in ("--watch", "Ctrl-C", "Exit code"):
            self.assertIn(part, done.out)
        self.assertFalse((self.folder / "build/tools/bin").exists())

    def test_it_builds_then_checks(self):
        first = self.check()
        self.assertEqual(first.exit_code, AGREED, first)
        self.assertIn("build hyrax-sim", first.err)
        self.assertIn("1 agreed", first.out)
        again = self.check(self.scenario)
        self.assertEqual((again.exit_code, again.err), (AGREED, ""), "up to date: nothing is built")
        self.assertEqual(again.out, first.out)

    def test_its_exit_code_is_that_of_check(self):
        self.write(self.scenario, fling(name="one", steps=299))
        done = self.check("--golden", "golden")
        self.assertEqual(done.exit_code, DISAGREED, done)
        self.assertIn("0 agreed, 1 disagreed", done.out)

    def test_a_build_that_fails_is_exit_3(self):
        self.write_build("false")
        done = self.check()
        self.assertEqual((done.exit_code, done.out), (CANNOT_ACCESS, ""), done)
        self.assertIn("hyrax-sim could not be built", done.err)

    def test_watch_repeats_after_a_change_until_it_is_interrupted(self):
        log = self.folder / "log"
        with open(log, "wb") as stream:
            process = Process("tools/check", "--watch", cwd=self.folder, stdout=stream, stderr=stream,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
        with process:
            self.wait_for(log, "exit code 0; waiting")
            self.write(self.scenario, fling(name="one", steps=299))
            self.wait_for(log, "exit code 1; waiting")
            self.write("sim/source.txt", "other")
            self.wait_for(log, "exit code 1; waiting", times=2)
            os.killpg(process.id, signal.SIGINT)
            self.assertEqual(process.wait().exit_code, 0)
        self.assertEqual(log.read_text().count("build hyrax-sim"), 2)

    def wait_for(self, log, text, times=1):
        """Until the log contains the text that often."""
        end = time.monotonic() + 120
        while log.read_text().count(text) < times:
            self.assertLess(time.monotonic(), end, log.read_text())
            time.sleep(0.05)


class RunScript(ProgramTest):
    """tools/run in a project without a build folder."""

    def test_a_missing_scenario_is_reported_before_anything_is_built(self):
        for script in ("run", "setup.sh"):
            self.write(f"tools/{script}", (SOURCE / "tools" / script).read_text())
        (self.folder / "tools/run").chmod(0o755)
        options = ",".join(re.findall(r"^  (-\S+) \S", run(PROGRAM, "run", "--help").out, re.MULTILINE)).split(",")
        self.assertIn("--golden", options)
        with_values = [word for option in options for word in (option, "x")]
        for arguments in (with_values, ("--yes", "--set", "/steps=9", "-o", "a.h5"), ("--figure",)):
            outcome = run("tools/run", *arguments, cwd=self.folder)
            self.assertEqual((outcome.exit_code, outcome.out), (BAD_INPUT, ""), outcome)
            self.assertIn("tools/run: SCENARIO is missing", outcome.err)
        self.assertFalse((self.folder / "build").exists())


if __name__ == "__main__":
    main()
