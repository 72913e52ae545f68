"""shrink: the smallest scenario on which a command ends the same way."""

import os
import signal
import time

from process import is_alive
from program import AGREED, ProgramTest, fling


class Shrink(ProgramTest):
    def test_an_interrupt_leaves_no_temporary_file(self):
        self.write("fling.json", fling())
        temporary = self.folder / "temporary"
        temporary.mkdir()
        process = self.begin("shrink", "fling.json", "--fails", "echo $$ > shell; touch {}.seen; sleep 60; true", "-o", "small.json",
                             env={**os.environ, "TMPDIR": str(temporary)})
        deadline = time.monotonic() + 120
        while not list(temporary.glob("*/*.seen")) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertEqual(len(list(temporary.iterdir())), 1)
        process.send(signal.SIGINT)
        self.assertEqual(process.wait().exit_code, -signal.SIGINT)
        self.assertEqual(list(temporary.iterdir()), [])
        self.assertFalse(is_alive(int((self.folder / "shell").read_text())), "what the command started lives on")

    def test_a_command_that_prints_without_end_takes_no_memory(self):
        self.write("still.json", fling(name="still", steps=0))
        self.expect_below(40e6, AGREED, "shrink", "still.json", "--fails", "yes {}", "--time-limit", "0.1", "-o", "small.json")
