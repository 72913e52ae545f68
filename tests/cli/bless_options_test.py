"""`bless` with --accept, --update-hash and --prune."""

import json
import os
import shutil

import h5py

from process import succeed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, ProgramTest, fling


class Accept(ProgramTest):
    """The widest difference that may be blessed."""

    def setUp(self):
        super().setUp()
        self.project("a", "b", "c")

    def differ(self, kind, name="a"):
        """Changes the golden file, so that the run differs from it in this class."""
        with h5py.File(self.folder / f"golden/{name}.h5", "r+") as file:
            if kind == "contacts":
                file["contacts/step"][1] += 1
            else:
                file["trajectory/x"][100] += 1e-7 if kind == "rounding" else 0.5

    def bless_accepting(self, exit_code, accepted, *options, **expected):
        """`bless --accept` of all; its document."""
        choice = () if accepted is None else ("--accept", accepted)
        outcome = self.expect(exit_code, "bless", "scenarios", "--json", "--reason", "for the test", *choice, *options,
                              **expected)
        return outcome.json

    def test_what_git_ignores_of_it_is_said(self):
        succeed("git", "init", "-q", self.folder)
        golden = self.folder.resolve() / "golden"
        for ignored, says in (("core\nb.*\n", f"{golden}/b.h5: ignored by git (and 4 more): another checkout will not have it; to see why: "
                               f"git check-ignore -v {golden}/b.h5\n"), ("c\n", "")):
            self.write(".gitignore", ignored)
            shutil.rmtree(golden)
            self.assertEqual(self.expect(AGREED, "bless", "scenarios", "--reason", "x").err, says)

    def test_a_wider_class_than_the_accepted_one_is_refused(self):
        for kind, refused in (("rounding", None), ("values", "rounding"), ("contacts", "values")):
            self.differ(kind)
            before = self.state_of("golden")
            if refused is not None:
                says = f"1 of 3 scenarios differ by more than --accept allows; --accept {kind} accepts all of them"
                document = self.bless_accepting(DISAGREED, refused, says=says)
                self.assertEqual((document["changed"], document["refused"], document["written"]), (0, 1, False))
                self.assertEqual([(entry["status"], entry["class"]) for entry in document["results"]],
                                 [("refused", kind), ("unchanged", None), ("unchanged", None)])
                group, = document["groups"]
                self.assertEqual((group["scenarios"], group["class"], group["operation"]),
                                 (["scenarios/a.json"], kind, "golden"))
                self.assertEqual(self.state_of("golden"), before)
            document = self.bless_accepting(AGREED, kind)
            self.assertEqual((document["changed"], document["refused"], document["written"]), (1, 0, True))
        self.expect(AGREED, "check")
        self.differ("values")
        self.bless_accepting(AGREED, "contacts")

    def test_one_that_is_refused_keeps_all_from_being_written(self):
        self.differ("contacts", "c")
        self.differ("values", "b")
        self.differ("rounding", "a")
        self.write("scenarios/new.json", fling(name="new"))
        before = self.state_of("golden")
        document = self.bless_accepting(
            DISAGREED, None, says="2 of 4 scenarios differ by more than --accept allows; --accept contacts")
        self.assertEqual((document["new"], document["changed"], document["refused"]), (1, 1, 2))
        self.assertEqual(self.state_of("golden"), before)
        self.bless_accepting(AGREED, "contacts")
        self.expect(AGREED, "check")

    def test_a_golden_file_without_its_rows_needs_shape_unless_its_summary_has_the_run(self):
        damage = ((lambda: (self.folder / "golden/a.h5").unlink()), (lambda: self.write("golden/a.h5", "damaged")))
        for harm in damage:
            harm()
            self.bless_accepting(AGREED, None)
            summary = self.folder / "golden/a.txt"
            summary.write_text(summary.read_text().replace("state hash: ", "state hash: 0"))
            harm()
            self.bless_accepting(DISAGREED, "contacts", says="--accept shape accepts all of them")
            self.bless_accepting(AGREED, "shape")

    def test_a_dry_run_writes_nothing(self):
        self.differ("rounding")
        self.write("scenarios/new.json", fling(name="new", expect={"state_hash": 32 * "0"}))
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "x", "--dry-run", says="state_hash")
        before = self.state_of(".")
        outcome = self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--dry-run", "--update-hash")
        for part in ("scenarios/a.json: changes golden/a.h5", "new.json: new golden file", "dry run: nothing written\n"):
            self.assertIn(part, outcome.out)
        self.assertNotIn(": blessed", outcome.out)
        self.assertFalse(self.bless_accepting(AGREED, None, "--dry-run", "--update-hash")["written"])
        self.assertEqual(self.state_of("."), before)


class Update(ProgramTest):
    """A scenario file in a layout of its own."""

    def setUp(self):
        super().setUp()
        self.text = json.dumps(fling(), indent=3).replace("1200", "1.2e3")[:-2]
        self.path = self.folder / "scenarios/fling.json"

    def scenario(self, expect):
        """Writes the scenario with that text of `expect`, in a layout of its own."""
        self.write("scenarios/fling.json", f"{self.text} ,\n\n\t\"expect\":{expect}  }}\n ")
        return self.path.read_text()

    # --- --update-hash: the scenario file gets the new state hash, and nothing else in it changes

    def test_a_stale_hash_is_replaced_and_the_mode_of_the_file_kept(self):
        before = self.scenario('{"finite": true , "state_hash":"' + 32 * "0" + '"}')
        self.path.chmod(0o600)
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "x", says="state_hash: wanted 0000")
        self.assertEqual(self.path.read_text(), before)
        outcome = self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--update-hash")
        self.assertIn("scenarios/fling.json: expect.state_hash updated\n", outcome.out)
        run = self.expect(AGREED, "run", "scenarios/fling.json", "--json").json["runs"][0]
        self.assertEqual(self.path.read_text(), before.replace(32 * "0", run["state_hash"]))
        self.assertEqual(self.path.stat().st_mode & 0o777, 0o600)
        self.expect(AGREED, "check")
        with h5py.File(self.folder / "golden/fling.h5") as file:
            self.assertEqual(json.loads(file.attrs["scenario"])["expect"]["state_hash"], run["state_hash"])
        now = self.state_of(".")
        self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--update-hash")
        self.assertEqual(self.state_of("."), now)

    def test_of_a_run_that_agrees_a_stale_hash_is_replaced_and_a_missing_one_stays_missing(self):
        before = self.scenario('{"finite": true}')
        self.bless("scenarios")
        for option in ("--update-hash", "--update-expect"):
            self.expect(AGREED, "bless", "scenarios", "--reason", "x", option)
            self.assertEqual(self.path.read_text(), before)
        before = self.scenario('{"state_hash": "' + 32 * "f" + '"}')
        golden = self.state_of("golden")
        document = self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--update-hash", "--json").json
        self.assertEqual((document["unchanged"], document["results"][0]["updates_hash"]), (1, True))
        self.assertEqual(self.state_of("golden"), golden)
        self.assertEqual(len(self.path.read_text()), len(before))
        self.expect(AGREED, "check")

    def test_other_expectations_must_hold(self):
        before = self.scenario('{"final_x_px": [0, 1], "state_hash": "' + 32 * "f" + '"}')
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "x", "--update-hash", says="final_x_px")
        self.assertEqual(self.path.read_text(), before)
        self.assertFalse((self.folder / "golden").exists())

    # --- --update-expect: new values for counts and ranges that no longer hold, too

    def update(self, exit_code=AGREED, *options, **expected):
        """Blesses with --update-expect; the text of the scenario file then."""
        self.expect(exit_code, "bless", "scenarios", "--reason", "x", "--update-expect", *options, **expected)
        return self.path.read_text()

    def test_ranges_keep_their_width_and_digits_and_nothing_else_changes(self):
        before = self.scenario('{"final_x_px":[ 0,\n 7 ], "final_y_px": [ 0, 10.0], "at_rest_since_s": [0, 5e-1],\n'
                               '"contacts":{"left" : 0, "right": 5 ,"ground":[1, 3], "top": [2,5]}, "finite": true}')
        run, = self.expect(AGREED, "run", "scenarios/fling.json", "--set", "/expect={}", "--json", "-o", "x.h5").json["runs"]
        x_px, y_px, since_s, ground = run["final"]["x_px"], run["final"]["y_px"], run["at_rest_since_s"], run["contacts"]["ground"]
        self.assertEqual((run["contacts"]["right"], run["contacts"]["top"]), (1, 0))
        self.assertEqual(self.update(AGREED, "--dry-run"), before)
        after = self.update()
        low_px, low_s = round(x_px - 3.5), round(since_s - 0.25, 1)
        self.assertEqual(after, before.replace("[ 0,\n 7 ]", f"[ {low_px},\n {low_px + 7} ]")
                         .replace("[ 0, 10.0]", f"[ {y_px - 5:.1f}, {y_px + 5:.1f}]").replace("[0, 5e-1]", f"[{low_s:.1f}, {low_s + 0.5:.1f}]")
                         .replace('"right": 5', '"right": 1').replace("[1, 3]", f"[{ground - 1}, {ground + 1}]").replace("[2,5]", "[0,3]"))
        self.expect(AGREED, "check")
        self.assertEqual(self.update(), after)

    def test_a_range_has_more_digits_only_where_the_value_would_be_outside(self):
        x_px = self.expect(AGREED, "run", self.write("x.json", fling()), "--json").json["runs"][0]["final"]["x_px"]
        self.assertEqual(f"{x_px:.3f}", "345.341")
        for range_before, range_after in (("[600, 700]", "[295, 395]"), ("[600.0, 700]", "[295.3, 395.3]"), ("[1e1, 2e1]", "[340, 350]"),
                                          ("[7, 7]", f"[{x_px!r}, {x_px!r}]"), ("[0.00, 0.01]", "[345.34, 345.35]"),
                                          ("[1.5e-1, 0.2]", "[345.32, 345.37]"), ("[7.0001, 7.0002]", f"[{x_px - 5e-5:.4f}, {x_px + 5e-5:.4f}]")):
            before = self.scenario(f'{{"final_x_px": {range_before}}}')
            self.assertEqual(self.update(), before.replace(range_before, range_after))
        for range_before, range_after in (("[7.0, 7.5]", "[-0.2, 0.3]"), ("[5, 6]", "[0, 1]")):
            self.text = self.text.replace('"x_px": 1100', '"x_px": 0').replace("1.2e3", "0").replace("-400", "0")
            before = self.scenario(f'{{"final_x_px": {range_before}}}')
            self.assertEqual(self.update(), before.replace(range_before, range_after))

    def test_what_it_never_updates_is_named_and_nothing_is_written(self):
        for rule, says in (('"in_bounds": false', "in_bounds: wanted false, measured true"),
                           ('"at_rest_since_s": 1', "at_rest_since_s: wanted at most 1"),
                           ('"implementation_px_max": 0', "implementation_px_max: wanted at most 0"),
                           ('"contacts": {"right": 1}, "at_rest_since_s": [99, 100]', "")):
            before = self.scenario('{"final_x_px": [0, 1], %s}' % rule)
            if not says:  # It has not settled within the first second.
                before = before.replace('"steps": 300', '"steps": 60')
                self.write("scenarios/fling.json", before)
                says = "at_rest_since_s: wanted 99 .. 100, measured none"
            self.assertEqual(self.update(DISAGREED, says=["scenarios/fling.json: not blessed: ", says]), before)
            self.assertFalse((self.folder / "golden").exists())

    def test_it_says_what_changes(self):
        self.scenario('{"state_hash": "' + 32 * "f" + '", "contacts": {"right": 5}}')
        out = self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--update-expect").out
        self.assertIn("scenarios/fling.json: new expect.state_hash; expect contacts/right: wanted 5, measured 1\n", out)
        self.assertIn("scenarios/fling.json: expect updated\n", out)
        self.path.write_text(self.path.read_text().replace('"right": 1', '"right": 5'))  # The hash stays right.
        out = self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--update-expect", "--dry-run").out
        self.assertIn("\nscenarios/fling.json: new expect contacts/right: wanted 5, measured 1\n", out)


class Prune(ProgramTest):
    """`--prune` removes golden files without a scenario."""

    def setUp(self):
        super().setUp()
        self.project("fling", "a/other", "a/b/deep")

    def test_unreferenced_golden_files_are_removed(self):
        for name in ("fling", "a/b/deep"):
            (self.folder / f"scenarios/{name}.json").unlink()
        (self.folder / "golden/fling.txt").unlink()
        (self.folder / "golden/a/b/deep.h5").unlink()
        self.write("golden/README.md", "no golden file")
        before = self.state_of(".")
        outcome = self.expect(AGREED, "bless", "--prune", "--dry-run")
        self.assertIn("golden/fling.h5: has no scenario\n", outcome.out)
        self.assertEqual(self.state_of("."), before)
        document = self.expect(AGREED, "bless", "--prune", "--json").json
        self.assertEqual(document["pruned"], ["golden/a/b/deep.txt", "golden/fling.h5"])
        kept = {path: state for path, state in before.items() if not path.endswith(tuple(document["pruned"]))}
        self.assertEqual(self.state_of("."), kept)
        self.expect(AGREED, "check")
        self.assertEqual(self.expect(AGREED, "bless", "--prune").out, "no golden file without a scenario\n")

    def test_what_bless_did_not_write_stays(self):
        self.write("golden/README.txt", "about this folder")
        self.write("golden/data.h5", "no HDF5")
        self.write("golden/a/other.txt", "notes")
        with h5py.File(self.folder / "golden/foreign.h5", "w") as file:
            file["x"] = [1, 2]
        (self.folder / "golden/away.h5").symlink_to("/no/such/file.h5")
        os.mkfifo(self.folder / "pipe")
        for suffix in ("h5", "txt"):
            (self.folder / f"golden/pipe.{suffix}").symlink_to("../pipe")
        before = self.state_of("golden")
        for name in ("fling", "a/other"):
            (self.folder / f"scenarios/{name}.json").unlink()
        outcome = self.expect(AGREED, "bless", "--prune",
                              says=[f"golden/{name}: has no scenario; left" for name in
                                    ("README.txt", "a/other.txt", "away.h5", "data.h5", "foreign.h5", "pipe.h5", "pipe.txt")])
        self.assertTrue((self.folder / "golden/pipe.h5").is_symlink())
        self.assertIn("golden/fling.h5: removed\ngolden/fling.txt: removed\n", outcome.out)
        self.assertEqual(self.state_of("golden"),
                         {path: state for path, state in before.items() if "golden/fling." not in path and "other.h5" not in path})

    def test_of_a_link_only_the_link_is_removed(self):
        (self.folder / "golden/fling.h5").rename(self.folder / "kept.h5")
        (self.folder / "golden/fling.h5").symlink_to("../kept.h5")
        (self.folder / "golden/a").rename(self.folder / "elsewhere")
        (self.folder / "golden/a").symlink_to("../elsewhere")
        for name in ("fling", "a/other"):
            (self.folder / f"scenarios/{name}.json").unlink()
        self.expect(BAD_INPUT, "bless", "--prune", "scenarios/a", says="nothing removed: golden/a: is a link")
        self.expect(AGREED, "bless", "--prune")
        self.assertEqual(self.names("golden"), ["a", "core"])
        self.assertTrue((self.folder / "kept.h5").exists() and (self.folder / "elsewhere/other.h5").exists())
        self.expect(AGREED, "bless", "--prune", "scenarios", "--golden", "elsewhere/..//golden")

    def test_nothing_is_removed_where_scenarios_may_be_unseen(self):
        (self.folder / "scenarios/fling.json").unlink()
        shutil.rmtree(self.folder / "scenarios/a/b")
        before = self.state_of("golden")

        def refused(exit_code, says):
            self.expect(exit_code, "bless", "--prune", says=["--prune: nothing removed: ", says])
            self.assertEqual(self.state_of("golden"), before)
        for target, name in (("/not/mounted", "a/b"), ("/not/mounted.json", "fling.json"), ("/v", "a/v1.2")):
            link = self.folder / "scenarios" / name
            link.symlink_to(target)
            if name == "a/v1.2":
                (self.folder / "golden/a/b").rename(self.folder / "golden/a/v1.2")
                before = self.state_of("golden")
            refused(CANNOT_ACCESS, f"scenarios/{name}: cannot be read: No such file or directory")
            link.unlink()
        self.write("scenarios/fling.JSON", fling())
        refused(BAD_INPUT, "scenarios/fling.JSON: unknown suffix")
        (self.folder / "scenarios/fling.JSON").unlink()
        self.expect(AGREED, "bless", "--prune")

    def test_only_in_the_folders_given_and_with_a_reason_it_blesses_as_well_unless_that_is_refused(self):
        (self.folder / "scenarios/a/other.json").unlink()
        (self.folder / "scenarios/fling.json").unlink()
        self.write("scenarios/bad.json", "{")
        self.expect(BAD_INPUT, "bless", "scenarios", "--prune", "--reason", "x", says="nothing written")
        self.assertTrue((self.folder / "golden/fling.h5").exists())
        self.expect(AGREED, "bless", "--prune", "scenarios/a")
        self.assertEqual((self.names("golden"), self.names("golden/a")), (["a", "core", "fling.h5", "fling.txt"], ["b"]))
        self.write("scenarios/bad.json", fling(name="renamed"))
        (self.folder / "golden").rename(self.folder / "elsewhere")
        self.expect(AGREED, "bless", "scenarios", "--golden", "elsewhere", "--prune", "--reason", "renamed")
        self.assertEqual(self.names("elsewhere"), ["a", "bad.h5", "bad.txt", "core"])
        self.expect(AGREED, "check", "--golden", "elsewhere")
