"""An exact fling that misses a wall is a fault of the program, whatever asks for it."""

from altered import CONTROLS
from process import run
from program import DISAGREED, SOURCE, ProgramTest

PROGRAM_FAULT = 70


class Unsound(ProgramTest):
    def test_an_exact_fling_outside_its_bounds_is_an_internal_error(self):
        for arguments in (("drift", "scenarios/flings/first-fling.json"), ("study", "speed-error", "--quick", "--no-figures", "-o", self.folder)):
            outcome = run(CONTROLS / "control_unsound", *arguments, cwd=SOURCE, exit_code=PROGRAM_FAULT)
            self.assertIn("the exact fling is outside its bounds", outcome.out + outcome.err)

    def test_an_exact_fling_that_misses_a_corner_turns_the_hard_cases_red(self):
        outcome = run(CONTROLS / "control_unsound", "study", "hard-cases", "scenarios/hard/corners.json", "--gate", "--no-figures", "--json", "-o", self.folder,
                      cwd=SOURCE, exit_code=DISAGREED)
        self.assertEqual({sentence.partition(" is broken")[0] for sentence in outcome.json["broken"]},
                         {f"corners/exact-{end}-{side}: exact-corner" for end in ("upper", "lower") for side in ("left", "right")})
