#!/usr/bin/python3
"""Makes every small change of the core, the jitter and the events, and runs `hyrax-sim check` to detect it.

    mutation.py --build build/release                     # all mutants, in a table
    mutation.py --build build/release --one-in 5          # a fifth of each kind of change in each file
    mutation.py --build build/release --only 'update: .* <= '

A mutant is caught (by a scenario, at a step, as a class of difference), or survives. One that survives must
have its reason in reasons.json; where that names a unit test, the unit test must catch it. The exit
code is 0 if all is as expected, 1 if not, 3 if nothing can be built.
"""

import argparse
import concurrent.futures
import pathlib
import re
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "cli"))
# pylint: disable=wrong-import-position
from judge import Judge
from reasons import faults_of, read_reasons
from subjects import SUBJECTS
from table import summary_of, table_of
from workshop import CannotBuild, Workshop

ALL_IS_WELL, SURVIVED, CANNOT_BUILD = 0, 1, 3


def one_in(share, mutants):
    """Every so-manieth mutant of each kind of change in each file, and at least one of each."""
    alike = {}
    for mutant in mutants:
        alike.setdefault((mutant.path, mutant.kind), []).append(mutant)
    chosen = {mutant for group in alike.values() for mutant in group[::share]}
    return [mutant for mutant in mutants if mutant in chosen]


def try_all(judge, mutants, jobs):
    """{mutant: Verdict}, in the order of the mutants."""
    verdicts = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        tries = [pool.submit(judge.try_out, mutant, f"mutant-{number}") for number, mutant in enumerate(mutants)]
        for number, (mutant, one) in enumerate(zip(mutants, tries, strict=True), 1):
            verdicts[mutant] = one.result()
            if sys.stderr.isatty():
                print(f"\r{number} of {len(mutants)} mutants", end="", file=sys.stderr)
    if sys.stderr.isatty():
        print(file=sys.stderr)
    return verdicts


def survivors_without_reason(judge, verdicts, reasons, jobs):
    """Messages about mutants without a catch and without a reason."""
    survivors = [mutant for mutant, verdict in verdicts.items() if verdict.fate == "survived"]
    unexplained = [mutant for mutant in survivors if (mutant.path, mutant.name) not in reasons]
    explained = [mutant for mutant in survivors if mutant not in unexplained
                 and reasons[mutant.path, mutant.name].is_caught_by_unit_test]
    judge.prepare_unit_tests(explained)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        tries = [pool.submit(judge.fails_unit_test, mutant, f"unit-test-{number}")
                 for number, mutant in enumerate(explained)]
        unseen = [mutant for mutant, one in zip(explained, tries, strict=True) if not one.result()]
    return [*(f"{mutant.path}: {mutant.name}: survived; add a scenario that catches it, or its reason to reasons.json"
              for mutant in unexplained),
            *(f"{mutant.path}: {mutant.name}: survived, its unit tests as well; add one that catches it"
              for mutant in unseen)]


def options():
    """The options of the command line."""
    here = pathlib.Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build of the project, all tests built")
    parser.add_argument("--source", type=pathlib.Path, default=here.parents[2], help="the project")
    parser.add_argument("--scenarios", type=pathlib.Path, default="scenarios", help="what is checked")
    parser.add_argument("--reasons", type=pathlib.Path, default=here / "reasons.json", help="why some cannot be caught")
    parser.add_argument("--one-in", type=int, metavar="N", default=1,
                        help="every Nth of each kind of change in each file, at least one of each (1)")
    parser.add_argument("--only", type=re.compile, metavar="REGEX", help="those whose file and name match")
    parser.add_argument("--jobs", type=int, default=2, help="mutants at a time (2)")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE", help="writes the table there, too")
    parser.add_argument("--list", action="store_true", help="names the mutants, and builds none")
    return parser.parse_args()


def main():
    """Tries the mutants that the options select; returns the exit code."""
    asked = options()
    mutants = [mutant for subject in SUBJECTS for mutant in subject.mutants(asked.source)]
    chosen = [mutant for mutant in mutants if not asked.only or asked.only.search(f"{mutant.path}: {mutant.name}")]
    chosen = one_in(asked.one_in, chosen)
    if asked.list:
        print("\n".join(f"{mutant.kind:16} {mutant.path}: {mutant.name}" for mutant in chosen))
        return ALL_IS_WELL
    reasons = read_reasons(asked.reasons)
    with tempfile.TemporaryDirectory(prefix="hyrax-mutation-") as folder:
        paths = {mutant.path for mutant in chosen}
        subjects = [subject for subject in SUBJECTS if subject.path in paths]
        judge = Judge(Workshop(asked.source, asked.build, folder), subjects, asked.scenarios)
        try:
            judge.prepare()
            verdicts = try_all(judge, chosen, asked.jobs)
            faults = [*faults_of(reasons, mutants, verdicts),
                      *survivors_without_reason(judge, verdicts, reasons, asked.jobs)]
        except CannotBuild as why:
            print(why, file=sys.stderr)
            return CANNOT_BUILD
    print(table_of(verdicts, reasons))
    print(summary_of(verdicts, reasons))
    if asked.markdown:
        asked.markdown.write_text(f"{summary_of(verdicts, reasons)}\n{table_of(verdicts, reasons)}", encoding="utf-8")
    for fault in faults:
        print(f"FAULT: {fault}")
    return SURVIVED if faults else ALL_IS_WELL


if __name__ == "__main__":
    sys.exit(main())
