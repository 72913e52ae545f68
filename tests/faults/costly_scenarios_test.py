#!/usr/bin/python3
"""Files of scenarios that are costly to parse, though the files are small: every command reads what `run` and `bless`
wrote."""

from program import AGREED, ProgramTest, fling, main


class CostlyScenario(ProgramTest):
    """Of each run, the first and the last row are recorded."""

    def assert_read_by_every_command(self, name, **changes):
        """What is written of the scenario is read again."""
        self.write(f"scenarios/{name}.json", fling(name=name, record={"every": 1_000_000_000}, **changes))
        self.expect(AGREED, "run", f"scenarios/{name}.json", "-o", f"{name}.h5", timeout=300)
        self.assertLess((self.folder / f"{name}.h5").stat().st_size, 20e6)
        self.expect(AGREED, "diff", f"{name}.h5", f"{name}.h5", timeout=300)
        self.expect(AGREED, "drift", f"{name}.h5", timeout=300)
        self.expect(AGREED, "bless", f"scenarios/{name}.json", "--reason", "for the test", timeout=300)
        (self.folder / f"golden/{name}.txt").write_text("physics: none\n", encoding="utf-8")  # So that the rows are read.
        outcome = self.hyrax_sim("check", timeout=300)
        self.assertNotIn("damaged", outcome.out + outcome.err)
        self.expect(AGREED, "bless", f"scenarios/{name}.json", "--reason", "for the test", timeout=300)
        self.expect(AGREED, "check", timeout=300)

    def test_a_recorded_trace_of_two_million_frames(self):
        self.assert_read_by_every_command("trace", steps=None, clock={"dt_s": [0.0625] * 2_000_000})

    def test_a_moment_after_twenty_million_jittered_frames(self):
        self.assert_read_by_every_command(
            "moment", steps=20_000_000, clock={"dt_s": 1, "jitter": {"kind": "normal", "sigma_s": 0.1, "seed": 1}},
            events=[{"at_s": 19_000_000, "stop": {}}])


if __name__ == "__main__":
    main()
