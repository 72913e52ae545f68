#!/usr/bin/python3
"""A changed core turns `check` red, and the verdict names step, field and class."""

import functools
import os
import pathlib
import tempfile

import h5py

from altered import CONTROLS, run_altered
from process import run, succeed
from program import AGREED, DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE, ProgramTest, fling, main

FIELDS = {"t", "dt", "x", "y", "vx", "vy", "contact"}
STEPS_MAX = 100_000  # A core whose runs never repeat plays them all.
FIRST_FLING = "scenarios/flings/first-fling.json"
CLASSES = {"rounding", "values", "contacts", "shape"}


@functools.cache
def exercised():
    """What each scenario that is not long exercises, by the unchanged program: {path: {"gravity", "ground", ...}}."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        runs = succeed(PROGRAM, "run", "scenarios", "--json", "-o", folder + "/", cwd=SOURCE).json["runs"]
    return {entry["scenario"]: set(entry["exercised"]) for entry in runs if entry["steps"] <= STEPS_MAX}


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

    def red(self, control):
        """Paths of the scenarios that are red; each of them with step, field and class."""
        outcome = self.check(control, "--json", *sorted(exercised()))
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        document = outcome.json
        self.assertEqual((document["missing"], document["failed"]), (0, 0))
        red = {}
        for entry in document["results"]:
            if entry["status"] == "agreed":
                continue
            self.assertIn(entry["class"], CLASSES, entry)
            field = entry["first_divergence"]["field"]
            self.assertTrue(field in FIELDS or field.startswith("contacts/"), entry)
            self.assertGreaterEqual(entry["first_divergence"]["step"], 1, entry)
            red[entry["scenario"]] = entry
        text = self.check(control, "--verbose", "scenarios/flings").out
        for path, entry in red.items():
            if not path.startswith("scenarios/flings/"):
                continue
            verdict = text[text.index(f"{path}: disagreed"):]
            first = entry["first_divergence"]
            self.assertIn(f"class      {entry['class']}\n", verdict)
            self.assertIn(f"first      step {first['step']}, field {first['field']}\n", verdict)
        return set(red)

    def assert_nearly_all_red(self, control, concerned):
        """Rounding hides a change now and then, in a quarter of the concerned scenarios at most."""
        red = self.red(control)
        self.assertGreater(len(concerned), 30)
        self.assertGreaterEqual(len(red & concerned), 0.75 * len(concerned), f"green: {sorted(concerned - red)}")

    def test_no_change_is_green(self):
        outcome = self.check("none")
        self.assertEqual(outcome.exit_code, AGREED, outcome)

    def test_gravity_by_one_ulp(self):
        self.assert_nearly_all_red("gravity_by_one_ulp", that_exercise("gravity"))

    def test_a_comparison_that_is_not_strict(self):
        """It changes a step that ends on the bound to the bit; few do."""
        self.assertIn("scenarios/paper/exact-bounds.json", self.red("ground_not_strict"))

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
        with h5py.File(self.folder / "a.h5") as file:
            self.assertEqual(list(file["trajectory/step"][:]), [int(line.split(",")[0]) for line in lines[1:]])
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
        self.assertEqual(that_exercise("drag") - self.red("update_alone"), set())

    def test_fused_multiply_adds(self):
        if not has_fma():
            self.skipTest("this processor has no fused multiply-add")
        self.assert_nearly_all_red("contracted", that_exercise("gravity"))


if __name__ == "__main__":
    main()
