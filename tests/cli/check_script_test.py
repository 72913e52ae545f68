"""tools/check --watch repeats the check after a change of a source or a scenario, and builds hyrax-sim if it is needed.

Runs a copy of the scripts in a project whose build folder has a ninja file of one target: it copies the program.
"""

import os
import shutil
import signal
import time

from process import Process, skip_unless_installed
from program import PROGRAM, SOURCE, ProgramTest, fling


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
        self.write("build/tools/build.ninja",  # It makes the program whenever sim/source.txt has changed; then the scenario is saved as it was.
                   f"rule make\n  command = cp {PROGRAM} bin/hyrax-sim; cp ../../blessed.json ../../elsewhere/{self.scenario}\nbuild bin/hyrax-sim: make ../../sim/source.txt\n"
                   "build hyrax-sim: phony bin/hyrax-sim\n")

    def test_watch_repeats_after_a_change_also_during_a_build_until_it_is_interrupted(self):
        log = self.folder / "log"
        for part in ("scenarios", "golden"):
            os.renames(self.folder / part, self.folder / "elsewhere" / part)
        shutil.copy(self.folder / "elsewhere" / self.scenario, self.folder / "blessed.json")
        (self.folder / "scenarios").mkdir()
        with open(log, "wb") as stream:
            process = Process("tools/check", "--watch", "elsewhere/scenarios", cwd=self.folder, stdout=stream, stderr=stream,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
        with process:
            self.wait_for(log, "exit code 0; waiting", times=2)
            self.write(f"elsewhere/{self.scenario}", fling(name="one", steps=299))
            self.wait_for(log, "exit code 1; waiting")
            self.assertEqual(log.read_text().count("build hyrax-sim"), 1, "up to date: nothing is built")
            self.write("sim/source.txt", "other")
            self.wait_for(log, "exit code 0; waiting", times=4)
            self.write("scenarios/new.json", "")
            self.wait_for(log, "exit code 0; waiting", times=5)
            os.killpg(process.id, signal.SIGINT)
            self.assertEqual(process.wait().exit_code, 0)
        for part, times in (("build hyrax-sim", 2), ("1 agreed", 5), ("0 agreed, 1 disagreed", 1)):
            self.assertEqual(log.read_text().count(part), times, part)

    def wait_for(self, log, text, times=1):
        """Until the log contains the text that often."""
        end = time.monotonic() + 120
        while log.read_text().count(text) < times:
            self.assertLess(time.monotonic(), end, log.read_text())
            time.sleep(0.05)
