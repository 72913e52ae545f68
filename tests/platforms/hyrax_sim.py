"""hyrax-sim's `check`, which has HDF5 and threads: by one thread and by many, and in every variant of this build."""

import os

from building import environment_for
from process import run
from result import Result, hindrance_of
from rows import PROJECT, THIS_BUILD

MANY = 8
TIMEOUT_S = 600


def check(program, golden, environment, jobs=MANY):
    """`check --json` over the library."""
    return run(program, "check", "scenarios", "--golden", golden, "--jobs", jobs, "--json", cwd=PROJECT,
               env={**os.environ, **environment}, timeout=TIMEOUT_S)


def line(name, verdict, is_bad, details=""):
    return Result(f"hyrax-sim check, {name}", runs_on="this machine", verdict=verdict, is_bad=is_bad, details=details)


def agreement(name, outcome):
    """The line of a check in which every scenario must agree."""
    if not outcome.out:
        return line(name, f"FAILED: exit code {outcome.exit_code}", True, outcome.err)
    counts = outcome.json
    is_bad = counts["agreed"] != counts["checked"] or counts["checked"] == 0
    return line(name, f"{counts['agreed']} of {counts['checked']} agree", is_bad, outcome.out)


def lines_of(program, golden, folder):
    alone, together = check(program, golden, {}, 1), check(program, golden, {})
    yield agreement("1 thread", alone)
    yield agreement(f"{MANY} threads", together)
    if alone.out != together.out:
        yield line("1 thread and many", "NOT ALIKE", True, together.out)
    for variant in THIS_BUILD:
        if variant.is_reversed or variant.must.kind == "starts":
            continue  # strict_arithmetic_test has the refusals of every command.
        if hindrance := hindrance_of(variant, f"hyrax-sim check, {variant.name}", runs_on="this machine"):
            yield hindrance
            continue
        yield agreement(variant.name, check(program, golden, environment_for(variant, folder)))
