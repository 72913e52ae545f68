"""A copy of the project and of a build of it, in which one source is changed at a time.

The copied build compiles and links exactly as the original, in other folders: ninja runs the original's
commands with the paths replaced. The original is only read. Files that a mutant, its build or its tests
change are copied again afterwards.
"""

import dataclasses
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

from original_build import PROGRAM, CannotBuild, printed

_ADDRESS_SPACE_MAX, _FILE_SIZE_MAX = 8 << 30, 4 << 30
_CHECK_S_MAX = 2  # Of processor time; a check of all scenarios takes a tenth of a second.
PASSED = ("Passed", "Skipped")
_OF_TESTS = ("Testing", "wine", "outside_project")  # Folders in a build that tests fill, maybe while it is copied.
_RELOCATED = ("build.ninja", "rules.ninja", "CTestTestfile.cmake", "compile_commands.json", "settings.cmake",
              "unity_0_cxx.cxx")
_OUTCOME = re.compile(r"^ *\d+/\d+ Test +#\d+: (\S+) \.*(?:\*\*\*)? *(.*?) +([\d.]+) sec", re.MULTILINE)


@dataclasses.dataclass(frozen=True)
class Verdict:
    """The fate of a mutant: caught, survived, equivalent, refused by the compiler, or not tried.

    caught_by: `check`, or the test; difference: how that showed.
    """

    fate: str
    caught_by: str = ""
    difference: str = ""


class BuildCopy:
    """One copy, in `folder`, which is the caller's to remove.

    deadline_s: when all that it runs must have ended, by time.monotonic().
    """

    def __init__(self, build, folder, test_s_max, deadline_s):
        self._original, self._test_s_max, self._deadline_s = build, test_s_max, deadline_s
        self._is_stopped, self._running = False, None
        self._temporary = folder / "tmp"
        self.source = folder / "source"
        is_inside = build.folder.is_relative_to(build.source)
        self.folder = (self.source if is_inside else folder) / (
            build.folder.relative_to(build.source) if is_inside else "build")
        self._moves = [(build.folder, self.folder), (build.source, self.source)]
        shutil.copytree(build.source, self.source, symlinks=True,
                        ignore=lambda at, _: {".git", "build"} if pathlib.Path(at) == build.source else ())
        shutil.copytree(build.folder, self.folder, symlinks=True, ignore=shutil.ignore_patterns(*_OF_TESTS))
        for path in self._files():
            if path.name in _RELOCATED:
                self._copy(path)
        always_run = self.folder / "tools/CMakeFiles/page_core"  # What makes the page's core has no file of its own.
        if always_run.parent.is_dir():
            always_run.touch()
        self._stamps = self._stamps_now()
        if "no work to do" not in printed("ninja", "-C", self.folder, "-n", *build.programs):
            raise CannotBuild(f"{self.folder}: the copied build differs from {build.folder}")

    def try_out(self, mutant, batches, subject=None):
        """The verdict on a mutant by these lists of tests, one after the other.

        Where a subject is given, its units are compiled again, and `check` is asked first.
        """
        path = self.source / mutant.path
        units = subject.units_for(mutant) if subject else (mutant.path,)
        objects = set().union(*(self._original.objects[unit] for unit in units))
        try:
            path.write_text(mutant.text_of(path.read_text(encoding="utf-8")), encoding="utf-8")
            self._add_flags(objects, mutant.flags)
            for name in objects:
                self.folder.joinpath(name).unlink(missing_ok=True)
            if not self.rebuild({PROGRAM} if subject else objects):
                return Verdict("refused")
            if subject:
                return self.check() or self._fate(batches)
            if all(self.folder.joinpath(name).read_bytes() == self._original.folder.joinpath(name).read_bytes()
                   for name in objects):
                return Verdict("equivalent", difference="same code")
            return self._fate(batches)
        except TimeoutError:
            return Verdict("not tried")
        finally:
            self._restore()

    def check(self):
        """How `check` disagrees; None if it agrees."""
        done = self._run(self.folder / PROGRAM, "check", "--json", "--jobs", "1", "scenarios", cpu_s=_CHECK_S_MAX)
        if done.returncode == 0:
            return None
        if done.returncode < 0:
            hangs = done.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
            return Verdict("caught", "check", "hangs" if hangs else "crashes")
        if not done.stdout:
            return Verdict("caught", "check", "fails")
        entry = next(each for each in json.loads(done.stdout)["results"] if each["status"] != "agreed")
        first = entry["first_divergence"] or {}
        kind = entry["class"] or ("failed" if entry["status"] == "failed" else "expect")
        return Verdict("caught", "check", f"{entry['scenario']} {first.get('step', '')} {kind}")

    def _add_flags(self, objects, flags):
        """Compiles these objects with more flags."""
        if flags:
            path = self.folder / "build.ninja"
            names = "|".join(map(re.escape, objects))
            path.write_text(re.sub(rf"^(build (?:{names}): (?:.*\n)+?  FLAGS = .*)", rf"\1 {' '.join(flags)}",
                                   path.read_text(encoding="utf-8"), flags=re.MULTILINE), encoding="utf-8")

    def _fate(self, batches):
        for tests in filter(None, batches):
            if not self.rebuild(set().union(*(test.programs for test in tests))):
                return Verdict("refused")
            outcomes = self.outcomes(tests, "--stop-on-failure")
            for name, outcome, _ in outcomes:
                if outcome not in PASSED:
                    return Verdict("caught", name, difference=outcome)
            if len(outcomes) != len(tests):
                raise CannotBuild(f"ctest ran {len(outcomes)} of {len(tests)} tests")
        return Verdict("survived")

    def rebuild(self, targets):
        """Whether ninja can build them."""
        return self._run("ninja", "-C", self.folder, "-j1", *targets).returncode == 0

    def outcomes(self, tests, *options):
        """[(name, outcome, seconds)] of these tests."""
        names = "|".join(re.escape(test.name) for test in tests)
        done = self._run("ctest", "--test-dir", self.folder, "-L", "everyday", "-R", f"^({names})$",
                         "--timeout", str(self._test_s_max), *options)
        return [(name, outcome, float(seconds)) for name, outcome, seconds in _OUTCOME.findall(done.stdout)]

    def stop(self):
        """Ends running commands and starts no others. May be called by any thread."""
        self._is_stopped = True
        running = self._running
        if running:
            self._end(running)

    def _run(self, *command, cpu_s="unlimited"):
        """Runs a command in its own session and kills what is left of it. Raises TimeoutError at the deadline."""
        if self._is_stopped or time.monotonic() >= self._deadline_s:
            raise TimeoutError
        self._temporary.mkdir(exist_ok=True)
        limits = ("prlimit", f"--as={_ADDRESS_SPACE_MAX}", f"--fsize={_FILE_SIZE_MAX}", "--core=0", f"--cpu={cpu_s}")
        with subprocess.Popen([*limits, *map(str, command)], cwd=self.source, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace",
                              start_new_session=True,
                              env={**os.environ, "TMPDIR": str(self._temporary)}) as process:
            self._running = process
            try:
                said, _ = process.communicate(timeout=self._deadline_s - time.monotonic())
            except subprocess.TimeoutExpired:
                raise TimeoutError from None
            finally:
                self._running = None
                self._end(process)
        if self._is_stopped:
            raise TimeoutError
        return subprocess.CompletedProcess(command, process.returncode, said)

    @staticmethod
    def _end(process):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass

    def _files(self):
        roots = {copy for _, copy in self._moves if not copy.is_relative_to(self.source)} | {self.source}
        return [pathlib.Path(at, name) for root in roots for at, _, names in os.walk(root) for name in names]

    def _stamps_now(self):
        states = {path: path.lstat() for path in self._files()}
        return {path: (state.st_mtime_ns, state.st_size) for path, state in states.items()}

    def _restore(self):
        shutil.rmtree(self._temporary, ignore_errors=True)
        now = self._stamps_now()
        for path in now.keys() - self._stamps.keys():
            path.unlink()
        for path, stamp in self._stamps.items():
            if now.get(path) != stamp:
                self._copy(path)

    def _copy(self, path):
        """Copies one file from the original, with its time."""
        base, original = next((copy, original) for original, copy in self._moves if path.is_relative_to(copy))
        origin = original / path.relative_to(base)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        shutil.copy2(origin, path, follow_symlinks=False)
        if path.name in _RELOCATED:
            path.write_text(self._relocated(path.read_text(encoding="utf-8")), encoding="utf-8")
            shutil.copystat(origin, path)

    def _relocated(self, text):
        """The text of a file of the build, for the copy."""
        for original, copy in self._moves:
            text = re.sub(rf"{re.escape(str(original))}(?![\w.-])", str(copy), text)
        text = re.sub(r"^build build\.ninja: (?:.*\n)+?\n", "", text, flags=re.MULTILINE)  # CMake does not run again.
        text = re.sub(r"^  (?:deps|depfile) = .*\n", "", text, flags=re.MULTILINE)
        # A generator's outputs are kept though their commands have changed, as all have with the paths.
        text = re.sub(r"^(rule .*\n)", r"\1  generator = 1\n", text, flags=re.MULTILINE)
        text = re.sub(r' TIMEOUT "\d+"', f' TIMEOUT "{self._test_s_max}"', text)
        return text.replace(" -Werror", " -w")
