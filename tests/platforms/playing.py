"""Plays scenarios with hyrax-replay and holds what comes of it to what must."""

import os
import subprocess

from rows import EMULATED_STEPS_MAX, NOT_STRICT, PROJECT

TIMEOUT_S = 600


def run(program, arguments, row, environment):
    """Runs a program of the row in the project's folder."""
    return subprocess.run([*row.runner, str(program), *arguments], cwd=PROJECT, env={**os.environ, **environment},
                          capture_output=True, stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, check=False)


def compiler_of(program, row, environment):
    """As the program itself tells it."""
    lines = run(program, ["--version"], row, environment).stdout.decode().splitlines()
    told = [line.split(None, 1)[1] for line in lines if line.startswith("compiler ")]
    return told[0].split(" (")[0] if told else row.compiler


def hashes_of(output):
    """{scenario: hash} of what hyrax-replay printed."""
    lines = (line.split("  ", 1) for line in output.decode().splitlines())
    return {path: state_hash for state_hash, path in lines}


def play(program, row, scenarios, environment, is_reversed=False):
    """Plays what the row can; returns (verdict, is_as_golden, what was printed on stderr)."""
    chosen = [path for path, known in scenarios.items()
              if row.runs_on == "this machine" or known.steps <= EMULATED_STEPS_MAX]
    done = run(program, chosen[::-1] if is_reversed else chosen, row, environment)
    found = hashes_of(done.stdout)
    different = [path for path in chosen if found.get(path) != scenarios[path].state_hash]
    left_out = f" ({len(scenarios) - len(chosen)} too long for an emulator)" if len(chosen) < len(scenarios) else ""
    errors = done.stderr.decode(errors="replace")
    if not chosen or len(found) < len(chosen) or (done.returncode != 0 and not different):
        return f"FAILED: exit code {done.returncode}, {len(found)} of {len(chosen)} played", None, errors
    if different:
        return f"{len(different)} of {len(chosen)} DIFFERENT{left_out}", False, "\n".join(
            f"{path}: golden {scenarios[path].state_hash}, here {found[path]}" for path in different)
    return f"{len(chosen)} of {len(chosen)} agree{left_out}", True, ""


def refusal(program, row, scenarios, environment, must):
    """Whether the program refuses at its start with that sentence, before it plays anything."""
    done = run(program, list(scenarios), row, environment)
    sentences = done.stderr.decode(errors="replace")
    if done.returncode == NOT_STRICT and not done.stdout and must.sentence in sentences and sentences.count("\n") == 1:
        return f"refused at start, exit code 5: {must.sentence}", True, ""
    return f"NOT REFUSED: exit code {done.returncode}", False, sentences


def judge(program, row, scenarios, environment, must, is_reversed=False):
    """(verdict, is_bad, details) of one run."""
    if must.kind == "starts":
        verdict, is_good, details = refusal(program, row, scenarios, environment, must)
        return verdict, not is_good, details
    verdict, agrees, details = play(program, row, scenarios, environment, is_reversed)
    if must.kind == "differs":
        if agrees is False:
            return f"{verdict.replace('DIFFERENT', 'different')}, as must be", False, ""
        return f"{verdict}, but must differ", True, details
    return verdict, agrees is not True, details
