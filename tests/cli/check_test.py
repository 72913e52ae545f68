#!/usr/bin/python3
"""`check`: verdicts, the documents that report them, and that it changes nothing."""

import os
import re
import shutil
import xml.etree.ElementTree

import h5py
import numpy
import xxhash

from process import run
from program import (AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, DIVERGENCE, GOLDEN_MISSING, Maybe, ProgramTest,
                     PROGRAM, few_threads, fling, main)


CHECK = {"checked": int, "agreed": int, "disagreed": int, "missing": int, "failed": int,
         "unreferenced": int, "results": [object], "groups": [object]}
GROUP = {"operation": str, "kind": str, "detail": str, "from": Maybe((int, float)), "to": Maybe((int, float)),
         "scenarios": [str], "reproduced": int, "class": str, "max_px": (int, float), "contacts_moved": int,
         "rest_shift_px": Maybe((int, float))}
RESULT = {"scenario": str, "status": str, "class": Maybe(str), "max_px": Maybe((int, float)), "contacts_moved": Maybe(int),
          "first_divergence": Maybe(DIVERGENCE)}


def nudge(path, dataset, row):
    """Moves one value of a file to the next double."""
    with h5py.File(path, "r+") as file:
        file[dataset][row] = numpy.nextafter(file[dataset][row], numpy.inf)


class CheckTest(ProgramTest):
    """A project with three throws."""

    def setUp(self):
        super().setUp()
        self.project("a/first", "a/second", "third")

    def check(self, exit_code, *arguments, **options):
        """The document of `check --json`."""
        return self.expect(exit_code, "check", "--json", *arguments, **options).json

    def counts(self, document):
        """agreed, disagreed, missing and failed."""
        return tuple(document[key] for key in ("agreed", "disagreed", "missing", "failed"))


class Verdict(CheckTest):
    """Verdicts of `check`."""

    def test_the_default_is_scenarios_and_golden_of_this_folder(self):
        outcome = self.expect(AGREED, "check")
        self.assertEqual(outcome.out, "3 checked: 3 agreed, 0 disagreed, 0 without golden file, 0 failed\n")
        self.assertEqual(outcome.err, "")
        document = self.check(AGREED)
        self.assertEqual([entry["scenario"] for entry in document["results"]],
                         ["scenarios/a/first.json", "scenarios/a/second.json", "scenarios/third.json"])

    def test_it_takes_files_and_folders(self):
        self.assertEqual(self.check(AGREED, "scenarios/a", "scenarios/third.json")["checked"], 3)
        self.assertEqual(self.check(AGREED, "third.json", cwd=self.folder / "scenarios")["checked"], 1)
        self.assertEqual(self.check(AGREED, str(self.folder / "scenarios"))["checked"], 3)

    def test_a_fault_of_one_ulp_is_found_at_its_step_and_field(self):
        golden = self.folder / "golden/third.h5"
        original = golden.read_bytes()
        for row, field in ((0, "x"), (150, "vy"), (300, "t"), (300, "vx")):
            golden.write_bytes(original)
            nudge(golden, f"trajectory/{field}", row)
            document = self.check(DISAGREED)
            self.assertEqual(self.counts(document), (2, 1, 0, 0))
            entry = document["results"][2]
            self.assertEqual((entry["status"], entry["class"]), ("disagreed", "rounding"))
            first = entry["first_divergence"]
            self.assertEqual((first["step"], first["field"], first["ulps"]), (row, field, 1))

    def test_a_difference_is_reported_with_values_rows_and_commands(self):
        nudge(self.folder / "golden/third.h5", "trajectory/vx", 299)
        text = self.expect(DISAGREED, "check", "--verbose").out
        for part in ("scenarios/third.json: disagreed", "class      rounding", "first      step 299, field vx",
                     "expected   ", "actual     ", "(-0x1.", "p-19)", "distance   1 ulp\n", "rows", "297", "298",
                     "hyrax-sim diff golden/third.h5", "hyrax-sim bless scenarios/third.json --reason",
                     "3 checked: 2 agreed, 1 disagreed"):
            self.assertIn(part, text)

    def test_the_largest_distance_and_the_class_are_reported(self):
        entries = self.check(AGREED)["results"]
        self.assertEqual([(entry["max_px"], entry["contacts_moved"]) for entry in entries], 3 * [(0, 0)])
        golden = self.folder / "golden/third.h5"
        original = golden.read_bytes()
        for offset_px, kind in ((0.9e-6, "rounding"), (1.1e-6, "values"), (2.5, "values")):
            golden.write_bytes(original)
            with h5py.File(golden, "r+") as file:
                file["trajectory/x"][150] += offset_px
                file["trajectory/x"][40] -= offset_px / 2
            entry = self.check(DISAGREED)["results"][2]
            self.assertEqual((entry["class"], entry["contacts_moved"]), (kind, 0), offset_px)
            self.assertAlmostEqual(entry["max_px"], offset_px, 11)
        golden.unlink()
        entry = self.check(GOLDEN_MISSING)["results"][2]
        self.assertEqual((entry["class"], entry["max_px"], entry["contacts_moved"]), (None, None, None))

    def test_another_rest_bit_is_of_class_values(self):
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file["trajectory/contact"][-1] ^= 16
        self.assertEqual(self.check(DISAGREED)["results"][2]["class"], "values")

    def test_a_moved_contact_is_of_class_contacts(self):
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file["contacts/step"][2] -= 1
        document = self.check(DISAGREED)
        self.assertEqual(document["results"][2]["class"], "contacts")
        self.assertRegex(self.expect(DISAGREED, "check", "--verbose").out, r"moved      ground step 1\d\d")

    def test_a_golden_file_of_another_scenario_is_of_class_shape(self):
        os.replace(self.folder / "golden/a/first.h5", self.folder / "golden/a/second.h5")
        document = self.check(GOLDEN_MISSING)
        self.assertEqual(document["results"][1]["class"], "shape")
        self.assertIn("the scenario changed since it was blessed", self.expect(DISAGREED, "check", "scenarios/a/second.json").out)

    def test_a_longer_run_is_of_class_shape(self):
        self.write("scenarios/third.json", fling(name="third", steps=301))
        self.assertEqual(self.check(DISAGREED)["results"][2]["class"], "shape")

    def test_name_description_and_expectations_are_not_part_of_the_comparison(self):
        for name in ("new-name", "third"):
            start = {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1180.0, "vy_px_per_s": -4e2}
            self.write("scenarios/third.json", fling(name=name, start=start, description="another text",
                                                     expect={"finite": True}, **{"$schema": "schema.json"}))
            self.assertEqual(self.check(AGREED)["agreed"], 3)

    def test_an_expectation_that_fails_disagrees_even_with_the_golden_file(self):
        start = {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1180, "vy_px_per_s": -400}
        self.write("scenarios/third.json", fling(name="third", start=start, expect={"contacts": {"right": 2}}))
        entry = self.check(DISAGREED)["results"][2]
        self.assertEqual((entry["status"], entry["class"], entry["first_divergence"]), ("disagreed", None, None))
        self.assertEqual(entry["expect"], [{"rule": "contacts/right", "holds": False, "measured": 1}])
        self.assertIn("contacts/right: wanted 2, measured 1", self.expect(DISAGREED, "check").out)

    def test_a_missing_golden_file_is_exit_4(self):
        (self.folder / "golden/third.h5").unlink()
        document = self.check(GOLDEN_MISSING)
        self.assertEqual(self.counts(document), (2, 0, 1, 0))
        text = self.expect(GOLDEN_MISSING, "check").out
        self.assertIn("no golden file at golden/third.h5", text)
        self.assertIn("hyrax-sim bless scenarios/third.json --reason", text)

    def test_a_scenario_outside_of_scenarios_has_no_golden_file(self):
        self.expect(GOLDEN_MISSING, "check", self.write("alone.json", fling()))

    def test_half_a_golden_file_is_missing_even_if_the_expectations_hold(self):
        run = self.expect(AGREED, "run", "scenarios/third.json", "--json").json["runs"][0]
        start = {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1180, "vy_px_per_s": -400}
        self.write("scenarios/third.json", fling(start=start, expect={"state_hash": run["state_hash"]}))
        (self.folder / "golden/third.txt").unlink()
        text = self.expect(GOLDEN_MISSING, "check").out
        self.assertIn("golden/third.h5 exists, but golden/third.txt is missing", text)
        (self.folder / "golden/third.h5").unlink()
        self.check(AGREED)

    def test_an_expected_state_hash_replaces_a_missing_golden_file(self):
        run = self.expect(AGREED, "run", "scenarios/third.json", "--json").json["runs"][0]
        start = {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1180, "vy_px_per_s": -400}
        for state_hash, exit_code in ((run["state_hash"], AGREED), ("0" * 32, DISAGREED)):
            self.write("recorded.json", fling(start=start, expect={"state_hash": state_hash}))
            self.expect(exit_code, "check", "recorded.json")

    def test_no_scenario_is_exit_2(self):
        (self.folder / "empty").mkdir()
        outcome = self.expect(BAD_INPUT, "check", "empty", says="empty: no scenario found (*.json)")
        self.assertEqual(outcome.out, "")
        self.expect(BAD_INPUT, "check", cwd=self.folder / "empty", says="scenarios: no such folder")

    def test_a_bad_scenario_does_not_keep_the_others_from_being_checked(self):
        self.write("scenarios/a/bad.json", fling(steps=-1))
        document = self.check(BAD_INPUT)
        self.assertEqual(self.counts(document), (3, 0, 0, 1))
        self.assertIn("/steps: must be", document["results"][0]["error"])
        self.assertIn("scenarios/a/bad.json: failed", self.expect(BAD_INPUT, "check").out)

    def test_the_most_serious_outcome_wins(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        self.check(DISAGREED)
        (self.folder / "golden/a/first.h5").unlink()
        self.check(GOLDEN_MISSING)
        self.write("scenarios/bad.json", "{")
        self.check(BAD_INPUT)
        self.check(CANNOT_ACCESS, "scenarios", "none.json")

    def test_a_golden_file_that_is_none_is_bad_input(self):
        (self.folder / "golden/third.h5").write_text("no HDF5 file")
        document = self.check(BAD_INPUT)
        self.assertEqual(document["results"][2]["status"], "failed")
        self.assertIn("golden/third.h5: is not an HDF5 file", document["results"][2]["error"])

    def test_one_that_is_a_pipe_is_not_waited_for(self):
        for name in ("golden/third.txt", "golden/third.h5"):
            with self.subTest(name):
                path = self.folder / name
                kept = path.read_bytes()
                path.unlink()
                os.mkfifo(path)
                (error,) = [entry["error"] for entry in self.check(BAD_INPUT)["results"] if entry["status"] == "failed"]
                self.assertEqual(error, f"{name}: is a pipe or a device; a golden file must be a regular file")
                self.expect(BAD_INPUT, "run", "scenarios/third.json", "-o", "out.h5", says=error)
                self.expect(BAD_INPUT, "bless", "scenarios/third.json", "--reason", "again", says=error)
                path.unlink()
                path.write_bytes(kept)

    def test_files_without_valid_checksums_are_read_with_any_number_of_workers(self):
        for path in self.folder.glob("golden/**/*.txt"):
            path.write_text(path.read_text()[:-33] + 32 * "0" + "\n")
        for jobs in (1, 2, 8):
            self.assertEqual(self.counts(self.check(AGREED, "--jobs", str(jobs))), (3, 0, 0, 0))
        for path in self.folder.glob("golden/**/*.h5"):
            nudge(path, "trajectory/y", 5)
        for jobs in (1, 2, 8):
            self.assertEqual(self.counts(self.check(DISAGREED, "--jobs", str(jobs))), (0, 3, 0, 0))

    def test_golden_names_another_folder(self):
        (self.folder / "golden").rename(self.folder / "elsewhere")
        self.check(GOLDEN_MISSING)
        self.check(AGREED, "--golden", "elsewhere")
        self.check(AGREED, "--golden", str(self.folder / "elsewhere"), "scenarios/a")


class Document(CheckTest):
    """How verdicts are printed."""

    def test_json_has_the_published_keys_and_types(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        document = self.check(DISAGREED)
        self.assert_shape(document, CHECK)
        for entry in document["results"]:
            self.assert_shape(entry, RESULT)
        for group in document["groups"]:
            self.assert_shape(group, GROUP)
        self.assertEqual((document["checked"], len(document["groups"])), (3, 1))

    def test_json_has_non_finite_doubles_as_strings(self):
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file["trajectory/y"][5] = numpy.nan
        first = self.check(DISAGREED)["results"][2]["first_divergence"]
        self.assertEqual((first["expected"], first["ulps"]), ("NaN", None))

    def test_junit_is_well_formed_and_counts(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        (self.folder / "golden/a/first.h5").unlink()
        self.write("scenarios/bad <&\">.json", "{")
        self.expect(BAD_INPUT, "check", "--junit", "report.xml")
        suite = xml.etree.ElementTree.parse(self.folder / "report.xml").getroot()
        self.assertEqual(suite.tag, "testsuite")
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("4", "1", "2"))
        cases = {case.get("name"): [child.tag for child in case] for case in suite.iter("testcase")}
        self.assertEqual(cases, {"scenarios/a/first.json": ["error"], "scenarios/a/second.json": [],
                                 "scenarios/bad <&\">.json": ["error"], "scenarios/third.json": ["failure"]})
        self.assertIn("step 5, field y", suite.find(".//failure").text)
        self.assertGreaterEqual(float(suite.get("time")), 0.0)

    def test_junit_is_well_formed_for_any_path(self):
        names = (b"bad \xff\xfe utf8", b"cut \xe2\x82", b"too long \xc0\xaf", b"surrogate \xed\xa0\x80", b"escape \x1b[31m",
                 b"line\nbreak\ttab\rcr", b"\x01\x08\x7f", "nonchar \uffff\ufffe".encode(), "é €𝄞".encode(),
                 b"beyond \xf4\x90\x80\x80", b"]]>&<\"'")
        for name in names:
            (self.folder.joinpath(os.fsdecode(b"scenarios/" + name + b".json"))).write_text("{")
        self.check(BAD_INPUT, "--junit", "report.xml")
        suite = xml.etree.ElementTree.parse(self.folder / "report.xml").getroot()
        cases = [case.get("name") for case in suite.iter("testcase")]
        self.assertEqual(len(set(cases)), len(names) + 3)
        for name in ("bad \\xff\\xfe utf8", "escape \\u001b[31m", "line\nbreak\ttab\\u000dcr", "é €𝄞", "]]>&<\"'"):
            self.assertIn(f"scenarios/{name}.json", cases)

    def test_junit_that_cannot_be_written_is_exit_3(self):
        self.expect(CANNOT_ACCESS, "check", "--junit", "no/such/report.xml", says="no/such/report.xml")

    def test_jobs_change_nothing(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        (self.folder / "golden/a/first.h5").unlink()
        one = self.expect(GOLDEN_MISSING, "check", "--json", "--jobs", "1")
        for jobs in ("2", "4", "64"):
            self.assertEqual(self.expect(GOLDEN_MISSING, "check", "--json", "--jobs", jobs).out, one.out)


class OneVerdict(CheckTest):
    """`check`, `check --quick` and `run` give the same verdict on every changed golden pair."""

    START = {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1180, "vy_px_per_s": -400}

    def setUp(self):
        super().setUp()
        self.h5, self.txt = (self.folder / f"golden/third.{suffix}" for suffix in ("h5", "txt"))
        self.pair = self.h5.read_bytes(), self.txt.read_bytes()

    def scenario(self, **changes):
        """The scenario of the pair, changed."""
        self.write("scenarios/third.json", fling(**{"name": "third", "start": self.START, **changes}))

    def bless_as(self, **changes):
        """The pair is that of a changed scenario."""
        self.scenario(**changes)
        self.bless("scenarios/third.json")
        self.scenario()

    def verdicts(self):
        """Statuses and classes by the three commands; their exit codes must match them."""
        found = []
        for arguments in (("check",), ("check", "--quick")):
            outcome = self.hyrax_sim(*arguments, "--json", "scenarios/third.json")
            entry, = outcome.json["results"]
            self.assertEqual(outcome.exit_code, {"agreed": 0, "disagreed": 1, "missing": 4}[entry["status"]])
            found.append((entry["status"], entry["class"]))
        outcome = self.hyrax_sim("run", "scenarios/third.json", "--json", "-o", "now.h5")
        golden = outcome.json["runs"][0]["golden"]
        self.assertEqual(outcome.exit_code, int(golden["status"] == "disagreed"))
        return [*found, (golden["status"], golden.get("class"))]

    def assert_all_say(self, status, kind, change, *arguments, **changes):
        """After a change of the pair all three have this verdict; the pair is restored."""
        change(*arguments, **changes)
        self.assertEqual(self.verdicts(), 3 * [(status, kind)], f"{change.__name__} {arguments} {changes}")
        self.h5.write_bytes(self.pair[0])
        self.txt.write_bytes(self.pair[1])
        self.scenario()

    def edit_summary(self, old, new):
        """Changes the text of the summary."""
        text = self.txt.read_text()
        self.assertIn(old, text)
        self.txt.write_text(text.replace(old, new))

    def edit_h5(self, path, name, value):
        """Changes an attribute."""
        with h5py.File(self.h5, "r+") as file:
            file[path].attrs[name] = value

    def nudge_under_checksum(self, dataset, row):
        """The pair as a program would have blessed it that differs in one value, and has the same state hash."""
        nudge(self.h5, dataset, row)
        checksums = f"checksums: {32 * 'c'} {xxhash.xxh3_128_hexdigest(self.h5.read_bytes())}\n"
        self.txt.write_text(self.txt.read_text().partition("checksums: ")[0] + checksums)

    def test_on_the_golden_file_of_another_scenario(self):
        for changes in ({"record": {"every": 2}}, {"steps": None, "duration_s": 5}, {"clock": {"dt_s": 1 / 60}},
                        {"start": {**self.START, "y_px": 500.0000000001}}, {"steps": 299},
                        {"events": [{"step": 299, "hitch": {"dt_s": 1 / 60}}]}):
            self.assert_all_say("disagreed", "shape", self.bless_as, **changes)

    def test_on_that_of_a_scenario_that_is_the_same(self):
        for changes in ({}, {"name": "another"}, {"description": "another text"}, {"expect": {"finite": True}},
                        {"$schema": "schema.json"}, {"start": {**self.START, "x_px": 1100.0}}):
            self.assert_all_say("agreed", None, self.bless_as, **changes)

    def test_on_a_run_that_is_the_same_for_a_zero_of_either_sign(self):
        self.START = {**self.START, "vx_px_per_s": 0}
        clock = {"rate_hz": 60, "jitter": {"kind": "normal", "sigma_s": 0, "seed": 1}}
        self.scenario(clock=clock)
        self.bless("scenarios/third.json")
        clock["jitter"]["sigma_s"] = -0.0
        self.scenario(clock=clock)
        self.assertEqual(self.verdicts(), 3 * [("agreed", None)])

    def test_on_what_only_contacts_show(self):
        self.assert_all_say("disagreed", "rounding", self.nudge_under_checksum, "contacts/overshoot", 0)

    def test_on_what_only_times_show(self):
        self.assert_all_say("disagreed", "rounding", self.nudge_under_checksum, "trajectory/t", 7)

    def test_on_a_changed_summary(self):
        for old, new in (("steps: 300", "steps: 301"), ("scenario: third", "scenario: thirD"), ("ground 8\n", "ground 7\n"),
                         ("margin: any", "margin: ani"), ("nearest decision: right", "nearest decision: left"),
                         ("checksums: ", "checksums:  "), ("state hash: ", "state hash: 0"), ("reason: for", "reason for")):
            self.assert_all_say("disagreed", "shape", self.edit_summary, old, new)
        self.assert_all_say("disagreed", "shape", self.txt.write_text, "nothing\n")

    def test_on_fields_that_may_change(self):
        self.assert_all_say("agreed", None, self.edit_summary, "reason: for the test", "reason: for another test")
        self.assert_all_say("agreed", None, self.edit_h5, "provenance", "compiler", "another")

    def test_on_changed_texts_of_the_file(self):
        for place, name, value in (("/", "name", "other"), ("trajectory/x", "units", "m")):
            self.assert_all_say("disagreed", "shape", self.edit_h5, place, name, value)

    def test_on_half_a_pair(self):
        self.assert_all_say("missing", None, self.h5.unlink)
        self.assert_all_say("missing", None, self.txt.unlink)

    def test_quick_reports_a_difference_in_full(self):
        self.scenario(steps=301)
        self.assertEqual(self.check(DISAGREED, "--quick"), self.check(DISAGREED))

    def test_quick_judges_expectations(self):
        self.scenario(expect={"contacts": {"right": 2}})
        self.assertEqual(self.check(DISAGREED, "--quick"), self.check(DISAGREED))


class Unreferenced(CheckTest):
    """Golden files whose scenario was deleted, moved or renamed."""

    def unreferenced(self, exit_code, *arguments, **options):
        """The paths that are reported."""
        document = self.check(exit_code, *arguments, **options)
        found = [entry["scenario"] for entry in document["results"] if entry["status"] == "unreferenced"]
        self.assertEqual(len(found), document["unreferenced"])
        self.assertEqual(len(document["results"]) - len(found), document["checked"])
        return found

    def test_a_renamed_scenario_leaves_one_and_misses_one(self):
        os.replace(self.folder / "scenarios/a/first.json", self.folder / "scenarios/a/new.json")
        self.assertEqual(self.unreferenced(GOLDEN_MISSING), ["golden/a/first"])

    def test_that_of_a_deleted_scenario_is_a_disagreement(self):
        (self.folder / "scenarios/third.json").unlink()
        self.assertEqual(self.unreferenced(DISAGREED), ["golden/third"])
        outcome = self.expect(DISAGREED, "check", "--junit", "report.xml")
        self.assertIn("golden/third: unreferenced: no scenario for this golden file", outcome.out)
        self.assertIn("2 checked: 2 agreed, 0 disagreed, 0 without golden file, 0 failed; 1 unreferenced\n", outcome.out)
        suite = xml.etree.ElementTree.parse(self.folder / "report.xml").getroot()
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("3", "1", "0"))

    def test_each_half_counts_once(self):
        self.write("golden/a/half.txt", "")
        self.write("golden/deep/er/other.h5", "")
        self.write("golden/README.md", "no golden file")
        self.write("golden/folder.txt", "")
        (self.folder / "scenarios/folder.json").mkdir()
        self.assertEqual(self.unreferenced(DISAGREED), ["golden/a/half", "golden/deep/er/other", "golden/folder"])

    def test_only_what_mirrors_the_folders_is_looked_at(self):
        (self.folder / "scenarios/third.json").unlink()
        self.assertEqual(self.unreferenced(AGREED, "scenarios/a"), [])
        self.assertEqual(self.unreferenced(AGREED, "scenarios/a/first.json"), [])
        self.assertEqual(self.unreferenced(DISAGREED, "scenarios/"), ["golden/third"])
        (self.folder / "scenarios/a/first.json").unlink()
        self.assertEqual(self.unreferenced(DISAGREED, "scenarios/a", "scenarios/a/second.json"), ["golden/a/first"])
        self.assertEqual(self.unreferenced(DISAGREED, "scenarios", "scenarios/a"), ["golden/a/first", "golden/third"])
        self.assertEqual(self.unreferenced(DISAGREED, ".", cwd=self.folder / "scenarios/a"),
                         [str(self.folder / "golden/a/first")])

    def test_in_the_folder_of_golden(self):
        (self.folder / "golden").rename(self.folder / "elsewhere")
        (self.folder / "scenarios/third.json").unlink()
        self.assertEqual(self.unreferenced(DISAGREED, "scenarios", "--golden", "elsewhere"), ["elsewhere/third"])
        (self.folder / "scenarios/a").rename(self.folder / "outside")
        self.assertEqual(self.unreferenced(GOLDEN_MISSING, "outside", "--golden", "elsewhere"), [])


class Workers(CheckTest):
    """If some threads cannot be started, the others do the work."""

    def test_without_any_thread_all_verdicts_are_given(self):
        one = self.expect(AGREED, "check", "--json", "--jobs", "1").out
        for allowed in (0, 1):
            outcome = self.expect(AGREED, "check", "--json", "--jobs", "8", env=few_threads(allowed))
            self.assertEqual(outcome.out, one)


class Suggested(CheckTest):
    """The commands that are suggested work when they are pasted into a shell."""

    def paste(self, command, **options):
        """Runs a line in a shell; its exit code."""
        binaries = self.folder / "bin"
        binaries.mkdir(exist_ok=True)
        if not (binaries / "hyrax-sim").exists():
            (binaries / "hyrax-sim").symlink_to(PROGRAM)
        return run("bash", "-c", command, cwd=self.folder,
                   env={**os.environ, "PATH": f"{binaries}:{os.environ['PATH']}"}, **options).exit_code

    def suggestions(self, out):
        """The command lines in a text."""
        return re.findall(r"(?:^|: |  )(hyrax-sim .*)$", out, re.MULTILINE)

    def assert_mended(self, exit_code, *check):
        """`check` suggests a command that makes it agree."""
        suggested = self.suggestions(self.expect(exit_code, *check).out)
        self.assertGreater(len(suggested), 0)
        for command in suggested:
            self.assertIn(self.paste(command), (AGREED, DISAGREED), command)
        self.expect(AGREED, *check)

    def test_for_a_missing_golden_file(self):
        for name in ("plain", "with a space", "it's $HOME `x` \"y\" *", "-dash", "é", "\x1b[31m\nred", "!!"):
            path = f"my folder/scenarios/{name}.json"
            self.write(path, fling())
            self.assert_mended(GOLDEN_MISSING, "check", path)

    def test_with_golden(self):
        for folder in ("else where", "-g"):
            self.assert_mended(GOLDEN_MISSING, "check", "scenarios/third.json", f"--golden={folder}")
            self.write("scenarios/third.json", fling(steps=200))
            self.assert_mended(DISAGREED, "check", "scenarios/third.json", f"--golden={folder}")
            self.project("third")

    def test_outside_of_scenarios(self):
        self.write("my/x.json", fling())
        suggested, = self.suggestions(self.expect(GOLDEN_MISSING, "check", "my/x.json").out)
        self.assertEqual(self.paste(suggested), AGREED)
        self.expect(AGREED, "check", "my/x.json", "--golden", "golden")

    def test_for_a_file_beginning_with_a_dash(self):
        self.write("-x.json", fling(name="x"))
        self.assert_mended(GOLDEN_MISSING, "check", "--golden=golden", "./-x.json")

    def test_by_run(self):
        self.write("scenarios/a b.json", fling(name="a"))
        suggested, = self.suggestions(self.expect(AGREED, "run", "scenarios/a b.json", "--golden", "g h").out)
        self.assertEqual(self.paste(suggested), AGREED)
        self.write("scenarios/a b.json", fling(name="a", steps=20))
        suggested, = self.suggestions(self.expect(DISAGREED, "run", "scenarios/a b.json", "--golden", "g h").out)
        self.assertEqual(self.paste(suggested), DISAGREED)

    def test_for_a_run_of_blocks(self):
        self.write("scenarios/long.json", fling(name="long", steps=9000))
        self.bless("scenarios/long.json")
        self.write("scenarios/long.json", fling(name="long", steps=9001))
        self.assert_mended(DISAGREED, "check", "scenarios/long.json")


class Seal(CheckTest):
    """A summary's checksums make reading the golden file unnecessary, and must never hide a fault in it."""

    def setUp(self):
        super().setUp()
        self.digest = self.folder / "golden/third.txt"
        self.text = self.digest.read_text()
        self.contents, self.file = self.text.splitlines()[-1].split()[1:]

    def test_a_damaged_file_is_found_under_valid_checksums(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        first = self.check(DISAGREED)["results"][2]["first_divergence"]
        self.assertEqual((first["step"], first["field"]), (5, "y"))

    def assert_not_as_blessed(self, text, says):
        """With this digest and an agreeing golden file, `check` names the line; blessing repairs it."""
        self.digest.write_text(text)
        entry = self.check(DISAGREED)["results"][2]
        self.assertEqual((entry["class"], entry["first_divergence"]), ("shape", None))
        said = self.expect(DISAGREED, "check").out
        self.assertIn("after it was blessed: golden/third.txt: line ", said)
        self.assertIn(says, said)
        self.bless("scenarios/third.json")
        self.check(AGREED)

    def test_broken_checksums_disagree(self):
        for text in (self.text.replace("checksums: ", "checksum: "), self.text[:-1],
                     self.text.replace(self.contents, 32 * "0"), self.text.replace(self.file, 32 * "z")):
            self.assert_not_as_blessed(text, f"; expected 'checksums: {self.contents} {self.file}'")
        self.assert_not_as_blessed(self.text + "\n", "(found ''); expected nothing")

    def test_the_digest_of_another_run_disagrees(self):
        for line, other in (("steps: 300", "steps: 301"), ("ground 8\n", "ground 7\n"), ("vy ", "vx ")):
            self.assertIn(line, self.text)
            self.assert_not_as_blessed(self.text.replace(line, other), "; expected '")

    def test_the_reason_in_a_digest_may_change(self):
        self.digest.write_text(self.text.replace("reason: for the test", "reason: for another test"))
        self.check(AGREED)

    def change(self, place, name, value):
        """Changes an attribute of the golden file."""
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file[place].attrs[name] = value

    def test_another_provenance_is_reported_and_agrees(self):
        self.change("provenance", "compiler", "another")
        self.expect(AGREED, "check", says="golden/third.h5: agrees, but does not have the checksum in "
                    "golden/third.txt: its provenance or its layout differs\n")

    def test_changed_texts_disagree(self):
        for place, name, value in (("trajectory/x", "units", "m"), ("contacts/t", "long_name", "time"),
                                   ("trajectory", "signal", "x"), ("trajectory/y", "scale", "1")):
            self.change(place, name, value)
            said = self.expect(DISAGREED, "check").out
            self.assertIn(f"/{place}@{name}", said)
            self.bless("scenarios/third.json")
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            file["more"] = 1
        self.assertIn("/more", self.expect(DISAGREED, "check").out)

    def test_the_digest_of_another_scenario_disagrees(self):
        shutil.copyfile(self.folder / "golden/a/first.txt", self.digest)
        self.check(DISAGREED)
        self.bless("scenarios/third.json")
        self.check(AGREED)


class ReadOnly(CheckTest):
    """`check` never writes into golden/."""

    def test_golden_files_are_unchanged_for_every_verdict(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        self.write("scenarios/a/new.json", fling(name="new"))
        self.write("scenarios/a/first.json", fling(name="first", steps=20))
        before = self.state_of("golden")
        for path in (self.folder / "golden").rglob("*"):
            path.chmod(0o555 if path.is_dir() else 0o444)
        for arguments in ((), ("--quick",), ("--jobs", "4"), ("--golden", "golden")):
            self.check(GOLDEN_MISSING, *arguments)
        self.assertEqual(self.state_of("golden"), before)
        self.assertEqual(self.names(), ["golden", "scenarios"])
        for path in (self.folder / "golden").rglob("*"):
            path.chmod(0o755)


if __name__ == "__main__":
    main()
