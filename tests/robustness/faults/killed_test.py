"""Killed while it writes, the program leaves the old file or the complete new one, never another.

HYRAX_KILL_AT_CALL names the library that kills it at a chosen call, kill_at_call.c; HYRAX_KILLS says at how many calls
of a command at most. Between two of them the files are the same.
"""

import os
import re
import shutil
import signal

from process import preloading
from program import AGREED, ANOTHER_START, DISAGREED, ProgramTest, fling
from traced import SHIPPED, TRACED, traced

LIBRARY = os.environ["HYRAX_KILL_AT_CALL"]
CALLS_MAX = int(os.environ.get("HYRAX_KILLS", "16"))


class Killed(ProgramTest):
    """A folder as it was before a command, and as the command leaves it."""

    def setUp(self):
        super().setUp()
        (self.folder / "before").mkdir()

    def write_before(self, path, content):
        """A file as it is before each try."""
        return self.write(f"before/{path}", content)

    def files(self, folder):
        """Content of every file, and the names of parts."""
        found = {str(path.relative_to(self.folder / folder)): path.read_bytes()
                 for path in (self.folder / folder).rglob("*") if path.is_file()}
        parts = sorted(name for name in found if name.endswith(".part"))
        return {name: content for name, content in found.items() if name not in parts}, parts

    def try_in(self, folder, *arguments, **options):
        """The command in a fresh copy of the folder as it was; returns the process."""
        shutil.rmtree(self.folder / folder, ignore_errors=True)
        shutil.copytree(self.folder / "before", self.folder / folder)
        return self.begin(*arguments, cwd=self.folder / folder, **options)

    def environment(self, at):
        """In which the program is killed at a call that changes files."""
        return {**os.environ, **preloading(LIBRARY), "HYRAX_KILL_AT": str(at), "HYRAX_CALLS": str(self.folder / "calls")}

    def calls_of(self, *arguments):
        """How many calls that change files the complete command makes; leaves its outcome in `after`."""
        self.assertEqual(self.try_in("after", *arguments, env=self.environment(0)).wait().exit_code, AGREED)
        return int((self.folder / "calls").read_text())

    def assert_old_or_new(self, what):
        """Every file is as it was, or as the complete command leaves it."""
        old, _ = self.files("before")
        new, parts = self.files("after")
        self.assertEqual(parts, [])
        now, parts = self.files("now")
        for name, content in now.items():
            self.assertIn(content, (old.get(name), new.get(name)), f"{what}: {name} is neither old nor new")
        for name in old:
            self.assertIn(name, now, what)
        for part in parts:
            self.assertTrue(os.path.basename(part).startswith("."), part)

    def assert_mended_by(self, *arguments):
        """Repeating the command has the result of an uninterrupted one, and leaves no part file."""
        self.expect(AGREED, *arguments, cwd=self.folder / "now")
        new, _ = self.files("after")
        now, parts = self.files("now")
        self.assertEqual((sorted(now), parts), (sorted(new), []))
        for name in set(new) - {name for name in new if name.endswith(".txt")}:
            self.assertEqual(now[name], new[name], name)

    def kill_everywhere(self, *arguments, tries_max=CALLS_MAX):
        """Kills the command before calls that change files: each, or so many spread over all, the first and the last among them."""
        calls = self.calls_of(*arguments)
        self.assertGreater(calls, 3)
        for at in sorted({1 + index * (calls - 1) // (tries_max - 1) for index in range(tries_max)}):
            code = self.try_in("now", *arguments, env=self.environment(at)).wait().exit_code
            self.assertEqual(code, -signal.SIGKILL, f"at call {at} of {calls}")
            self.assert_old_or_new(f"killed at call {at} of {calls}")
            yield at


class Trajectory(Killed):
    """`run`, over a file that is there already."""

    def setUp(self):
        super().setUp()
        self.write_before("fling.json", fling())
        self.write_before("long.json", fling(name="long", steps=120_000, clock={
            "rate_hz": 60, "jitter": {"kind": "uniform", "fraction": 0.5, "seed": 1}}))
        self.write_before("out.h5", "what was there before")

    def test_at_every_call_of_a_small_file_and_at_calls_of_a_large_one(self):
        for scenario, tries_max in (("fling.json", CALLS_MAX), ("long.json", 12)):
            for _ in self.kill_everywhere("run", scenario, "-o", "out.h5", tries_max=tries_max):
                self.assert_mended_by("run", scenario, "-o", "out.h5")


class Sweep(Killed):
    """`sweep` and `sweep --merge`, over a result that is there already."""

    def test_at_calls_of_a_sweep_in_several_chunks_and_of_its_merge(self):
        self.write_before("sweep.json", {"format": "hyrax-sweep/1", "members": 70_000, "seed": 3, "base": fling(steps=1),
                                         "vary": {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}}, "keep": ["final"]})
        self.expect(AGREED, "sweep", "sweep.json", "--part=0/1", cwd=self.folder / "before")
        self.write_before("out.h5", "what was there before")
        for command in (("sweep", "sweep.json", "-o", "out.h5"), ("sweep", "--merge", "sweep.part-0-of-1.h5", "-o", "out.h5")):
            for _ in self.kill_everywhere(*command):
                self.assert_mended_by(*command)


class Blessing(Killed):
    """`bless` replaces two files; between the two, `check` must not accept a mixture."""

    COMMAND = ("bless", "scenarios", "--reason", "another start")

    def setUp(self):
        super().setUp()
        self.write_before("scenarios/fling.json", fling())
        self.expect(AGREED, "bless", "scenarios", "--reason", "the first", cwd=self.folder / "before")
        self.write_before("scenarios/fling.json", fling(start=ANOTHER_START))
        self.write_before("scenarios/unblessed.json", fling(name="unblessed"))

    def verdict(self, *arguments):
        """The exit code of `check` of the changed scenario."""
        return self.hyrax_sim(*arguments, "scenarios/fling.json", cwd=self.folder / "now").exit_code

    def is_complete(self):
        """Whether both new files are in place."""
        new, _ = self.files("after")
        now, _ = self.files("now")
        return all(now[name] == new[name] for name in ("golden/fling.h5", "golden/fling.txt"))

    def assert_verdicts(self, wanted):
        """Of `check` and `run`."""
        for command in (("check",), ("run", "-o", "run.h5")):
            self.assertEqual(self.verdict(*command), wanted, command)
        (self.folder / "now/run.h5").unlink()

    def test_at_every_call(self):
        seen = set()
        for _ in self.kill_everywhere(*self.COMMAND):
            seen.add(self.is_complete())
            self.assert_verdicts(AGREED if self.is_complete() else DISAGREED)
            self.assert_mended_by(*self.COMMAND)
        self.assertEqual(seen, {False, True})

    def test_a_first_blessing_is_missing_until_its_rows_exist(self):
        for _ in self.kill_everywhere("bless", "scenarios/unblessed.json", "--reason", "x"):
            rows, digest = (self.folder / "now/golden" / f"unblessed.{kind}" for kind in ("h5", "txt"))
            self.assertTrue(digest.exists() or not rows.exists())
            self.assert_mended_by("bless", "scenarios/unblessed.json", "--reason", "x")

    def test_a_state_hash_that_is_updated(self):
        command = (*self.COMMAND, "--update-hash")
        old_hash = {"state_hash": "0" * 32}
        self.write_before("scenarios/fling.json", fling(start=ANOTHER_START, expect=old_hash))
        seen = set()
        for _ in self.kill_everywhere(*command):
            has_old_hash = "0" * 32 in (self.folder / "now/scenarios/fling.json").read_text()
            seen.add(has_old_hash)
            self.assertEqual(self.verdict("check"), DISAGREED if has_old_hash else AGREED)
            self.assert_mended_by(*command)
        self.assertEqual(seen, {False, True})


class AcceptedCore(Killed):
    """`bless` with a changed core replaces the golden files, then the three files of the accepted core."""

    COMMAND = ("bless", "scenarios", "--reason", "stronger gravity", "--accept", "contacts")

    def setUp(self):
        super().setUp()
        for name in ("a", "b"):
            self.write_before(f"scenarios/{name}.json", fling(name=name))
        self.expect(AGREED, "bless", "scenarios", "--reason", "the first", cwd=self.folder / "before")
        os.environ.update(traced(SHIPPED.replace("GRAVITY = 1200.0", "GRAVITY = 1250.0")).environment)
        self.program = TRACED

    def state(self):
        """How many golden files are the new ones, and of the core."""
        new, _ = self.files("after")
        now, _ = self.files("now")
        counts = [0, 0]
        for name, content in now.items():
            counts[name.startswith("golden/core/")] += name.startswith("golden/") and content == new[name]
        return counts

    def test_at_every_call(self):
        seen = set()
        for _ in self.kill_everywhere(*self.COMMAND, tries_max=40):
            files, core = self.state()
            seen.add((files, core))
            outcome = self.hyrax_sim("check", cwd=self.folder / "now")
            is_mixed = files < 4 or core in (1, 2)
            self.assertEqual(outcome.exit_code, DISAGREED if is_mixed else AGREED, (files, core, outcome))
            if files == 4 and core == 0:  # Only the core is missing.
                self.assertIn("core: changed\n", outcome.out)
                self.assertIn("  to accept it    hyrax-sim bless --core --reason \"...\"\n", re.sub(r"\S+/control_traced", "hyrax-sim", outcome.out))
            self.assert_mended_by(*self.COMMAND)
            self.expect(AGREED, "check", cwd=self.folder / "now")
        self.assertLessEqual({(4, 0), (4, 1), (4, 2), (4, 3)}, seen)
        self.assertGreater(len(seen), 5)
