"""`bless`: the only command that changes golden files, deliberately and with a reason."""

import json
import os
import re
import shutil
import time

import h5py

from process import run
from program import (AGREED, ANOTHER_START, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, PROGRAM, ProgramTest,
                     fling)


def process_time_s(process_id):
    """How long a process has used a processor."""
    with open(f"/proc/{process_id}/stat", encoding="utf-8") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Bless(ProgramTest):
    """A project with two throws, and one without golden file."""

    def setUp(self):
        super().setUp()
        self.project("fling", "a/other")
        self.write("scenarios/new.json", fling(name="new"))
        self.before = self.state_of("golden")

    def assert_golden_untouched(self):
        """Not a byte and not a time stamp has changed."""
        self.assertEqual(self.state_of("golden"), self.before)

    def test_it_makes_a_golden_file_that_check_agrees_with(self):
        self.expect(GOLDEN_MISSING, "check")
        outcome = self.expect(AGREED, "bless", "scenarios/new.json", "--reason", os.fsdecode(b"a\x1b[31m\xff\n\xc3\xa9"))
        self.assertIn("scenarios/new.json: new golden file", outcome.out)
        self.assertIn("golden/new.h5", outcome.out)
        self.assertEqual(self.names("golden"), ["a", "core", "fling.h5", "fling.txt", "new.h5", "new.txt"])
        summary = (self.folder / "golden/new.txt").read_text(encoding="utf-8")
        self.assertIn("\nreason: a\\u001b[31m\\xff é\n", summary)
        self.expect(AGREED, "check")
        self.expect(BAD_INPUT, "check", "--quick", says="--quick: was removed; leave it out")

    def test_verbose_shows_the_first_difference(self):
        self.write("scenarios/fling.json", fling(start=ANOTHER_START))
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "further left", "--verbose")
        for part in ("class      shape", "first      step 0, field x", "expected   1100 ", "actual     1000 ",
                     "moved      right step 36"):
            self.assertIn(part, outcome.out)

    def test_it_refuses_a_run_whose_expectations_do_not_hold_changed_or_not(self):
        for name, document, says in (
                ("fling", fling(expect={"finite": False}), "its expectations do not hold; finite: wanted false, measured true"),
                ("fling", fling(start=ANOTHER_START, expect={"final_x_px": [0, 1]}), "final_x_px: wanted 0 .. 1, measured "),
                ("new", fling(name="new", expect={"contacts": {"top": 1}}), "contacts/top")):
            self.write(f"scenarios/{name}.json", document)
            self.expect(DISAGREED, "bless", f"scenarios/{name}.json", "--reason", "wishful",
                        says=(f"scenarios/{name}.json: not blessed: ", says))
        self.assert_golden_untouched()

    def test_agreeing_golden_files_are_left_unchanged(self):
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "scenarios/a", "--reason", "once more")
        self.assertEqual(outcome.out.count("agrees with golden/"), 2)
        self.assert_golden_untouched()
        self.bless("scenarios/new.json")
        self.assertEqual(self.expect(AGREED, "bless", "scenarios", "--reason", "once more").out.count("agrees with golden/"), 3)

    def test_on_a_full_disk_it_says_how_many_were_written(self):
        self.write("scenarios/c/long.json", fling(name="long", steps=1990))
        self.write("scenarios/c/short.json", fling(name="short", steps=5))
        (self.folder / "golden/c").mkdir()
        for suffix in ("h5", "txt"):
            shutil.copy(self.folder / f"golden/fling.{suffix}", self.folder / f"golden/c/old.{suffix}")
        command = (PROGRAM, "bless", "scenarios/c", "--reason", "x", "--prune")
        (self.folder / "scenarios/new.json").unlink()
        shutil.rmtree(self.folder / "golden/core")
        small_disk = ("sh", "-c", 'ulimit -f 180; exec "$@"', "sh", *command)
        outcome = run(*small_disk, cwd=self.folder)
        self.assertEqual(outcome.exit_code, CANNOT_ACCESS, outcome)
        self.assertIn("golden/c/long.h5: cannot be written: File too large\nhyrax-sim bless: 1 of 2 scenarios blessed, "
                      "1 could not be written; the same command completes it\n", outcome.err)
        self.assertIn("\ncore: not accepted in golden/core: not every golden file could be written\n", outcome.out)
        self.assertNotIn("removed", outcome.out)
        self.assertEqual(self.names("golden/c"), ["old.h5", "old.txt", "short.h5", "short.txt"])
        self.assertFalse((self.folder / "golden/core").exists())
        document = run(*small_disk, "--json", cwd=self.folder).json
        self.assertEqual((document["failed"], document["written"]), (1, False))
        self.expect(AGREED, *command[1:])
        self.expect(AGREED, "check", "scenarios/c")

    def test_one_that_fails_keeps_all_from_being_written(self):
        self.write("scenarios/fling.json", fling(start=ANOTHER_START))
        for document, exit_code, says in (("{", BAD_INPUT, "zz.json: line 1"),
                                          (fling(expect={"contacts": {"top": 1}}), DISAGREED, "zz.json: not blessed")):
            self.write("scenarios/zz.json", document)
            outcome = self.expect(exit_code, "bless", "scenarios", "--reason", "all",
                                  says=(says, "nothing written: 1 of 4 scenarios failed\n"))
            self.assertIn("scenarios/fling.json: changes golden/fling.h5", outcome.out)
            self.assertNotIn(": blessed", outcome.out)
            document = self.expect(exit_code, "bless", "scenarios", "--reason", "all", "--json").json
            self.assertEqual([document[key] for key in ("new", "changed", "failed", "written")], [1, 1, 1, False])
            self.assertEqual([(entry["status"], entry["class"]) for entry in document["results"]],
                             [("unchanged", None), ("changed", "shape"), ("new", None), ("failed", None)])
            self.assert_golden_untouched()
        self.expect(CANNOT_ACCESS, "bless", "scenarios", "no-such.json", "--reason", "all", says="no-such.json")
        (self.folder / "scenarios/zz.json").rename(self.folder / "scenarios/file.json")
        self.write("scenarios/file.json", fling(name="file"))
        (self.folder / "golden/file.h5").mkdir()
        self.expect(CANNOT_ACCESS, "bless", "scenarios", "--reason", "all", says="golden/file.h5")
        self.assert_golden_untouched()

    def test_a_file_that_is_edited_while_it_plays_keeps_all_from_being_written(self):
        """Whether it is to be written or not; what was shown is what would have been."""
        jitter = {"kind": "uniform", "fraction": 0.1, "seed": 1}
        self.write("scenarios/zz.json", fling(name="zz", steps=10**7, clock={"rate_hz": 60, "jitter": jitter}, record={"every": 10**6}))
        for path, text in (("scenarios/fling.json", json.dumps(fling(start=ANOTHER_START))), ("golden/a/other.txt", "edited\n")):
            process = self.begin("bless", "scenarios", "--reason", "x", "--update-hash")
            while process_time_s(process.id) < 0.1:  # The others were read.
                time.sleep(0.01)
            self.write(path, text)
            before = self.state_of(".")
            outcome = process.wait()
            self.assertEqual(outcome.exit_code, CANNOT_ACCESS, outcome)
            named = path.replace(".txt", ".h5")
            self.assertEqual(outcome.err, f"hyrax-sim bless: nothing written: {named}: was changed by another program while it was "
                                          "played; bless again\n")
            self.assertEqual(self.state_of("."), before)

    def test_all_targets_are_tried_before_the_first_write(self):
        shutil.rmtree(self.folder / "golden/core")
        for in_the_way, says in ((lambda: self.write("golden/core", ""), "golden/core/physics.h: cannot be written: Not a directory"),
                                 (lambda: (self.folder / "golden/core/step.txt").mkdir(parents=True), "golden/core/step.txt: cannot be written: Is a directory")):
            in_the_way()
            before = self.state_of(".")
            for options in (("--dry-run",), ()):
                self.expect(CANNOT_ACCESS, "bless", "scenarios", "--reason", "x", *options, says=says)
                self.assertEqual(self.state_of("."), before)
            core = self.folder / "golden/core"
            core.unlink() if core.is_file() else shutil.rmtree(core)

    def test_it_refuses_two_scenarios_of_one_golden_file(self):
        for name in ("one", "two"):
            self.write(f"{name}/x.json", fling(name="x", steps=100 if name == "one" else 200))
        (self.folder / "link").symlink_to("g")
        for golden in ("g", "./g/", "link"):
            self.expect(BAD_INPUT, "bless", "one/x.json", "two/x.json", "--golden", golden, "--reason", "both",
                        says=("two/x.json: has the same golden file as one/x.json", "nothing written"))
            self.assertFalse((self.folder / "g").exists())
        (self.folder / "linked").symlink_to("one")
        self.expect(AGREED, "bless", "one/x.json", "./one/x.json", "linked/x.json", "--golden", "g", "--reason", "once")
        self.assertEqual(self.names("g"), ["x.h5", "x.txt"])

    def test_it_never_overwrites_a_scenario(self):
        for name in ("x.h5", "x.txt"):
            text = json.dumps(fling(name="x"))
            self.write(name, text)
            self.expect(BAD_INPUT, "bless", name, "--golden", ".", "--reason", "x", says=("would overwrite an input", name))
            self.assertEqual((self.folder / name).read_text(), text)
            self.assertFalse((self.folder / f"x.{'txt' if name == 'x.h5' else 'h5'}").exists())
            (self.folder / name).unlink()

    def test_a_new_name_is_taken_into_both_files(self):
        self.write("scenarios/fling.json", fling(name="renamed", start={**fling()["start"], "vx_px_per_s": 1200}))
        self.expect(AGREED, "check", "scenarios/fling.json")
        self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "renamed")
        self.expect(AGREED, "check", "scenarios/fling.json")
        with h5py.File(self.folder / "golden/fling.h5") as file:
            self.assertEqual(file.attrs["name"], "renamed")
        self.assertIn("scenario: renamed\n", (self.folder / "golden/fling.txt").read_text())

    def test_rows_that_agree_are_written_again_where_what_describes_them_is_another(self):
        rows = self.folder / "golden/fling.h5"
        for name, value in (("name", "other"), ("physics", "hyrax-physics/2"), ("constants", None)):
            with h5py.File(rows, "r+") as file:
                del file.attrs[name]
                if value:
                    file.attrs[name] = value
            self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", name)
            self.assertEqual(rows.read_bytes(), self.before[str(rows)][0], name)

    def test_only_the_summary_of_a_run_that_agrees_is_written(self):
        digest = self.folder / "golden/fling.txt"
        digest.write_text(digest.read_text().replace("steps: 300", "steps: 301"))
        time = (self.folder / "golden/fling.h5").stat().st_mtime_ns
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "once more")
        for part in ("golden/fling.txt: its checksums are not those of its lines and of golden/fling.h5",
                     "its summary, golden/fling.txt, is written again"):
            self.assertIn(part, outcome.out)
        self.assertIn("\nreason: once more\n", digest.read_text())
        self.assertEqual((self.folder / "golden/fling.h5").stat().st_mtime_ns, time)
        self.expect(AGREED, "check", "scenarios/fling.json")

    def test_a_damaged_or_half_golden_file_is_made_again(self):
        cases = (("h5", lambda _: "damaged", "a golden file that cannot be read"), ("h5", None, "(golden/case-1.h5 is missing)"),
                 ("txt", None, "a golden file that cannot be read (golden/case-2.txt is missing)"),
                 ("txt", lambda _: "nothing\n", ""), ("txt", lambda text: text.replace("state hash: ", "state hash: 0"), ""),
                 ("txt", lambda text: text.replace(text.split("state hash: ")[1][:32], 32 * "0"), ""))
        paths = self.project(*(f"case-{number}" for number in range(len(cases))))
        before = self.state_of("golden")
        for number, (suffix, damaged, _) in enumerate(cases):
            path = self.folder / f"golden/case-{number}.{suffix}"
            text = path.read_text() if suffix == "txt" else ""
            path.unlink()
            if damaged is not None:
                path.write_text(damaged(text))
        out = self.expect(AGREED, "bless", *paths, "--reason", "for the test").out
        for number, (_, _, says) in enumerate(cases):
            self.assertRegex(out, rf"scenarios/case-{number}\.json: .*{re.escape(says)}")
        self.assertEqual({path: content for path, (content, _) in self.state_of("golden").items()},
                         {path: content for path, (content, _) in before.items()})
        self.assertEqual(self.expect(AGREED, "bless", *paths, "--reason", "once more").out,
                         "6 scenarios: agree with their golden files already\n")

    def test_what_cannot_be_written_is_exit_3_and_leaves_no_part(self):
        (self.folder / "golden/new.txt").mkdir()
        self.expect(CANNOT_ACCESS, "bless", "scenarios/new.json", "--reason", "x", says="golden/new.txt")
        self.assertEqual(self.names("golden"), ["a", "core", "fling.h5", "fling.txt", "new.txt"])
        self.write("file", "in the way")
        self.expect(CANNOT_ACCESS, "bless", "scenarios/new.json", "--reason", "x", "--golden", "file")
