"""`hyrax-replay check`: the cases for every build of the program, each with the verdict of `hyrax-sim check` beside it."""

import math
import re

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, FLING, GOLDEN_MISSING, SOURCE, fling

COUNTS = re.compile(r"\d+ checked: .*\n\Z")
AGAIN = "; restore it, or bless the scenario again\n"


class ReplayCheckCases:
    """Mixed into a ProgramTest with `run_replay(*arguments, **options)`, which runs the program in the folder."""

    def setUp(self):
        super().setUp()
        self.project("a/first", "a/second", "third")

    def check(self, exit_code, *arguments, says=""):
        """Both programs end with this exit code and the same counts; hyrax-replay prints `says`."""
        found = self.run_replay("check", *arguments)
        self.assertEqual(found.exit_code, exit_code, str(found))
        self.assertIn(says, found.out + found.err)
        expected = self.expect(exit_code, "check", *arguments)
        self.assertEqual(COUNTS.search(found.out).group(), COUNTS.search(expected.out).group())
        return found.out

    def change_summary(self, name, change):
        """Replaces the text of a summary."""
        path = self.folder / f"golden/{name}.txt"
        path.write_text(change(path.read_text()))

    def test_the_library_of_scenarios_agrees(self):
        found = self.run_replay("check", cwd=SOURCE)
        count = len(list((SOURCE / "scenarios").rglob("*.json")))
        self.assertEqual((found.exit_code, found.out),
                         (AGREED, f"{count} checked: {count} agreed, 0 disagreed, 0 without golden file, 0 failed\n"), str(found))
        self.assertEqual([line for line in found.err.splitlines() if not line.startswith("wine: ")], [])

    def test_it_takes_files_and_folders_and_else_those_of_this_folder(self):
        self.assertEqual(self.check(AGREED), "3 checked: 3 agreed, 0 disagreed, 0 without golden file, 0 failed\n")
        self.assertIn("2 checked", self.check(AGREED, "scenarios/a"))
        self.assertIn("2 checked", self.check(AGREED, str(self.folder / "scenarios/a")))
        self.assertIn("2 checked", self.check(AGREED, "scenarios/a/"))
        self.assertIn("2 checked", self.check(AGREED, "scenarios/third.json", "scenarios/a/first.json"))
        self.assertIn("3 checked", self.check(AGREED, "scenarios/third.json", "./scenarios/third.json", "scenarios"))
        (self.folder / "-a.json").write_text((self.folder / "scenarios/third.json").read_text())
        self.check(GOLDEN_MISSING, "scenarios", "--", "-a.json", says="-a.json: missing")

    def test_another_state_hash_is_a_disagreement(self):
        known = re.search("[0-9a-f]{32}", (self.folder / "golden/third.txt").read_text()).group()
        for digit in (0, 31):
            other = known[:digit] + ("1" if known[digit] == "0" else "0") + known[digit + 1:]
            self.change_summary("third", lambda text, other=other: re.sub("state hash: .*", f"state hash: {other}", text))
            self.check(DISAGREED, says="scenarios/third.json: disagreed: golden/third.txt: state hash differs "
                       f"(found {other}); the run has {known}; `hyrax-sim check` finds the cause\n")

    def test_a_run_that_differs_in_one_bit_disagrees(self):
        start = {**FLING["start"], "vx_px_per_s": math.nextafter(1180.0, math.inf)}
        self.write("scenarios/third.json", fling(name="third", start=start, expect={"contacts": {"right": 2}}))
        self.assertRegex(self.check(DISAGREED), r"scenarios/third.json: disagreed: golden/third.txt: state hash differs .* finds the cause; "
                         r"expect contacts/right: wanted 2, measured 1\n")

    def test_a_damaged_summary_is_a_disagreement(self):
        changed = "scenarios/third.json: disagreed: the golden file was changed since it was blessed: golden/third.txt: "
        whole = (self.folder / "golden/third.txt").read_text()
        for damaged, fault in ((re.sub("state hash: .*\n", "", whole), "has no line `state hash: ` with 32 hex digits"),
                               ("", "has no line `state hash: ` with 32 hex digits"),
                               (whole.replace("\n", "\r\n"), "its line ends were converted to CR LF; a line `golden/** -text` in .gitattributes keeps Git from it"),
                               (whole[:-1], "does not end with its line `checksums: `")):
            self.change_summary("third", lambda _, damaged=damaged: damaged)
            self.check(DISAGREED, says=changed + fault + AGAIN)

    def test_a_missing_file_is_exit_4(self):
        summary = (self.folder / "golden/third.txt").rename(self.folder / "third.txt")
        self.check(GOLDEN_MISSING, says="scenarios/third.json: missing: no golden file at golden/third.h5: golden/third.h5 "
                   "exists, but golden/third.txt is missing; `hyrax-sim bless` creates it\n")
        (self.folder / "golden/third.h5").unlink()
        self.check(GOLDEN_MISSING, says="scenarios/third.json: missing: no golden file at golden/third.h5; ")
        summary.rename(self.folder / "golden/third.txt")
        self.check(GOLDEN_MISSING, says="golden/third.txt exists, but golden/third.h5 is missing")
        self.write("alone.json", fling())
        self.check(GOLDEN_MISSING, "alone.json", says="alone.json: missing: no golden file: no folder `scenarios` above it; --golden DIR names the folder to look in")

    def test_an_expected_state_hash_replaces_a_missing_golden_file_but_not_half_of_one(self):
        known = self.run_replay("scenarios/third.json").out.split()[0]
        start = {**FLING["start"], "vx_px_per_s": 1180}
        for state_hash, exit_code in ((known, AGREED), ("0" * 32, DISAGREED)):
            self.write("recorded.json", fling(start=start, expect={"state_hash": state_hash}))
            self.check(exit_code, "recorded.json")
        self.write("scenarios/third.json", fling(start=start, expect={"state_hash": known}))
        for suffix, exit_code in (("txt", GOLDEN_MISSING), ("h5", AGREED)):
            (self.folder / f"golden/third.{suffix}").unlink()
            self.check(exit_code)

    def test_an_expectation_that_fails_is_a_disagreement(self):
        start = {**FLING["start"], "vx_px_per_s": 1180}
        self.write("scenarios/third.json", fling(name="third", start=start, expect={"truncation_px_max": 1e-9}))
        self.check(DISAGREED, says="scenarios/third.json: disagreed: expect truncation_px_max: wanted at most 1e-09, measured ")

    def test_a_golden_file_without_scenario_is_unreferenced(self):
        for name, exit_code in (("second", DISAGREED), ("first", BAD_INPUT)):
            (self.folder / f"scenarios/a/{name}.json").unlink()
            self.check(exit_code, "scenarios/a", says=f"golden/a/{name}: unreferenced: no scenario for this golden file: ")

    def test_a_bad_scenario_does_not_keep_the_others_from_being_checked(self):
        self.write("scenarios/a/bad.json", fling(steps=-1))
        self.check(BAD_INPUT, says="scenarios/a/bad.json: failed: scenarios/a/bad.json: /steps: must be")

    def test_the_most_serious_outcome_wins(self):
        self.change_summary("third", lambda _: "")
        (self.folder / "golden/a/first.h5").unlink()
        self.check(GOLDEN_MISSING)
        self.write("scenarios/bad.json", "{")
        self.check(BAD_INPUT)
        self.check(CANNOT_ACCESS, "scenarios", "none.json", says="none.json: cannot be read")

    def test_golden_names_another_folder(self):
        (self.folder / "golden").rename(self.folder / "elsewhere")
        self.check(GOLDEN_MISSING)
        self.check(AGREED, "--golden", "elsewhere")
        self.check(AGREED, "scenarios/a", "--golden", "elsewhere")
