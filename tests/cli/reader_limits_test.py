#!/usr/bin/python3
"""No scenario needs time or memory out of proportion to its file."""

from program import AGREED, BAD_INPUT, ProgramTest, fling, main

MEBIBYTE = 2**20
JITTER = {"rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 1}}


class ReaderLimits(ProgramTest):
    """Validated, not played."""

    def test_a_time_that_no_walk_reaches_is_refused_at_once(self):
        path = self.write("far.json", fling(clock=JITTER, steps=1e12, events=[{"at_s": 1e9, "stop": {}}]))
        self.expect(BAD_INPUT, "validate", path, says="far.json: /events/0/at_s: must fall on a frame up to 100000000")

    def test_a_trace_takes_memory_in_proportion_to_its_text(self):
        frames = 1_000_000
        path = self.write("trace.json", fling(clock={"dt_s": [0] * frames}, steps=None))
        size = (self.folder / path).stat().st_size
        self.expect_below(20 * MEBIBYTE + 25 * size, AGREED, "validate", path)


if __name__ == "__main__":
    main()
