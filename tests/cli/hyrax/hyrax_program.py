"""hyrax.exe as a user has it: started under Wine, dragged, flung, disturbed, ended; compared with the model.

HYRAX_REPLAY is the console twin of this machine; HYRAX_WINE names the folder that prepare.py made.
"""

import json
import os
import pathlib
import time

import h5py
import numpy

from process import run, skip_without
from program import AGREED, DISAGREED, ProgramTest
from wine import Wine

skip_without("wine")

FOLDER = pathlib.Path(os.environ.get("HYRAX_WINE", "no-such-folder")).resolve()
FLINGER = FOLDER / "flinger.exe"
HYRAX = FOLDER / "mingw/bin/hyrax.exe"
HYRAX_REPLAY = FOLDER / "mingw/bin/hyrax-replay.exe"
REPLAY = pathlib.Path(os.environ.get("HYRAX_REPLAY", "hyrax-replay")).resolve()

WM_CLOSE = 0x10
ENDS_BY_ITSELF_S = 120
TIMEOUT_S = 150

# The hand draws back to the left, then throws to the right and up, at about (1200, -800) px/s.
FLING = "point 64 64 grab by -6 -10 20 12 by 14 -9 12 10 release".split()


def read_log(path):
    """The lines of a log so far; the last may be in the making."""
    lines = path.read_text().split("\n") if path.exists() else []
    return [json.loads(line, parse_int=float) for line in lines[:-1]]  # -0 is a float, and another one than 0.


class Flight:
    """The results of a run of the program: its log, its recording, its exit code."""

    def __init__(self, folder, exit_code, err):
        self.exit_code = exit_code
        self.err = err
        self.path = folder / "flight.json"
        self.log = read_log(folder / "flight.log")
        self.frames = [line for line in self.log if "frame" in line]

    @property
    def document(self):
        """The recording."""
        return json.loads(self.path.read_text())

    def events(self, kind):
        """The events of one kind, with their steps."""
        return [event for event in self.document.get("events", []) if kind in event]


class HyraxTest(ProgramTest):
    """A desktop, and a hyrax upon it."""

    display = None

    def setUp(self):
        super().setUp()
        self.wine = Wine(FOLDER / ("prefix" if self.display is None else "prefix-x11"), self.display)
        self.wine.end()
        self.addCleanup(self.wine.end)

    # --- doing

    def start(self, *options):
        """Starts the program, recording and logging into the folder."""
        for name in ("flight.json", "flight.log"):
            (self.folder / name).unlink(missing_ok=True)
        process = self.wine.start(HYRAX, "--record", "flight.json", "--log", "flight.log", "--seconds",
                                  ENDS_BY_ITSELF_S, *options, cwd=self.folder)
        self.addCleanup(process.end)
        return process

    def hand(self, *actions):
        """Performs actions of the hand, which flinger.cpp lists."""
        done = self.wine.run(FLINGER, "find", 120, *actions, timeout=TIMEOUT_S)
        self.assertEqual(done.exit_code, 0, done.err)
        return done.out

    def wait_for(self, what, has_come):
        """Waits until the log fulfils a condition: on a busy machine this is the only reliable way to wait."""
        give_up_s = time.monotonic() + TIMEOUT_S
        while not has_come(log := read_log(self.folder / "flight.log")):
            if time.monotonic() > give_up_s:
                inputs = [(line["t_s"], line["inputs"]) for line in log if line.get("inputs")]
                self.fail(f"{what}: timed out; inputs {inputs}, at last {log[-1:]}")
            time.sleep(0.2)

    def wait_for_input(self, kind, count=1):
        """Waits until a frame with such an input was played."""
        self.wait_for(kind, lambda log: sum(kind in line.get("inputs", ()) for line in log) >= count)

    def wait_for_sleep(self):
        """Waits until it is at rest and plays no more frames."""
        self.wait_for("asleep", lambda log: log and "asleep_after_frame" in log[-1])

    def start_and_fling(self):
        """The program, at work upon a hyrax that came down from the top, bounced, and was flung by the hand."""
        process = self.start()
        self.wait_for("3.5 s", lambda log: any(line.get("t_s", 0) >= 3.5 for line in log))
        self.hand(*FLING)
        self.wait_for_input("release")
        return process

    def end(self, process):
        """Waits until the program has ended; returns its results."""
        outcome = process.wait(TIMEOUT_S)
        return Flight(self.folder, outcome.exit_code, outcome.err)

    def close(self, process):
        """Ends the program as its user does; returns its results."""
        self.hand("post", WM_CLOSE, 0, 0)
        flight = self.end(process)
        self.assertEqual(flight.exit_code, 0, flight.err)
        return flight

    def fling_and_watch(self, wait_ms):
        """From start to end: a fling, and so much of the flight after it."""
        process = self.start_and_fling()
        self.hand("sleep", wait_ms)
        return self.close(process)

    # --- judging

    def rows(self, path):
        """Replays a recording with hyrax-sim, which must agree; returns the rows."""
        self.expect(AGREED, "run", path, "-o", "flight.h5")
        with h5py.File(self.folder / "flight.h5") as file:
            return {name: file["trajectory"][name][...] for name in ("dt", "x", "y", "vx", "vy", "contact")}

    def assert_is_the_model(self, flight):
        """The recording replays to its own hash; its rows are the shown ones, bit for bit; the window was there."""
        rows = self.rows(flight.path)
        shown = flight.frames
        self.assertEqual(len(shown), len(rows["dt"]) - 1)
        for name, key in (("dt", "dt_s"), ("x", "x_px"), ("y", "y_px"), ("vx", "vx_px_per_s"), ("vy", "vy_px_per_s")):
            logged = numpy.array([frame[key] for frame in shown], float)
            numpy.testing.assert_array_equal(logged.view(numpy.int64), rows[name][1:].view(numpy.int64), name)
        for frame in shown:
            left, top, right, bottom = frame["window_rect_px"]
            origin = frame["work_area_px"]
            self.assertLessEqual(abs(left - origin[0] - frame["x_px"]), 0.5, frame)
            self.assertLessEqual(abs(top - origin[1] - frame["y_px"]), 0.5, frame)
            self.assertEqual([right - left, bottom - top], frame["sprite_px"], frame)

    def assert_replays_everywhere(self, flight):
        """hyrax-replay of this machine, hyrax-replay.exe and hyrax.exe find its hash; a nudge they find out."""
        found = flight.document["expect"]["state_hash"]
        nudged = self.folder / "nudged.json"
        document = flight.document
        document["clock"]["dt_s"][-1] = float(numpy.nextafter(document["clock"]["dt_s"][-1], numpy.inf))
        nudged.write_text(json.dumps(document))
        for path, exit_code in ((flight.path, AGREED), (nudged, DISAGREED)):
            native = run(REPLAY, path.name, cwd=self.folder)
            twin = self.wine.run(HYRAX_REPLAY, path.name, cwd=self.folder)
            window = self.wine.run(HYRAX, "--replay", path.name, "--exit", cwd=self.folder)
            for done in (native, twin, window):
                self.assertEqual(done.exit_code, exit_code, str(done))
            for done in (native, twin):
                self.assertEqual(done.out.split()[0] == found, exit_code == AGREED)
