"""`check`: verdicts, and that it changes nothing."""

import json
import os
import shutil

import h5py

from check_program import CheckTest, nudge
from process import run, succeed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE, few_threads, fling


class Verdict(CheckTest):
    def test_the_default_is_scenarios_and_golden_of_this_folder_and_each_is_checked_once(self):
        outcome = self.expect(AGREED, "check", "--annotate", "github")
        self.assertEqual(outcome.out, "3 checked: 3 agreed, 0 disagreed, 0 without golden file, 0 failed\n")
        self.assertEqual(outcome.err + self.expect(AGREED, "check", "--json", "--annotate", "github").err, "")
        self.assertEqual(self.check(AGREED, "scenarios/third.json", "./scenarios/third.json", "scenarios")["checked"], 3)

    def test_another_scenario_in_the_golden_file_is_no_edit_of_the_scenario(self):
        with h5py.File(self.folder / "golden/third.h5", "r+") as file:
            scenario = json.loads(file.attrs["scenario"])
            scenario["start"]["vx_px_per_s"] = 9
            file.attrs.modify("scenario", json.dumps(scenario))
        document = self.check(DISAGREED)
        self.assertEqual((document["results"][2]["class"], document["groups"][0]["operation"]), ("shape", "golden"))
        out = self.expect(DISAGREED, "check").out
        self.assertIn("1 of 3 scenarios differs: the golden file was changed since it was blessed: golden/third.h5: "
                      "its scenario does not give its rows; restore it", out)
        self.assertNotIn("the scenario changed", out)
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "x", "--dry-run",
                    says="nothing written: 1 of 3 scenarios differ by more than --accept allows; --accept shape")

    def test_without_memory_it_says_so_and_threads_take_none_that_it_needs(self):
        if self.is_sanitized():
            self.skipTest("a sanitizer takes memory of its own")
        shutil.copytree(SOURCE / "scenarios/clocks", self.folder / "scenarios/clocks")
        self.bless("scenarios/clocks")  # Long enough that several workers need memory at once.
        has_agreed = False
        for limit_kb in (14000, 17000, 19500, 20500, 21500, 23000):
            outcome = run("sh", "-c", f'ulimit -v {limit_kb}; exec "$@"', "sh", PROGRAM, "check", "--jobs", "4", cwd=self.folder)
            self.assertIn(outcome.exit_code, (AGREED,) if has_agreed else (AGREED, 70, 127), outcome)  # 127: it could not be loaded.
            has_agreed = outcome.exit_code == AGREED
            self.assertNotIn("internal error", outcome.out + outcome.err)
            if outcome.exit_code == 70:
                self.assertIn("out of memory", outcome.out + outcome.err)

    def test_a_folder_without_scenarios_is_in_every_document(self):
        (self.folder / "empty").mkdir()
        out = self.expect(BAD_INPUT, "check", "scenarios", "empty", "--annotate", "github", "--junit", "a.xml", "--summary", "a.md").out
        self.assertTrue(out.endswith("\n::error title=hyrax-sim check%3A folder::empty: no scenario found (*.json)\n"), out)
        self.assertIn('<error message="folder: empty: no scenario found', (self.folder / "a.xml").read_text())
        self.assertIn("check: not agreed\n", (self.folder / "a.md").read_text())

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


class Unreferenced(CheckTest):
    """Golden files whose scenario was deleted, moved or renamed."""

    def unreferenced(self, exit_code, *arguments, **options):
        document = self.check(exit_code, *arguments, **options)
        found = [entry["scenario"] for entry in document["results"] if entry["status"] == "unreferenced"]
        self.assertEqual(len(found), document["unreferenced"])
        self.assertEqual(len(document["results"]) - len(found), document["checked"])
        return found

    def test_a_renamed_scenario_leaves_one_and_misses_one(self):
        os.replace(self.folder / "scenarios/a/first.json", self.folder / "scenarios/a/new.json")
        shutil.copy(self.folder / "scenarios/a/new.json", self.folder / "scenarios/twin.json")
        self.assertEqual(self.unreferenced(GOLDEN_MISSING), ["golden/a/first"])
        command = "mv golden/a/first.h5 golden/a/new.h5 && mv golden/a/first.txt golden/a/new.txt"
        out = self.expect(GOLDEN_MISSING, "check").out
        self.assertEqual(out, "scenarios/a/new.json: missing: renamed: golden/a/first has the same run; to rename that: "
                              f"{command}\nscenarios/twin.json: missing: no golden file at golden/twin.h5; to create it: "
                              "hyrax-sim bless scenarios/twin.json --reason \"...\"\n"
                              "4 checked: 2 agreed, 0 disagreed, 2 without golden file, 0 failed; 1 unreferenced\n")
        succeed("sh", "-c", command, cwd=self.folder)
        (self.folder / "scenarios/twin.json").unlink()
        self.check(AGREED)

    def test_that_of_a_deleted_scenario_is_a_disagreement_and_that_of_a_link_to_nowhere_is_not_reported(self):
        (self.folder / "scenarios/third.json").unlink()
        self.assertEqual(self.unreferenced(DISAGREED), ["golden/third"])
        self.assertEqual(self.expect(DISAGREED, "check").out,
                         "golden/third: unreferenced: no scenario for this golden file: the scenario was deleted, moved or renamed\n"
                         "2 checked: 2 agreed, 0 disagreed, 0 without golden file, 0 failed; 1 unreferenced\n")
        (self.folder / "scenarios/third.json").symlink_to("nowhere")
        self.assertEqual(self.unreferenced(CANNOT_ACCESS), [])

    def test_each_half_counts_once(self):
        self.write("golden/a/half.txt", "")
        self.write("golden/deep/er/other.h5", "")
        self.write("golden/README.md", "no golden file")
        self.write("golden/folder.txt", "")
        (self.folder / "scenarios/folder.json").mkdir()
        self.write("golden/pictures.h5/README.md", "no golden file")
        self.write("elsewhere/linked.h5", "")
        os.symlink("../elsewhere", self.folder / "golden/linked")
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
        self.assertEqual(self.unreferenced(DISAGREED, "scenarios", "--golden", "elsewhere", "--summary", "a.md"), ["elsewhere/third"])
        self.assertIn("check: not agreed\n", (self.folder / "a.md").read_text())
        (self.folder / "scenarios/a").rename(self.folder / "outside")
        self.assertEqual(self.unreferenced(GOLDEN_MISSING, "outside", "--golden", "elsewhere"), [])

    def test_without_any_scenario_they_are_reported_and_none_is_removed(self):
        shutil.rmtree(self.folder / "scenarios")
        (self.folder / "scenarios").mkdir()
        before = self.state_of(".")
        self.assertEqual(self.unreferenced(BAD_INPUT, says="scenarios: no scenario found (*.json)\n"),
                         ["golden/a/first", "golden/a/second", "golden/third"])
        self.expect(BAD_INPUT, "bless", "--prune", says="nothing removed: scenarios: no scenario found (*.json); is it mounted")
        self.assertEqual(self.state_of("."), before)

    def test_the_accepted_core_has_no_scenario(self):
        for name in ("core/accepted.txt", "core/physics.h5", "a/core/old.txt"):
            self.write(f"golden/{name}", "")
        self.assertEqual(self.unreferenced(DISAGREED), ["golden/a/core/old"])
        self.write("scenarios/core/fourth.json", fling(name="fourth"))
        says = "golden/core/fourth.h5: is where the accepted core is kept; `core` is a reserved name at the top of scenarios: rename that folder"
        self.assertIn(says, self.check(BAD_INPUT)["results"][2]["error"])
        self.expect(BAD_INPUT, "bless", "scenarios/core", "--reason", "x", says=says)
        self.expect(BAD_INPUT, "run", "scenarios/core", says=says)
        self.assertEqual(self.unreferenced(BAD_INPUT, "scenarios/core"), [])


class Selection(CheckTest):
    """Which scenarios are checked."""

    def listed(self, *arguments, exit_code=AGREED, **options):
        return self.expect(exit_code, "check", "--list", *arguments, **options).out.splitlines()

    def test_list_plays_nothing(self):
        self.write("scenarios/bad.json", "{")
        (self.folder / "golden/third.h5").unlink()
        paths = ["scenarios/a/first.json", "scenarios/a/second.json", "scenarios/bad.json", "scenarios/third.json"]
        self.assertEqual(self.listed(), paths)
        self.assertEqual(self.expect(AGREED, "check", "--list", "--json").json, {"scenarios": paths})
        self.assertEqual(self.listed("scenarios/a", "none.json"), [*paths[:2], "none.json"])
        self.assertEqual(self.listed("scenarios/a", "golden", exit_code=BAD_INPUT, says="golden: no scenario found"), paths[:2])

    def test_filter_takes_the_paths_that_contain_a_text(self):
        self.write("golden/a/old.txt", "")
        self.assertEqual(self.listed("--filter", "ir"), ["scenarios/a/first.json", "scenarios/third.json"])
        self.assertEqual(self.check(AGREED, "--filter", "third")["checked"], 1)
        document = self.check(DISAGREED, "--filter", "a/")
        self.assertEqual((document["checked"], document["unreferenced"]), (2, 1))
        self.expect(BAD_INPUT, "check", "--filter", "[x]", says="--filter: no path contains it (found [x])")

    def test_last_failed_takes_those_that_did_not_agree(self):
        cache = self.folder / "cache"
        env = {**os.environ, "XDG_CACHE_HOME": str(cache)}
        all_paths = self.listed()
        says = "no scenario failed when this folder was last checked; all are checked"
        self.assertEqual(self.listed("--last-failed", env=env, says=says), all_paths)
        self.check(AGREED, env=env)
        self.assertFalse(cache.exists())
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        (self.folder / "golden/a/first.h5").unlink()
        self.check(GOLDEN_MISSING, env=env)
        self.assertEqual(self.listed("--last-failed", env=env), [all_paths[0], all_paths[2]])
        self.assertEqual(self.listed("--last-failed", "--filter", "third", env=env), [all_paths[2]])
        self.expect(BAD_INPUT, "check", "--last-failed", "--filter", "second", env=env,
                    says="no path that failed when this folder was last checked contains it (found second)")
        self.assertEqual(self.listed("--last-failed", "a", env=env, cwd=self.folder / "scenarios", says=says),
                         ["a/first.json", "a/second.json"])
        self.bless(all_paths[0])
        self.assertEqual(self.counts(self.check(DISAGREED, "--last-failed", env=env)), (1, 1, 0, 0))
        self.check(AGREED, "scenarios/a", env=env)
        self.assertEqual(self.listed("--last-failed", env=env), [all_paths[2]])
        self.bless(all_paths[2])
        self.check(AGREED, "--last-failed", env=env)
        self.assertEqual(self.listed("--last-failed", env=env, says=says), all_paths)
        self.write("golden/old.txt", "")
        env = {**env, "XDG_CACHE_HOME": "", "HOME": str(cache)}
        self.check(DISAGREED, env=env)
        document = self.check(DISAGREED, "--last-failed", env=env)
        self.assertEqual((document["checked"], document["unreferenced"]), (0, 1))
        self.assertEqual(self.names(), ["cache", "golden", "scenarios"])
        self.assertEqual(self.names("cache"), [".cache", "hyrax-sim"])
        (self.folder / "golden/old.txt").unlink()
        self.write(os.fsdecode(b"scenarios/not-utf-8-\xff\n.json"), "{")
        self.check(BAD_INPUT, env=env)
        self.assertEqual(len(self.check(BAD_INPUT, "--last-failed", env=env)["results"]), 1)

    def test_without_a_folder_for_it_nothing_is_recorded(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        before = self.state_of(".")
        for place in ({"XDG_CACHE_HOME": str(self.folder / "golden"), "HOME": ""},
                      {"XDG_CACHE_HOME": "cache", "HOME": "/dev/null"}, {"XDG_CACHE_HOME": "/dev/null/x"}):
            self.check(DISAGREED, env={**os.environ, **place})
        self.assertEqual(self.state_of("."), before)


class Everything(CheckTest):
    """Verdicts of all kinds."""

    def test_any_number_of_workers_gives_the_same_document_though_every_golden_file_is_read(self):
        """If some threads cannot be started, the others do the work."""
        self.project("fourth", "fifth")
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        (self.folder / "golden/a/first.h5").unlink()
        for path in self.folder.glob("golden/**/*.txt"):
            path.write_text(path.read_text()[:-33] + 32 * "0" + "\n")
        one = self.expect(GOLDEN_MISSING, "check", "--json", "--jobs", "1")
        self.assertEqual(self.counts(one.json), (3, 1, 1, 0))
        for jobs, environment in ((2, os.environ), (64, os.environ), (8, few_threads(0)), (8, few_threads(1))):
            outcome = self.expect(GOLDEN_MISSING, "check", "--json", "--jobs", f"{jobs:02}", env=environment)
            self.assertEqual(outcome.out, one.out)

    def test_a_pointer_of_git_lfs_is_refused_with_what_fetches_the_file(self):
        for suffix in ("h5", "txt"):
            path = self.folder / f"golden/third.{suffix}"
            before = path.read_bytes()
            path.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 5000\n")
            self.assertIn(f"golden/third.{suffix}: is a Git LFS pointer to the file; to fetch that: git lfs pull", self.expect(BAD_INPUT, "check").out)
            path.write_bytes(before)

    def test_golden_files_are_unchanged_for_every_verdict(self):
        nudge(self.folder / "golden/third.h5", "trajectory/y", 5)
        self.write("scenarios/a/new.json", fling(name="new"))
        self.write("scenarios/a/first.json", fling(name="first", steps=20))
        before = self.state_of("golden")
        for path in (self.folder / "golden").rglob("*"):
            path.chmod(0o555 if path.is_dir() else 0o444)
        for arguments in ((), ("--jobs", "4")):
            self.check(GOLDEN_MISSING, *arguments)
        self.assertEqual(self.state_of("golden"), before)
        self.assertEqual(self.names(), ["golden", "scenarios"])
        for path in (self.folder / "golden").rglob("*"):
            path.chmod(0o755)
