"""Tries mutants in copies of a build, by the everyday tests, the nearest first."""

import concurrent.futures
import pathlib
import queue
import re
import sys
import time

from build_copy import PASSED
from judge import Verdict
from workshop import CannotBuild

_SLOW_S = 5.0
_NOT_STARTED = Verdict("not tried"), 0.0


def batches_of(mutant, tests, seconds):
    """The tests in lists, the nearest first: of the same folder; of a like name; the others, the slow ones last."""
    path = pathlib.PurePath(mutant.path)
    names = {path.parent.name, *re.findall(r"[a-z0-9]+", path.stem)}
    batches = [[], [], [], []]
    for test in tests:
        above = pathlib.PurePath("tests/unit")
        is_of_folder = test.folder.is_relative_to(above) and path.is_relative_to(test.folder.relative_to(above))
        is_alike = not names.isdisjoint(re.findall(r"[a-z0-9]+", test.name))
        is_slow = seconds[test.name] > _SLOW_S
        batches[0 if is_of_folder else 1 if is_alike and not is_slow else 2 if not is_slow else 3].append(test)
    return batches


class Trials:
    """Tries mutants in several copies of a build at a time."""

    def __init__(self, build, copies):
        self._build, self._copies = build, copies
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

    def _measure(self, mutants):
        """Every test must pass in a copy without a change, or mutants would be caught for no reason."""
        tests = {test.name: test for mutant in mutants for test in self._build.tests_of(mutant.path)}
        outcomes = self._copies[0].outcomes(tests.values(), "-j", str(len(self._copies))) if tests else []
        self._seconds = {name: seconds for name, outcome, seconds in outcomes if outcome in PASSED}
        failed = sorted(tests.keys() - self._seconds.keys())
        if failed:
            raise CannotBuild(f"tests fail, or take too long, without any change: {', '.join(failed)}")

    def _try_out(self, mutant):
        copy = self._free.get()
        begin_s = time.monotonic()
        try:
            verdict = copy.try_out(mutant, batches_of(mutant, self._build.tests_of(mutant.path), self._seconds))
            seconds = time.monotonic() - begin_s
            print(f"{mutant.path}:{mutant.line}: {verdict.fate} {verdict.caught_by} {seconds:.0f} s", file=sys.stderr)
            return verdict, seconds
        finally:
            self._free.put(copy)
