#!/usr/bin/python3
"""Small files of scenarios that are costly to parse, or to play: what `run` and `bless` write of them is read again."""

from program import AGREED, ProgramTest, fling, main


class CostlyScenario(ProgramTest):
    """Of each run, the first and the last row are recorded."""

    def run_and_compare(self, **changes):
        """The file of a run agrees with itself."""
        self.write("scenarios/fling.json", fling(record={"every": 1_000_000_000}, **changes))
        self.expect(AGREED, "run", "scenarios/fling.json", timeout=300)
        self.assertLess((self.folder / "fling.h5").stat().st_size, 20e6)
        self.expect(AGREED, "diff", "fling.h5", "fling.h5", timeout=300)

    def test_a_recorded_trace_of_two_million_frames(self):
        self.run_and_compare(steps=None, clock={"dt_s": [0.0625] * 2_000_000})
        self.expect(AGREED, "drift", "fling.h5", timeout=300)
        self.expect(AGREED, "bless", "scenarios", "--reason", "for the test", timeout=300)
        (self.folder / "golden/fling.txt").write_text("physics: none\n", encoding="utf-8")  # So that the rows are read.
        self.assertNotIn("damaged", str(self.hyrax_sim("check", timeout=300)))

    def test_a_moment_after_sixty_million_jittered_frames(self):
        """None of which is skipped: memory that a frame kept would show."""
        self.run_and_compare(steps=60_000_000, events=[{"at_s": 59_000_000, "stop": {}}],
                             clock={"dt_s": 1, "jitter": {"kind": "normal", "sigma_s": 0.1, "seed": 1}})
        self.expect_below(30e6, AGREED, "run", "scenarios/fling.json")


if __name__ == "__main__":
    main()
