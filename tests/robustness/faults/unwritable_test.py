"""An output that cannot be written is exit 3 with a message, and existing files are unchanged: `bless` and
`check --junit`, with limits and other users. For `run` see run_failure_test. Several processes may write the same output."""

import os
import resource
import shutil

from process import run, skip_for_lack_of
from program import AGREED, ANOTHER_START, CANNOT_ACCESS, DISAGREED, PROGRAM, ProgramTest, fling

# HDF5 1.10 leaks the memory of a file that it could not finish writing.
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0:" + os.environ.get("ASAN_OPTIONS", "")}


def at_most(size):
    """Keeps the process from making any file larger, as a quota does."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


class Unwritable(ProgramTest):
    """A project with a blessed throw, which is then changed."""

    def setUp(self):
        super().setUp()
        self.project("fling")
        self.write("scenarios/fling.json", fling(name="fling", start=ANOTHER_START))
        self.write("fling.h5", "what was there before")
        self.before = self.state_of(".")

    def assert_untouched(self):
        """No byte, no time stamp and no name has changed."""
        self.assertEqual(self.state_of("."), self.before)


class Limit(Unwritable):
    """A limit on the size of files is an error of writing, and does not end the process."""

    def test_a_sweep_and_its_parts_joined(self):
        base = fling(name="fling", steps=3)
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": base, "members": 3000, "seed": 1, "vary": {"/start/x_px": {"uniform": [0, 9]}}})
        self.expect(AGREED, "sweep", "sweep.json", "--part", "0/1")
        for size in (0, 4096, 100_000):
            for arguments in (("sweep.json",), ("--merge", "sweep.part-0-of-1.h5")):
                outcome = self.expect(CANNOT_ACCESS, "sweep", *arguments, "-o", "out.h5", preexec_fn=at_most(size), env=ENVIRONMENT)
                self.assertEqual(outcome.err, "out.h5: cannot be written: File too large\n")

    def test_run_of_few_and_of_many_rows_to_csv_but_for_the_last_byte_and_of_a_text_that_fits_a_buffer(self):
        run_it = ("run", "scenarios/fling.json")
        self.expect(DISAGREED, *run_it, "-o", "fling.csv")
        whole = (self.folder / "fling.csv").stat().st_size
        self.before = self.state_of(".")
        for size, path, *arguments in (
                *((size, "fling.h5", *run_it) for size in (0, 1, 4096, 20_000)),
                (3_000_000, "fling.h5", *run_it, "--set", "/steps=200000", "--no-skip"),
                (whole - 1, "fling.csv", *run_it, "-o", "fling.csv"), (100, "small.json", "new", "small")):
            self.expect(CANNOT_ACCESS, *arguments, preexec_fn=at_most(size), env=ENVIRONMENT,
                        says=f"{path}: cannot be written: File too large")
            self.assert_untouched()

    def test_bless_fails_in_both_files_or_in_none(self):
        for size in (0, 500, 20_000):
            self.expect(CANNOT_ACCESS, "bless", "scenarios", "--reason", "x", preexec_fn=at_most(size), env=ENVIRONMENT,
                        says=("golden/fling.", "cannot be written: File too large"))
            self.assert_untouched()

    def test_where_bless_fails_nothing_is_pruned(self):
        self.write("scenarios/gone.json", fling(name="gone"))
        self.bless("scenarios/gone.json")
        (self.folder / "scenarios/gone.json").unlink()
        self.before = self.state_of(".")
        self.expect(CANNOT_ACCESS, "bless", "scenarios", "--prune", "--reason", "x", preexec_fn=at_most(500), env=ENVIRONMENT)
        self.assert_untouched()


class SmallStack(ProgramTest):
    """A stack of 64 KiB, which threads of this size have, too, is enough for every command."""

    def test_every_command(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_STACK, (1 << 16, 1 << 16))  # noqa: E731
        if self.is_sanitized():
            self.skipTest("a sanitizer's frames are larger")
        self.project("fling")
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": "scenarios/fling.json", "members": 300, "seed": 1, "vary": {"/start/x_px": {"uniform": [0, 900]}}})
        self.write("jitter.json", fling(steps=20_000, clock={"rate_hz": 60, "jitter": {"kind": "normal", "sigma_s": 0.001, "seed": 1}}))
        self.write("wrong.json", fling(expect={"finite": False}))
        for command in ("validate jitter.json", "run scenarios/fling.json -o run.h5 --figure run.svg --drift --rows", "run jitter.json -o jitter.h5",
                        "run jitter.json -o jitter.csv", "check --core", "check --json --junit check.xml --summary summary.md",
                        "diff run.h5 golden/fling.h5 --figure diff.svg", "drift jitter.json --reference gsl --figures figures", "fuzz --runs 300",
                        "sweep sweep.json -o sweep.h5", "bless scenarios --reason x", "shrink wrong.json -o small.json",
                        "study needs scenarios/fling.json --quick -o study"):
            self.expect(AGREED, *command.split(), preexec_fn=limit)


class Place(Unwritable):
    """Missing folders, files in place of folders, folders of another user."""

    def test_the_table_outlives_a_junit_file_in_a_missing_folder(self):
        for arguments, wanted in (((), "1 checked: 0 agreed, 1 disagreed"), (("--json",), '"disagreed": 1')):
            outcome = self.expect(CANNOT_ACCESS, "check", "--junit", "no/such/report.xml", *arguments,
                                  says="no/such/report.xml: cannot be written: No such file or directory")
            self.assertIn(wanted, outcome.out)

    def test_a_search_does_not_begin_whose_result_has_no_place(self):
        for command, path in (("fuzz --runs 1 -o fling.h5", "fling.h5/fuzz.json: cannot be written: Not a directory"),
                              ("shrink scenarios/fling.json -o no/small.json", "no/small.json: cannot be written: No such file or directory")):
            outcome = self.expect(CANNOT_ACCESS, *command.split(), says=path)
            self.assertEqual(outcome.out, "")
        self.assert_untouched()

    def set_modes(self, folders, files):
        for path in [self.folder, *self.folder.rglob("*")]:
            path.chmod(folders if path.is_dir() else files)

    def unprivileged(self):
        """The start of a command line that runs the program as another user; skips where that is not possible."""
        if os.geteuid() != 0:
            return []
        command = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        self.set_modes(0o755, 0o644)
        if shutil.which("setpriv") is None or run(*command, PROGRAM, "--version", cwd="/").exit_code != 0:
            skip_for_lack_of("way to run the program as another user (setpriv --reuid=65534)")
        return command

    def as_other(self, *arguments):
        """Runs it as a user who may write nothing here."""
        command = self.unprivileged()
        self.set_modes(0o555, 0o444)
        try:
            return run(*command, PROGRAM, *arguments, cwd=self.folder, env=ENVIRONMENT, exit_code=CANNOT_ACCESS)
        finally:
            self.set_modes(0o755, 0o644)

    def test_a_folder_without_the_right_to_write(self):
        for arguments, place in ((("run", "scenarios/fling.json"), "fling.h5"),
                                 (("bless", "scenarios", "--reason", "x"), "golden/fling."),
                                 (("check", "--junit", "report.xml"), "report.xml")):
            done = self.as_other(*arguments)
            self.assertIn(place, done.err)
            self.assertIn("cannot be written: Permission denied", done.err)
            self.assert_untouched()

    def test_a_file_without_read_permission(self):
        command = self.unprivileged()
        (self.folder / "golden/fling.h5").chmod(0)
        done = run(*command, PROGRAM, "diff", "golden/fling.h5", "fling.h5", cwd=self.folder)
        self.assertEqual((done.exit_code, done.err),
                         (CANNOT_ACCESS, "golden/fling.h5: cannot be read: Permission denied\n"))

    def checked_without(self, folder):
        """The outcome of `check` by a user who may not read this folder; that of hyrax-replay has the same counts."""
        command = self.unprivileged()
        secret = self.folder / folder
        secret.mkdir()
        secret.chmod(0)
        done, twin = (run(*command, program, "check", cwd=self.folder) for program in (PROGRAM, os.environ["HYRAX_REPLAY"]))
        secret.chmod(0o755)
        self.assertEqual((done.exit_code, twin.exit_code), (CANNOT_ACCESS, CANNOT_ACCESS), (done, twin))
        self.assertEqual(twin.out.splitlines()[-1], done.out.splitlines()[-1])
        return done

    def test_a_folder_without_read_permission(self):
        out = self.checked_without("scenarios/secret").out
        self.assertIn("scenarios/secret: failed: scenarios/secret: cannot be read: Permission denied\n", out)
        self.assertIn("2 checked: 0 agreed, 1 disagreed, 0 without golden file, 1 failed\n", out)
        (self.folder / "scenarios/secret").rmdir()
        for name in ("aa", "zz"):  # Whatever the order of the folder's entries: both are found.
            (self.folder / f"golden/{name}.h5").touch()
        out = self.checked_without("golden/secret").out
        for text in ("golden/secret: failed: golden/secret: cannot be read: Permission denied\n",
                     "2 golden files: unreferenced: no scenario: golden/aa, golden/zz\n",
                     "1 checked: 0 agreed, 1 disagreed, 0 without golden file, 0 failed; 2 unreferenced; 1 folder failed"):
            self.assertIn(text, out)


class SeveralWriters(ProgramTest):
    """One complete output remains, and none disturbs another."""

    def test_many_writers_at_once_succeed_and_leave_one_file(self):
        speeds, whole = (100, 900, 1700), []
        for speed in speeds:
            start = {"x_px": 0, "y_px": 500, "vx_px_per_s": speed, "vy_px_per_s": -400}
            self.write(f"{speed}.json", fling(name="same", start=start))
            self.expect(AGREED, "run", f"{speed}.json", "-o", "whole.h5")
            whole.append((self.folder / "whole.h5").read_bytes())
        for _ in range(4):
            for process in [self.begin("run", f"{speed}.json", "-o", "out.h5") for speed in speeds for _ in range(2)]:
                self.assertEqual(process.wait().exit_code, AGREED)
            self.assertIn((self.folder / "out.h5").read_bytes(), whole)
        self.assertEqual([name for name in self.names() if name.endswith(".part")], [])

    def test_concurrent_blessings_leave_a_complete_one(self):
        self.write("scenarios/same.json", fling(name="same"))
        for _ in range(4):
            outcomes = [process.wait() for process in [self.begin("bless", "scenarios", "--reason", "x") for _ in range(3)]]
            self.assertIn(AGREED, [outcome.exit_code for outcome in outcomes])
            for outcome in outcomes:
                if outcome.exit_code != AGREED:
                    self.assertEqual(outcome.exit_code, CANNOT_ACCESS, outcome)
                    self.assertIn("nothing written: golden/same.h5: was changed by another program", outcome.err)
            self.expect(AGREED, "check")
        self.assertEqual(self.names("golden"), ["core", "same.h5", "same.txt"])
