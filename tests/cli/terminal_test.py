#!/usr/bin/python3
"""The result of a run does not depend on progress: stderr is a terminal here."""

from program import AGREED, ProgramTest, fling, main


class Terminal(ProgramTest):
    """Long enough for progress to cut the run into pieces."""

    def assert_same_when_watched(self, **scenario):
        """The same summary and the same file."""
        path = self.write("long.json", fling(**scenario))
        unwatched = self.expect(AGREED, "run", path, "-o", "run.h5", "--json").out
        rows = (self.folder / "run.h5").read_bytes()
        outcome, shown = self.on_terminal("stderr", "run", path, "-o", "run.h5", "--json")
        self.assertEqual((outcome.exit_code, outcome.out), (AGREED, unwatched), shown)
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
        _, shown = self.on_terminal("stderr", "fuzz", "--time", "1s", "--json")
        self.assertRegex(shown, r"\d+ runs, [\d.e+]+ per second, [01] s left")


if __name__ == "__main__":
    main()
