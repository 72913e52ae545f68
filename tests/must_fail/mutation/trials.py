"""Tries mutants in copies of a build: the core's by `check`, all others by the everyday tests, the nearest first."""

import concurrent.futures
import pathlib
import queue
import re
import sys
import time

from build_copy import PASSED, Verdict
from original_build import CannotBuild
from subjects import SUBJECTS

_SLOW_S = 5.0
_NOT_STARTED = Verdict("not tried"), 0.0


def batches_of(mutant, tests, seconds):
    """The tests in lists, the nearest first: of the same folder; of a like name; the others, the slow ones last."""
    path = pathlib.PurePath(mutant.path)
    names = {path.parent.name, *re.findall(r"[a-z0-9]+", path.stem)}
    batches = [[], [], [], []]
    for test in tests:
        is_alike = not names.isdisjoint(re.findall(r"[a-z0-9]+", test.name))
        is_slow = seconds[test.name] > _SLOW_S
        batches[0 if test.is_of_folder(path) else 1 if is_alike and not is_slow else 2 if not is_slow else 3].append(test)
    return batches


class Trials:
    """Tries mutants in several copies of a build at a time. Those of the core are shown to `check` first."""

    def __init__(self, build, copies, reasons, are_of_core):
        self._build, self._copies, self._reasons, self._are_of_core = build, copies, reasons, are_of_core
        self._free = queue.SimpleQueue()
        self._seconds = {}
        for copy in copies:
            self._free.put(copy)

    def run(self, mutants):
        """{mutant: (Verdict, seconds)}, in the order of the mutants."""
        try:
            self._measure(mutants)
        except TimeoutError:
            return dict.fromkeys(mutants, _NOT_STARTED)
        with concurrent.futures.ThreadPoolExecutor(len(self._copies)) as pool:
            tries = [pool.submit(self._try_out, mutant) for mutant in mutants]
            try:
                return {mutant: one.result() for mutant, one in zip(mutants, tries, strict=True)}
            except BaseException:
                for copy in self._copies:
                    copy.stop()
                raise

    def _tests_of(self, mutant):
        """Of a mutant of the core only the unit tests of its folder, where a reason says that they catch it."""
        tests = self._build.tests_of(mutant.path)
        if not self._are_of_core:
            return tests
        reason = self._reasons.get((mutant.path, mutant.name))
        path = pathlib.PurePath(mutant.path)
        return [test for test in tests if reason and reason.is_caught_by_unit_test and test.is_of_folder(path)]

    def _measure(self, mutants):
        """Every test must pass in a copy without a change, or mutants would be caught for no reason."""
        if self._are_of_core and (found := self._copies[0].check()):
            raise CannotBuild(f"the unchanged program disagrees: {found.difference}")
        tests = {test.name: test for mutant in mutants for test in self._tests_of(mutant)}
        outcomes = self._copies[0].outcomes(tests.values(), "-j", str(len(self._copies))) if tests else []
        self._seconds = {name: seconds for name, outcome, seconds in outcomes if outcome in PASSED}
        failed = sorted(tests.keys() - self._seconds.keys())
        if failed:
            raise CannotBuild(f"tests fail, or take too long, without any change: {', '.join(failed)}")

    def _try_out(self, mutant):
        copy = self._free.get()
        begin_s = time.monotonic()
        batches = batches_of(mutant, self._tests_of(mutant), self._seconds)
        try:
            subject = next(subject for subject in SUBJECTS if subject.path == mutant.path) if self._are_of_core else None
            verdict = copy.try_out(mutant, batches, subject)
            seconds = time.monotonic() - begin_s
            print(f"{mutant.path}:{mutant.line}: {verdict.fate} {verdict.caught_by} {seconds:.0f} s", file=sys.stderr)
            return verdict, seconds
        finally:
            self._free.put(copy)
