#!/usr/bin/python3
"""An exact fling that misses a wall is a fault of the program, whatever asks for it."""

from altered import CONTROLS
from process import run
from program import SOURCE, ProgramTest, main

PROGRAM_FAULT = 70


class Unsound(ProgramTest):
    def test_an_exact_fling_outside_its_bounds_is_an_internal_error(self):
        for arguments in (("drift", "scenarios/flings/first-fling.json"), ("study", "speed-error", "--quick", "--no-figures", "-o", self.folder)):
            outcome = run(CONTROLS / "control_unsound", *arguments, cwd=SOURCE)
            self.assertEqual(outcome.exit_code, PROGRAM_FAULT, outcome)
            self.assertIn("the exact fling is outside its bounds", outcome.out + outcome.err)


if __name__ == "__main__":
    main()
