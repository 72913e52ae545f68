#!/usr/bin/python3
"""Makes small changes of the sources and sees whether they are detected.

    mutation.py --build build/tools --core                # every change of the core, the clock and the events
    mutation.py --build build/tools                       # 100 changes of the other sources, drawn at random
    mutation.py --build build/tools --seed 7 --count 10   # ten, the same ones each time
    mutation.py --build build/tools --only 'ulps.h: .* < '

A mutant of the core must be caught by `hyrax-sim check` of all scenarios, or, where reasons.json says so, by the unit
test of its folder. Of the other sources as many mutants are drawn from each folder, and the everyday tests that run
their code must catch them: one that fails, or takes too long. Others are refused by the compiler, or equivalent (the
compiler makes the same code of it, or reasons.json has the reason). The exit code is 0 if none survives and all
reasons hold, 1 if not, 3 if nothing can be built.
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

# pylint: disable=wrong-import-position
from build_copy import BuildCopy
from original_build import Build, CannotBuild
from reasons import faults_of, read_reasons
from subjects import drawn, mutants_by_subject
from table import report_of
from trials import Trials

NONE_SURVIVED, SURVIVED, CANNOT_BUILD = 0, 1, 3


def options():
    here = pathlib.Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build of all tests, by ninja")
    parser.add_argument("--source", type=pathlib.Path, default=here.parents[2], help="the project")
    parser.add_argument("--reasons", type=pathlib.Path, default=here / "reasons.json", help="why some cannot be caught")
    parser.add_argument("--core", action="store_true", help="changes the core, the clock and the events")
    parser.add_argument("--count", type=int, default=100, metavar="N", help="mutants to draw of other sources (100)")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 32), help="repeats a draw")
    parser.add_argument("--only", type=re.compile, default=re.compile(""), metavar="REGEX",
                        help="those whose file and name match")
    parser.add_argument("--jobs", type=int, default=2, help="mutants at a time, each in a copy of the build (2)")
    parser.add_argument("--minutes", type=float, default=120.0, help="time limit of all; the rest is not tried (120)")
    parser.add_argument("--test-seconds", type=int, default=120, help="time limit of a test (120)")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE", help="writes the table there, too")
    parser.add_argument("--list", action="store_true", help="names the mutants, and builds none")
    return parser.parse_args()


def run(asked):
    """Tries the mutants that the options select; returns the exit code."""
    deadline_s = time.monotonic() + 60.0 * asked.minutes
    build = Build(asked.source, asked.build, of_units_only=asked.core)
    by_subject = mutants_by_subject(build)
    everything = [mutant for mutants in by_subject.values() for mutant in mutants]
    matching = [[mutant for mutant in mutants if asked.only.search(f"{mutant.path}: {mutant.name}")]
                for (subject, _), mutants in by_subject.items() if subject.is_core == asked.core]
    mutants = sum(matching, []) if asked.core else drawn(asked.count, matching, random.Random(asked.seed))
    print(f"{'' if asked.core else f'Seed {asked.seed}: '}{len(mutants)} of {len(everything)} mutants", flush=True)
    if asked.list:
        print("\n".join(f"{mutant.path}:{mutant.line}: {mutant.kind}: {mutant.name}" for mutant in mutants))
        return NONE_SURVIVED
    reasons = read_reasons(asked.reasons)
    with tempfile.TemporaryDirectory(prefix="hyrax-mutation-", ignore_cleanup_errors=True) as folder:
        os.chmod(folder, 0o755)  # Some tests run the programs as another user.
        copies = [BuildCopy(build, pathlib.Path(folder, str(number)), asked.test_seconds, deadline_s)
                  for number in range(asked.jobs)]
        trials = Trials(build, copies, reasons, asked.core).run(mutants)
    report = report_of(trials, reasons,
                       lambda mutant: mutant.path if asked.core else "/".join(mutant.path.split("/")[:2]))
    print(report)
    if asked.markdown:
        asked.markdown.write_text(report, encoding="utf-8")
    faults = faults_of(reasons, everything, {mutant: verdict for mutant, (verdict, _) in trials.items()})
    if all(verdict.fate == "not tried" for verdict, _ in trials.values()):
        faults.append(f"no mutant was tried within {asked.minutes:g} minutes")
    print("".join(f"FAULT: {fault}\n" for fault in faults), end="")
    return SURVIVED if faults else NONE_SURVIVED


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        return run(options())
    except CannotBuild as why:
        print(why, file=sys.stderr)
        return CANNOT_BUILD


if __name__ == "__main__":
    sys.exit(main())
