#!/usr/bin/python3
"""Draws small changes of the code that decides verdicts, and runs the everyday tests to see whether they fail.

    harness.py --build build/tools                        # 100 mutants, drawn at random
    harness.py --build build/tools --seed 7 --count 10    # ten, the same ones each time
    harness.py --build build/tools --only 'ulps.h: .* < ' # those whose file and name match

As many mutants are drawn from each folder. A mutant is caught by a test that fails or takes too long, refused by
the compiler, equivalent (the compiler makes the same code of it, or harness_reasons.json has the reason), or
survives. The exit code is 0 if none survives, 1 if one does, 3 if nothing can be built.
"""

import argparse
import os
import pathlib
import random
import re
import signal
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # The source tree stays as it is.
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "cli"))

from build_copy import BuildCopy
from draw import drawn, mutants_by_folder
from harness_table import report_of
from original_build import Build
from reasons import faults_of, read_reasons
from trials import Trials
from workshop import CannotBuild

NONE_SURVIVED, SURVIVED, CANNOT_BUILD = 0, 1, 3


def state_of(source):
    """Time and size of every file of the project outside of build folders."""
    paths = [path for top in source.iterdir() if top.name not in ("build", ".git")
             for path in ([top] if top.is_file() else top.rglob("*")) if path.is_file()]
    return {path: (path.stat().st_mtime_ns, path.stat().st_size) for path in paths}


def faults_in(trials, reasons, everything):
    """Messages about reasons that do not hold, and about survivors without one."""
    verdicts = {mutant: verdict for mutant, (verdict, _) in trials.items() if verdict.fate in ("caught", "survived")}
    survivors = [mutant for mutant, verdict in verdicts.items()
                 if verdict.fate == "survived" and (mutant.path, mutant.name) not in reasons]
    return [*faults_of(reasons, everything, verdicts),
            *(f"{mutant.path}:{mutant.line}: {mutant.name}: survived; add a test that catches it, or its reason to "
              "harness_reasons.json" for mutant in survivors)]


def options():
    """The options of the command line."""
    here = pathlib.Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build of all tests, by ninja")
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
    """Tries the mutants that the options select; returns the exit code."""
    deadline_s = time.monotonic() + 60.0 * asked.minutes
    build = Build(asked.source, asked.build, asked.tests)
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
        os.chmod(folder, 0o755)  # Some tests run the programs as another user.
        copies = [BuildCopy(build, pathlib.Path(folder, str(number)), asked.test_seconds, deadline_s)
                  for number in range(asked.jobs)]
        trials = Trials(build, copies).run(mutants)
    report = report_of(trials, reasons, asked.seed)
    print(report)
    if asked.markdown:
        asked.markdown.write_text(report, encoding="utf-8")
    for path in sorted({path for path, _ in before.items() ^ state_of(build.source).items()}):
        print(f"NOTE: {path}: was changed meanwhile, by someone else or by a test")
    faults = faults_in(trials, reasons, everything)
    if all(verdict.fate == "not tried" for verdict, _ in trials.values()):
        faults.append(f"no mutant was tried within {asked.minutes:g} minutes")
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
