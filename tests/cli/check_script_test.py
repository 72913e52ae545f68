#!/usr/bin/python3
"""tools/check builds hyrax-sim and passes on its verdict; --watch repeats that after a change.

Runs a copy of the scripts in a project whose build folder has a ninja file of one target: it copies the program.
"""

import os
import signal
import time

from process import Process, run, skip_unless_installed
from program import CANNOT_ACCESS, DISAGREED, PROGRAM, SOURCE, ProgramTest, fling, main


class CheckScript(ProgramTest):
    """A project with a build folder that is configured."""

    def setUp(self):
        skip_unless_installed("ninja")
        super().setUp()
        self.scenario, = self.project("one")
        self.write("tools/check", (SOURCE / "tools/check").read_text())
        # What is replaced here starts processes; tools.scripts has it.
        self.write("tools/setup.sh", (SOURCE / "tools/setup.sh").read_text() + 'project_folder() { echo "$PWD"; }; flock() { :; }\n')
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

    def test_help_builds_nothing_and_the_exit_code_is_that_of_check_or_3(self):
        done = self.check("--help")
        self.assertEqual((done.exit_code, done.err), (0, ""))
        for part in ("--watch", "Ctrl-C", "Exit code"):
            self.assertIn(part, done.out)
        self.assertFalse((self.folder / "build/tools/bin").exists())
        self.write(self.scenario, fling(name="one", steps=299))
        done = self.check(self.scenario, "--golden", "golden")
        self.assertEqual(done.exit_code, DISAGREED, done)
        self.assertIn("build hyrax-sim", done.err)
        self.assertIn("0 agreed, 1 disagreed", done.out)
        self.write_build("false")
        done = self.check()
        self.assertEqual((done.exit_code, done.out), (CANNOT_ACCESS, ""), done)
        self.assertIn("hyrax-sim could not be built", done.err)

    def test_watch_repeats_after_a_change_until_it_is_interrupted(self):
        log = self.folder / "log"
        for part in ("scenarios", "golden"):
            os.renames(self.folder / part, self.folder / "elsewhere" / part)
        with open(log, "wb") as stream:
            process = Process("tools/check", "--watch", "elsewhere/scenarios", cwd=self.folder, stdout=stream, stderr=stream,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
        with process:
            self.wait_for(log, "exit code 0; waiting")
            self.write(f"elsewhere/{self.scenario}", fling(name="one", steps=299))
            self.wait_for(log, "exit code 1; waiting")
            self.assertEqual(log.read_text().count("build hyrax-sim"), 1, "up to date: nothing is built")
            self.write("sim/source.txt", "other")
            self.wait_for(log, "exit code 1; waiting", times=2)
            os.killpg(process.id, signal.SIGINT)
            self.assertEqual(process.wait().exit_code, 0)
        for part, times in (("build hyrax-sim", 2), ("1 agreed", 1), ("0 agreed, 1 disagreed", 2)):
            self.assertEqual(log.read_text().count(part), times, part)

    def wait_for(self, log, text, times=1):
        """Until the log contains the text that often."""
        end = time.monotonic() + 120
        while log.read_text().count(text) < times:
            self.assertLess(time.monotonic(), end, log.read_text())
            time.sleep(0.05)


if __name__ == "__main__":
    main()
