"""hyrax-sim's `check` by one thread and by many: the same verdicts, in the same words."""

import json
import subprocess

from playing import Result, TIMEOUT_S
from rows import PROJECT

MANY = 8


def check(program, golden, jobs):
    """The document of `check --json`."""
    done = subprocess.run([str(program), "check", "scenarios", "--golden", str(golden), "--jobs", str(jobs), "--json"],
                          cwd=PROJECT, capture_output=True, stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, check=False)
    return done.stdout.decode()


def check_with_many_jobs(program, golden):
    """The line of the table."""
    alone, together = check(program, golden, 1), check(program, golden, MANY)
    counts = json.loads(alone)
    verdict = f"{counts['agreed']} of {counts['checked']} agree"
    is_bad = alone != together or counts["agreed"] != counts["checked"]
    return Result(f"hyrax-sim check, 1 thread and {MANY}", "", "", "this machine",
                  verdict + ("" if alone == together else ", but not alike"), is_bad, alone if is_bad else "")
