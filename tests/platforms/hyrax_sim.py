"""hyrax-sim's `check`, which has HDF5 and threads: by one thread and by many, and in every variant of this build."""

import json
import os
import subprocess

from preloading import environment_for
from result import Result, hindrance_of
from rows import NOT_STRICT, PROJECT, THIS_BUILD

MANY = 8
TIMEOUT_S = 600


def check(program, golden, environment, jobs=MANY):
    """`check --json` over the library."""
    return subprocess.run([str(program), "check", "scenarios", "--golden", str(golden), "--jobs", str(jobs), "--json"],
                          cwd=PROJECT, env={**os.environ, **environment}, capture_output=True,
                          stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, check=False)


def line(name, verdict, is_bad, details=""):
    """A line of the table."""
    return Result(f"hyrax-sim check, {name}", runs_on="this machine", verdict=verdict, is_bad=is_bad, details=details)


def agreement(name, done):
    """The line of a check in which every scenario must agree."""
    if not done.stdout:
        return line(name, f"FAILED: exit code {done.returncode}", True, done.stderr.decode())
    counts = json.loads(done.stdout)
    is_bad = counts["agreed"] != counts["checked"] or counts["checked"] == 0
    return line(name, f"{counts['agreed']} of {counts['checked']} agree", is_bad, done.stdout.decode())


def refusal(name, done, sentence):
    """The line of a check that must be refused."""
    is_refused = done.returncode == NOT_STRICT and not done.stdout and sentence in done.stderr.decode()
    if is_refused:
        return line(name, f"refused at start, exit code 5: {sentence}", False)
    return line(name, f"NOT REFUSED: exit code {done.returncode}", True, done.stderr.decode())


def lines_of(program, golden, folder):
    """All lines of hyrax-sim."""
    alone, together = check(program, golden, {}, 1), check(program, golden, {})
    yield agreement("1 thread", alone)
    yield agreement(f"{MANY} threads", together)
    if alone.stdout != together.stdout:
        yield line("1 thread and many", "NOT ALIKE", True, together.stdout.decode())
    for variant in THIS_BUILD:
        if variant.is_reversed:
            continue
        if hindrance := hindrance_of(variant, f"hyrax-sim check, {variant.name}", runs_on="this machine"):
            yield hindrance
            continue
        done = check(program, golden, environment_for(variant, folder))
        if variant.must.kind == "starts":
            yield refusal(variant.name, done, variant.must.sentence)
        else:
            yield agreement(variant.name, done)
