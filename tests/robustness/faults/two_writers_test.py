#!/usr/bin/python3
"""Several processes write the same output: one complete output remains, and none disturbs another."""

from program import AGREED, ProgramTest, fling, main

SPEEDS = (100, 900, 1700)


class TwoWriters(ProgramTest):
    """Three throws of different speed, and the file that each of them makes."""

    whole = []

    def setUp(self):
        super().setUp()
        for speed in SPEEDS:
            start = {"x_px": 0, "y_px": 500, "vx_px_per_s": speed, "vy_px_per_s": -400}
            self.write(f"{speed}.json", fling(name="same", start=start))
            if len(self.whole) < len(SPEEDS):
                self.expect(AGREED, "run", f"{speed}.json", "-o", "whole.h5")
                self.whole.append((self.folder / "whole.h5").read_bytes())

    def assert_done(self, process):
        outcome = process.wait()
        self.assertEqual(outcome.exit_code, AGREED, outcome)

    def test_many_writers_at_once_succeed_and_leave_one_file(self):
        for _ in range(4):
            for process in [self.begin("run", f"{speed}.json", "-o", "out.h5") for speed in SPEEDS for _ in range(2)]:
                self.assert_done(process)
            self.assertIn((self.folder / "out.h5").read_bytes(), self.whole)
        self.assertEqual([name for name in self.names() if name.endswith(".part")], [])

    def test_concurrent_blessings_leave_a_complete_one(self):
        self.write("scenarios/same.json", fling(name="same"))
        for _ in range(4):
            for process in [self.begin("bless", "scenarios", "--reason", "x") for _ in range(3)]:
                self.assert_done(process)
            self.expect(AGREED, "check")
        self.assertEqual(self.names("golden"), ["core", "same.h5", "same.txt"])


if __name__ == "__main__":
    main()
