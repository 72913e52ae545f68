#!/usr/bin/python3
"""What `check` says of a core by which runs become infinite."""

from altered import run_altered
from program import DISAGREED, GOLDEN_MISSING, ProgramTest, fling, main

FIRST_FLING = "scenarios/flings/first-fling.json"


class ChangedCore(ProgramTest):
    """Each test is one change."""

    def test_runs_that_become_infinite_come_first_and_are_not_blessed(self):
        of_first = "vx is infinite from step 120 of 600 (2.00 s)"
        for options, wanted in (((), f"1 of 1 scenario becomes non-finite: {of_first}.\n"), ((), "core: changed\n"), (("--verbose",), f"  not finite {of_first}\n"),
                                (("--annotate", "github"), f"::{of_first}; expect finite")):
            outcome = run_altered("bounce_explodes", "check", *options, FIRST_FLING)
            self.assertEqual(outcome.exit_code, DISAGREED)
            self.assertIn(wanted, outcome.out)
            self.assertNotIn("bless scenarios", outcome.out)
            self.assertNotIn("inf px", outcome.out)
        (group,) = run_altered("bounce_explodes", "check", "--json", FIRST_FLING).json["groups"]
        self.assertEqual((group["operation"], group["detail"], group["scenarios"]), ("non_finite", of_first, [FIRST_FLING]))
        outcome = run_altered("bounce_explodes", "check", "scenarios/flings")
        self.assertRegex(outcome.out, r"^15 of 16 scenarios become non-finite: in the worst, v[xy] is infinite from step \d+ of 600 ")
        for name in ("a.h5", "a.csv"):
            run_altered("bounce_explodes", "run", FIRST_FLING, "-o", self.folder / name)
        lines = (self.folder / "a.csv").read_text().splitlines()
        self.assertEqual(lines[-1].split(",")[:6:5], ["120", "-inf"])
        outcome = run_altered("none", "diff", self.folder / "a.h5", self.folder / "a.h5")
        self.assertEqual((len(lines), "121 rows" in outcome.out), (122, True), outcome)
        outcome = run_altered("bounce_explodes", "bless", FIRST_FLING, "--reason", "none")
        self.assertEqual(outcome.exit_code, DISAGREED)
        self.assertIn(of_first, outcome.out + outcome.err)

    def test_one_without_golden_file_is_not_offered_to_bless(self):
        scenario = self.write("scenarios/fling.json", fling())
        outcome = run_altered("bounce_explodes", "check", self.folder / scenario)
        self.assertEqual(outcome.exit_code, GOLDEN_MISSING)
        self.assertRegex(outcome.out, "fling.json: missing: v[xy] is infinite from step .*; no golden file at ")
        self.assertNotIn("hyrax-sim bless", outcome.out)


if __name__ == "__main__":
    main()
