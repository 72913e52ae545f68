#!/usr/bin/python3
"""A changed core turns `check` red, and the verdict names step, field and class."""

import functools
import os
import pathlib
import tempfile

from altered import CONTROLS, run_altered
from process import run, succeed
from program import DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE, ProgramTest, fling, main

FIELDS = {"t", "dt", "x", "y", "vx", "vy", "contact"}
FOLDERS = ("scenarios/flings", "scenarios/paper", "scenarios/displays")
FIRST_FLING = "scenarios/flings/first-fling.json"
CLASSES = {"rounding", "values", "contacts", "shape"}


@functools.cache
def exercised():
    """What each scenario of three folders exercises, by the unchanged program: {path: {"gravity", "ground", ...}}."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        runs = succeed(PROGRAM, "run", *FOLDERS, "--json", "-o", folder + "/", cwd=SOURCE).json["runs"]
    return {entry["scenario"]: set(entry["exercised"]) for entry in runs}


def that_exercise(part):
    """Paths of the scenarios that exercise a part of the core."""
    return {path for path, parts in exercised().items() if part in parts}


def has_fma():
    """Whether this processor fuses multiply-adds."""
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    return not cpuinfo.exists() or " fma " in cpuinfo.read_text() or "aarch64" in os.uname().machine


class ChangedCore(ProgramTest):
    """Each test is one change; `check` runs over all scenarios of the project."""

    def check(self, control, *options):
        """The verdicts of the program with that change on all scenarios."""
        if control != "contracted":
            return run_altered(control, "check", *options)
        return run(CONTROLS / "control_contracted", "check", *options, cwd=SOURCE)

    def red(self, control, *paths):
        """The scenarios that are red, by path; each with step, field and class."""
        outcome = self.check(control, "--json", *(paths or sorted(exercised())))
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        document = outcome.json
        self.assertEqual((document["missing"], document["failed"]), (0, 0))
        red = {entry["scenario"]: entry for entry in document["results"] if entry["status"] != "agreed"}
        for entry in red.values():
            self.assertIn(entry["class"], CLASSES, entry)
            field = entry["first_divergence"]["field"]
            self.assertTrue(field in FIELDS or field.startswith("contacts/"), entry)
            self.assertGreaterEqual(entry["first_divergence"]["step"], 1, entry)
        return red

    def assert_nearly_all_red(self, control, concerned):
        """Rounding hides a change now and then, in a quarter of the concerned scenarios at most."""
        red = self.red(control)
        self.assertGreater(len(concerned), 30)
        self.assertGreaterEqual(len(concerned & set(red)), 0.75 * len(concerned), f"green: {sorted(concerned - set(red))}")
        return red

    def test_gravity_by_one_ulp(self):
        red = self.assert_nearly_all_red("gravity_by_one_ulp", that_exercise("gravity"))
        text = self.check("gravity_by_one_ulp", "--verbose", "scenarios/flings").out
        for path in (path for path in red if path.startswith("scenarios/flings/")):
            verdict, first = text[text.index(f"{path}: disagreed"):], red[path]["first_divergence"]
            self.assertIn(f"class      {red[path]['class']}\n", verdict)
            self.assertIn(f"first      step {first['step']}, field {first['field']}\n", verdict)

    def test_a_comparison_that_is_not_strict(self):
        """It changes a step that ends on the bound to the bit; few do."""
        self.assertIn("scenarios/paper/exact-bounds.json", self.red("ground_not_strict", "scenarios/paper"))

    def test_runs_that_become_infinite_come_first_and_are_not_blessed(self):
        of_first = "vx is infinite from step 120 of 600 (2.00 s)"
        for options, wanted in (((), f"1 of 1 scenario becomes non-finite: {of_first}.\n"), (("--verbose",), f"  not finite {of_first}\n"),
                                (("--annotate", "github"), f"::{of_first}; expect finite")):
            outcome = self.check("bounce_explodes", *options, FIRST_FLING)
            self.assertEqual(outcome.exit_code, DISAGREED)
            self.assertIn(wanted, outcome.out)
            self.assertNotIn("bless scenarios", outcome.out)
            self.assertNotIn("inf px", outcome.out)
        (group,) = self.check("bounce_explodes", "--json", FIRST_FLING).json["groups"]
        self.assertEqual((group["operation"], group["detail"], group["scenarios"]), ("non_finite", of_first, [FIRST_FLING]))
        outcome = self.check("bounce_explodes", "scenarios/flings")
        self.assertRegex(outcome.out, r"^15 of 16 scenarios become non-finite: in the worst, v[xy] is infinite from step \d+ of 600 ")
        for name in ("a.h5", "a.csv"):
            run_altered("bounce_explodes", "run", FIRST_FLING, "-o", self.folder / name)
        lines = (self.folder / "a.csv").read_text().splitlines()
        self.assertEqual(lines[-1].split(",")[:6:5], ["120", "-inf"])
        outcome = run_altered("none", "diff", self.folder / "a.h5", self.folder / "a.h5")
        self.assertEqual((len(lines), "121 rows" in outcome.out), (122, True), outcome)
        for command in (("bless", FIRST_FLING, "--reason", "none"), ("run", FIRST_FLING, "-o", self.folder / "a.h5")):
            outcome = run_altered("bounce_explodes", *command)
            self.assertEqual(outcome.exit_code, DISAGREED)
            self.assertIn(of_first, outcome.out + outcome.err)

    def test_one_without_golden_file_is_not_offered_to_bless(self):
        scenario = self.write("scenarios/fling.json", fling())
        outcome = run_altered("bounce_explodes", "check", self.folder / scenario)
        self.assertEqual(outcome.exit_code, GOLDEN_MISSING)
        self.assertRegex(outcome.out, "fling.json: missing: v[xy] is infinite from step .*; no golden file at ")
        self.assertNotIn("hyrax-sim bless", outcome.out)

    def test_update_alone(self):
        self.assertEqual(that_exercise("drag") - set(self.red("update_alone")), set())

    def test_fused_multiply_adds(self):
        if not has_fma():
            self.skipTest("this processor has no fused multiply-add")
        self.assert_nearly_all_red("contracted", that_exercise("gravity"))


if __name__ == "__main__":
    main()
