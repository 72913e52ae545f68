#!/usr/bin/python3
"""The result of a run does not depend on progress: stderr is a terminal here."""

import os
import pty
import threading

from program import AGREED, ProgramTest, fling, main


class Terminal(ProgramTest):
    """Long enough for progress to cut the run into pieces."""

    shown = ""

    def run_watched(self, *arguments):
        """Runs the program with a terminal as its stderr; returns its output and what the terminal showed."""
        keeper, terminal = pty.openpty()
        shown = []

        def watch():
            try:
                while part := os.read(keeper, 65536):
                    shown.append(part)
            except OSError:
                pass  # The terminal is closed.

        watcher = threading.Thread(target=watch)
        watcher.start()
        try:
            outcome = self.hyrax_sim(*arguments, stderr=terminal)
        finally:
            os.close(terminal)
            watcher.join()
            os.close(keeper)
        self.shown = b"".join(shown).decode()
        self.assertEqual(outcome.exit_code, AGREED, self.shown)
        return outcome.out

    def assert_same_when_watched(self, **scenario):
        """The same summary and the same file."""
        path = self.write("long.json", fling(**scenario))
        unwatched = self.expect(AGREED, "run", path, "-o", "run.h5", "--json").out
        rows = (self.folder / "run.h5").read_bytes()
        self.assertEqual(self.run_watched("run", path, "-o", "run.h5", "--json"), unwatched)
        self.assertEqual((self.folder / "run.h5").read_bytes(), rows)
        return unwatched

    def test_a_run_that_repeats_is_the_same(self):
        out = self.assert_same_when_watched(steps=10**8, record={"every": 10**6})
        self.assertNotIn('"periodic_from_step": null', out)

    def test_a_run_that_is_computed_is_the_same(self):
        self.assert_same_when_watched(
            steps=300_000, record={"every": 1000}, events=[{"step": 70_000, "stop": {}}],
            clock={"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 1}})

    def test_fuzz_shows_how_far_it_is(self):
        self.run_watched("fuzz", "--time", "1s", "--json")
        self.assertRegex(self.shown, r"\d+ runs, [\d.e+]+ per second, [01] s left")


if __name__ == "__main__":
    main()
