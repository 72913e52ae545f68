"""shrink: the smallest scenario on which a command ends the same way."""

import json
import os
import signal
import time

from process import is_alive
from program import AGREED, ProgramTest, fling

EVENTS = [{"step": 20, "hitch": {"dt_s": 0.25}}, {"step": 100, "grab": {}}, {"step": 110, "place": {"x_px": 5, "y_px": 5}},
          {"step": 120, "release": {"vx_px_per_s": 12.25, "vy_px_per_s": 99}}]


class Shrink(ProgramTest):
    """A throw of 300 frames and four events."""

    def setUp(self):
        super().setUp()
        self.write("fling.json", fling(events=EVENTS, expect={"finite": True}))

    def shrink(self, command, *options):
        """Shrinks by a command; the document, and the smaller scenario."""
        document = self.expect(AGREED, "shrink", "fling.json", "--fails", command, "-o", "small.json", "--json", *options).json
        self.expect(AGREED, "validate", "small.json")
        return document, json.loads((self.folder / "small.json").read_text())

    def test_a_signal_counts_as_128_and_its_number(self):
        document, _ = self.shrink("grep -q grab {} && kill -SEGV $$; exit 3")
        self.assertEqual(document["kept"], "the command's signal 11 (exit code 139)")
        document, small = self.shrink("grep -q grab {} && exit 139; kill -SEGV $$", "--force")
        self.assertEqual(small["steps"], 0, "a signal and its number as exit code are the same")

    def test_a_command_that_hangs_is_ended(self):
        """Nothing but the grab can be removed, so only two trials hang; the limit is long beside the start of a shell."""
        self.write("fling.json", fling(steps=1, events=[{"step": 0, "grab": {}}], start=dict.fromkeys(("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"), 0),
                                       window={"width_px": 1000, "height_px": 1000}, sprite={"width_px": 100, "height_px": 100}))
        document, small = self.shrink("grep -q grab {} && sleep 600; exit 1", "--time-limit", "4")
        self.assertEqual(document["kept"], "the command's no end within 4 s")
        self.assertEqual(small["events"], [{"step": 0, "grab": {}}])

    def test_an_interrupt_leaves_no_temporary_file(self):
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
