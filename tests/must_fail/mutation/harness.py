#!/usr/bin/python3
"""Draws small changes of what decides verdicts, and asks the everyday tests whether they notice.

    harness.py --build build/tools                        # 100 mutants, drawn at random
    harness.py --build build/tools --seed 7 --count 10    # ten, the same ones each time
    harness.py --build build/tools --only 'ulps.h: .* < ' # those whose file and name match

As many mutants are drawn from each folder. A mutant is caught by a test that fails or takes too long, refused by
the compiler, equivalent (the compiler makes the same code of it, or harness_reasons.json has the reason), or
survives. The exit code is 0 if none survives, 1 if one does, 3 if nothing can be built.
"""

import argparse
import concurrent.futures
import math
import pathlib
import queue
import random
import re
import signal
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # The source tree stays as it is.

from build_copy import Build, BuildCopy
from harness_table import report_of
from judge import Verdict
from mutators import mutants_of
from reasons import faults_of, read_reasons
from workshop import CannotBuild

FOLDERS = ("sim/compare", "sim/replay", "sim/reference", "sim/study", "tools/files", "tools/store", "tools/hyrax-sim")
NONE_SURVIVED, SURVIVED, CANNOT_BUILD = 0, 1, 3
_SLOW_S = 5.0
_NOT_STARTED = Verdict("not tried"), 0.0


def mutants_by_folder(build):
    """{folder: [Mutant]} of all sources that the build compiles.

    Other flags are left out, and constants that move by one ulp: in these folders no verdict depends on it.
    """
    found = {}
    for folder in FOLDERS:
        paths = sorted(path for path in build.objects if path.startswith(f"{folder}/"))
        texts = {path: (build.source / path).read_text(encoding="utf-8") for path in paths}
        found[folder] = [mutant for path in paths for mutant in mutants_of(path, texts[path])
                         if not mutant.flags and not _is_by_one_ulp(mutant, texts[path])]
    return found


def _is_by_one_ulp(mutant, text):
    try:
        before, after = float(text[mutant.begin:mutant.end]), float(mutant.replacement)
    except ValueError:
        return False
    return mutant.kind == "constant" and math.isclose(before, after, rel_tol=1e-12, abs_tol=1e-300)


def drawn(by_folder, count, generator):
    """So many mutants, equally many of each folder as far as it has them, in random order."""
    left = {folder: generator.sample(mutants, len(mutants)) for folder, mutants in by_folder.items()}
    chosen = []
    while len(chosen) < count and any(left.values()):
        folders = [folder for folder, mutants in left.items() if mutants]
        for folder in generator.sample(folders, min(len(folders), count - len(chosen))):
            chosen.append(left[folder].pop())
    return chosen


def batches_of(mutant, tests, seconds):
    """The tests in lists, the nearest first: of the same folder; of a like name; the others, the slow ones last."""
    path = pathlib.PurePath(mutant.path)
    words = {path.parent.name, *re.findall(r"[a-z0-9]+", path.stem)}
    batches = [[], [], [], []]
    for test in tests:
        above = pathlib.PurePath("tests/unit")
        is_of_folder = test.folder.is_relative_to(above) and path.is_relative_to(test.folder.relative_to(above))
        is_alike = not words.isdisjoint(re.findall(r"[a-z0-9]+", test.name))
        is_slow = seconds[test.name] > _SLOW_S
        batches[0 if is_of_folder else 1 if is_alike and not is_slow else 2 if not is_slow else 3].append(test)
    return batches


class Trials:
    """Tries mutants in several copies of a build at a time."""

    def __init__(self, build, copies, may_ask):
        self._build, self._copies, self._may_ask = build, copies, may_ask
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
                return {mutant: one.result() for mutant, one in zip(mutants, tries)}
            except BaseException:
                for copy in self._copies:
                    copy.stop()
                raise

    def _tests(self, path):
        return [test for test in self._build.tests_of(path) if self._may_ask.search(test.name)]

    def _measure(self, mutants):
        """Every test must pass in a copy without a change, or mutants would be caught for no reason."""
        tests = {test.name: test for mutant in mutants for test in self._tests(mutant.path)}
        outcomes = self._copies[0].outcomes(tests.values(), "-j", str(len(self._copies))) if tests else []
        self._seconds = {name: seconds for name, outcome, seconds in outcomes if outcome in ("Passed", "Skipped")}
        failed = sorted(tests.keys() - self._seconds.keys())
        if failed:
            raise CannotBuild(f"tests fail, or take too long, without any change: {', '.join(failed)}")

    def _try_out(self, mutant):
        copy = self._free.get()
        begin_s = time.monotonic()
        try:
            verdict = copy.try_out(mutant, batches_of(mutant, self._tests(mutant.path), self._seconds))
            return verdict, time.monotonic() - begin_s
        finally:
            self._free.put(copy)


def state_of(source):
    """Time and size of every file of the project but for builds."""
    paths = [path for top in source.iterdir() if top.name not in ("build", ".git")
             for path in ([top] if top.is_file() else top.rglob("*")) if path.is_file()]
    return {path: (path.stat().st_mtime_ns, path.stat().st_size) for path in paths}


def faults_in(trials, build, reasons, everything):
    """Sentences about reasons that do not hold, and survivors without one."""
    verdicts = {mutant: verdict for mutant, (verdict, _) in trials.items() if verdict.fate in ("caught", "survived")}
    survivors = [mutant for mutant, verdict in verdicts.items()
                 if verdict.fate == "survived" and (mutant.path, mutant.name) not in reasons]
    return [*faults_of(reasons, everything, verdicts),
            *(f"{build.source / mutant.path}:{mutant.line}: {mutant.name}: survived; add a test that catches it, or its "
              "reason to harness_reasons.json" for mutant in survivors)]


def options():
    """What the command line asks for."""
    here = pathlib.Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build of the project with its tests, by ninja")
    parser.add_argument("--source", type=pathlib.Path, default=here.parents[2], help="the project")
    parser.add_argument("--reasons", type=pathlib.Path, default=here / "harness_reasons.json",
                        help="why some mutants cannot be caught")
    parser.add_argument("--count", type=int, default=100, metavar="N", help="mutants to draw (100)")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 32), help="repeats a draw")
    parser.add_argument("--only", type=re.compile, default=re.compile(""), metavar="REGEX",
                        help="draws from those whose file and name match")
    parser.add_argument("--tests", type=re.compile, default=re.compile(""), metavar="REGEX",
                        help="asks only the everyday tests whose name matches")
    parser.add_argument("--jobs", type=int, default=2, help="mutants at a time, each in a copy of the build (2)")
    parser.add_argument("--minutes", type=float, default=120.0, help="time limit of all; the rest is not tried (120)")
    parser.add_argument("--test-seconds", type=int, default=120, help="time limit of a test (120)")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE", help="writes the table there, too")
    parser.add_argument("--list", action="store_true", help="prints the mutants drawn, and builds none")
    return parser.parse_args()


def run(asked):
    """Tries what the options ask for; returns the exit code."""
    deadline_s = time.monotonic() + 60.0 * asked.minutes
    build = Build(asked.source, asked.build)
    by_folder = mutants_by_folder(build)
    everything = [mutant for mutants in by_folder.values() for mutant in mutants]
    by_folder = {folder: [mutant for mutant in mutants if asked.only.search(f"{mutant.path}: {mutant.name}")]
                 for folder, mutants in by_folder.items()}
    mutants = drawn(by_folder, asked.count, random.Random(asked.seed))
    print(f"Seed {asked.seed}: {len(mutants)} of {len(everything)} mutants", flush=True)
    if asked.list:
        print("\n".join(f"{mutant.path}:{mutant.line}: {mutant.name}" for mutant in mutants))
        return NONE_SURVIVED
    reasons = read_reasons(asked.reasons)
    before = state_of(build.source)
    with tempfile.TemporaryDirectory(prefix="hyrax-mutation-", ignore_cleanup_errors=True) as folder:
        copies = [BuildCopy(build, pathlib.Path(folder, str(number)), asked.test_seconds, deadline_s)
                  for number in range(asked.jobs)]
        trials = Trials(build, copies, asked.tests).run(mutants)
    report = report_of(trials, reasons, asked.seed)
    print(report)
    if asked.markdown:
        asked.markdown.write_text(report, encoding="utf-8")
    changed = {path for path, _ in before.items() ^ state_of(build.source).items()}
    faults = [*faults_in(trials, build, reasons, everything), *(f"{path}: was changed meanwhile" for path in changed)]
    print("".join(f"FAULT: {fault}\n" for fault in faults), end="")
    return SURVIVED if faults else NONE_SURVIVED


def main():
    """Returns the exit code."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        return run(options())
    except CannotBuild as why:
        print(why, file=sys.stderr)
        return CANNOT_BUILD


if __name__ == "__main__":
    sys.exit(main())
