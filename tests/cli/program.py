"""Runs hyrax-sim as its users do: in its own folder, on files, judged by its exit code and output.

The environment gives the paths: HYRAX_SIM (the program), HYRAX_SOURCE_DIR (the project).
"""

import copy
import contextlib
import json
import os
import pathlib
import pty
import shutil
import tempfile
import termios
import threading
import unittest

from process import Process, preloading, run, run_measured, skip_for_lack_of

BEFORE = dict(os.environ)  # With the user's cache, where tools/windows keeps the libraries that it built.
# `check` records there what did not agree: of tests, not in the user's own.
CACHE = tempfile.TemporaryDirectory(prefix="hyrax-test-cache-")
os.environ["XDG_CACHE_HOME"] = CACHE.name

SOURCE = pathlib.Path(os.environ.get("HYRAX_SOURCE_DIR", pathlib.Path(__file__).parents[2])).resolve()
PROGRAM = pathlib.Path(os.environ.get("HYRAX_SIM", SOURCE / "build/bin/hyrax-sim")).resolve()

AGREED, DISAGREED, BAD_INPUT, CANNOT_ACCESS, GOLDEN_MISSING, NOT_STRICT = 0, 1, 2, 3, 4, 5

# A throw across a desktop: the right wall at row 36, the ground at row 76 and seven times more, at rest from 4 s on.
FLING = {
    "format": "hyrax-scenario/1",
    "name": "fling",
    "window": {"width_px": 1920, "height_px": 1080},
    "sprite": {"width_px": 128, "height_px": 128},
    "start": {"x_px": 1100, "y_px": 500, "vx_px_per_s": 1200, "vy_px_per_s": -400},
    "clock": {"rate_hz": 60},
    "steps": 300,
}
ANOTHER_START = {"x_px": 1000, "y_px": 500, "vx_px_per_s": 1200, "vy_px_per_s": -400}


is_long = unittest.skipUnless("HYRAX_LONG" in os.environ, "tools/test --all runs it")  # As a test of its own, labelled long.
needs_page = unittest.skipUnless(os.environ.get("HYRAX_PAGE") == "1", "this program has no page; tools/test --all builds it")


def few_threads(allowed, environment=os.environ):
    """The environment in which a program can start only so many threads; ctest gives the path of what sees to it."""
    return {**environment, **preloading(os.environ["HYRAX_FEW_THREADS"]), "HYRAX_THREADS": str(allowed)}


def fling(**changes):
    """The throw as a document, with top-level members changed; None removes one."""
    document = {**copy.deepcopy(FLING), **changes}
    return {key: value for key, value in document.items() if value is not None}


class ProgramTest(unittest.TestCase):
    """A folder, and the program run in it. A test that compares nothing fails, for one whose lists are all empty does."""

    maxDiff = None
    program = PROGRAM  # A test may set another one for itself.
    compared = 0
    blessed_once = {}  # By the names of a `project` in an empty folder, its golden files.

    def __getattribute__(self, name):
        if name.startswith("assert"):
            self.compared += 1
        return super().__getattribute__(name)

    def _callTestMethod(self, method):
        self.compared = 0
        super()._callTestMethod(method)
        if self.compared == 0:
            self.fail("it compares nothing")

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-test-"))
        self.addCleanup(shutil.rmtree, self.folder)

    # --- doing

    def hyrax_sim(self, *arguments, **options):
        """Runs the program in the folder."""
        return run(self.program, *arguments, **{"cwd": self.folder, **options})

    def begin(self, *arguments, **options):
        """Starts the program in the folder and does not wait for it."""
        process = Process(self.program, *arguments, **{"cwd": self.folder, **options})
        self.addCleanup(process.end)
        return process

    def on_terminal(self, stream, *arguments, columns=0, **options):
        """Runs the program with a terminal as `stdout` or `stderr`; returns its outcome, and what the terminal showed."""
        keeper, terminal = pty.openpty()
        termios.tcsetwinsize(terminal, (24, columns))
        shown = []

        def watch():
            with contextlib.suppress(OSError):  # The terminal is closed.
                while part := os.read(keeper, 65536):
                    shown.append(part)

        watcher = threading.Thread(target=watch)
        watcher.start()
        try:
            outcome = self.hyrax_sim(*arguments, **{stream: terminal}, **options)
        finally:
            os.close(terminal)
            watcher.join()
            os.close(keeper)
        return outcome, b"".join(shown).decode().replace("\r\n", "\n")

    def is_sanitized(self):
        """Whether the program was built with a sanitizer, which takes memory and ends processes in its own way."""
        return "-fsanitize" in self.expect(AGREED, "info").out

    def expect_below(self, limit_bytes, exit_code, *arguments):
        """Runs the program; expects this exit code, and less memory than that, a sanitizer's aside."""
        _, peak_bytes, _ = run_measured(self.program, *arguments, cwd=self.folder, exit_code=exit_code)
        if not self.is_sanitized():
            self.assertLess(peak_bytes, limit_bytes)

    def expect(self, exit_code, *arguments, says=(), **options):
        """Runs the program; expects this exit code, and `says` in its message."""
        outcome = self.hyrax_sim(*arguments, **options)
        self.assertEqual(outcome.exit_code, exit_code, f"{arguments}: {outcome}")
        for part in (says,) if isinstance(says, str) else says:
            self.assertIn(part, outcome.err)
        self.assertNotIn("\x1b", outcome.out + outcome.err, "escape codes belong on a terminal")
        return outcome

    def in_private_mount(self, mount, *script):
        """Runs a script beside `disk`, a private file system; $1 is the program."""
        (self.folder / "disk").mkdir()
        unshare = ("unshare", "--mount", "--map-root-user")
        if run(*unshare, "mount", "-t", "tmpfs", "tmpfs", self.folder / "disk").exit_code != 0:
            skip_for_lack_of("file system that can be mounted (unshare --mount --map-root-user)")
        # HDF5 1.10 leaks the memory of a file that it could not finish writing.
        environment = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0:" + os.environ.get("ASAN_OPTIONS", "")}
        lines = "\n".join([f"mount -t tmpfs {mount} tmpfs disk", *script])
        return run(*unshare, "sh", "-ec", lines, "sh", self.program, cwd=self.folder, env=environment)

    def write(self, path, content):
        """Writes a document or a text below the folder; returns its path as it would be typed there."""
        target = self.folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return str(path)

    def bless(self, *paths):
        """Makes golden files for scenarios."""
        self.expect(AGREED, "bless", *paths, "--reason", "for the test")

    def project(self, *names):
        """scenarios/ and golden/ with a throw of each name, at different speeds; returns the paths."""
        is_alone = not self.names()
        paths = []
        for number, name in enumerate(names):
            start = {**FLING["start"], "vx_px_per_s": 1200 - 10 * number}
            document = fling(name=pathlib.Path(name).name, start=start)
            paths.append(self.write(f"scenarios/{name}.json", document))
        if is_alone and names in self.blessed_once:
            for path, content in self.blessed_once[names].items():
                (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
                (self.folder / path).write_bytes(content)
            return paths
        self.bless("scenarios")
        if is_alone:
            self.blessed_once[names] = {os.path.relpath(path, self.folder): content
                                        for path, (content, _) in self.state_of("golden").items()}
        return paths

    # --- judging

    def names(self, folder="."):
        """Names of all that is in a folder, hidden part files too."""
        return sorted(entry.name for entry in (self.folder / folder).iterdir())

    def state_of(self, folder):
        """Content and time of change of every file below a folder."""
        return {str(path): (path.read_bytes(), path.stat().st_mtime_ns)
                for path in sorted((self.folder / folder).rglob("*")) if path.is_file()}


main = unittest.main
