"""The scenarios with the expected state hash of each, played with hyrax-replay; what comes of it is held to what must."""

import dataclasses
import json
import pathlib
import re

from rows import EMULATED_STEPS_MAX, NOT_STRICT, PROJECT


@dataclasses.dataclass(frozen=True)
class Known:
    """The recorded results of a scenario."""

    state_hash: str
    steps: int


def known_of(path, golden):
    """From the golden file's digest, or the hash that a recording carries; from no other build."""
    digest = (golden / path.relative_to(PROJECT / "scenarios")).with_suffix(".txt")
    if digest.exists():
        text = digest.read_text(encoding="utf-8")
        return Known(re.search(r"^state hash: ([0-9a-f]{32})$", text, re.MULTILINE).group(1),
                     int(re.search(r"^steps: (\d+)$", text, re.MULTILINE).group(1)))
    scenario = json.loads(path.read_text(encoding="utf-8"))
    return Known(scenario["expect"]["state_hash"], scenario.get("steps", 0))


def library(golden: pathlib.Path):
    """{path below the project: its recorded results}, in name order."""
    paths = sorted((PROJECT / "scenarios").rglob("*.json"))
    return {path.relative_to(PROJECT).as_posix(): known_of(path, golden) for path in paths}


def compiler_of(start, row):
    """The compiler that the program reports, or else that of the row."""
    lines = start("--version").out.splitlines()
    reported = [line.split(None, 1)[1] for line in lines if line.startswith("compiler ")]
    return reported[0].split(" (")[0] if reported else row.compiler


def play(start, row, scenarios, is_reversed=False):
    """Plays what the row can; returns (verdict, is_as_golden, what was printed on stderr)."""
    chosen = [path for path, known in scenarios.items()
              if row.runs_on == "this machine" or known.steps <= EMULATED_STEPS_MAX]
    outcome = start(*(chosen[::-1] if is_reversed else chosen))
    found = dict(line.split("  ", 1)[::-1] for line in outcome.out.splitlines())  # {scenario: hash}
    different = [path for path in chosen if found.get(path) != scenarios[path].state_hash]
    left_out = f" ({len(scenarios) - len(chosen)} too long for an emulator)" if len(chosen) < len(scenarios) else ""
    if not chosen or len(found) < len(chosen) or (outcome.exit_code != 0 and not different):
        return f"FAILED: exit code {outcome.exit_code}, {len(found)} of {len(chosen)} played", None, outcome.err
    if different:
        return f"{len(different)} of {len(chosen)} DIFFERENT{left_out}", False, "\n".join(
            f"{path}: golden {scenarios[path].state_hash}, here {found[path]}" for path in different)
    return f"{len(chosen)} of {len(chosen)} agree{left_out}", True, ""


def refusal(start, must):
    """(verdict, whether the program refuses at its start with that sentence, before it plays anything, stderr)."""
    outcome = start()
    is_refused = outcome.exit_code == NOT_STRICT and not outcome.out
    if is_refused and must.sentence in outcome.err and outcome.err.count("\n") == 1:
        return f"refused at start, exit code 5: {must.sentence}", True, ""
    return f"NOT REFUSED: exit code {outcome.exit_code}", False, outcome.err


def judge(start, row, scenarios, must, is_reversed=False):
    """(verdict, is_bad, details) of one run; `start` runs the program with its arguments."""
    if must.kind == "starts":
        verdict, is_good, details = refusal(lambda: start(*scenarios), must)
        return verdict, not is_good, details
    verdict, agrees, details = play(start, row, scenarios, is_reversed)
    if must.kind == "differs":
        if agrees is False:
            return f"{verdict.replace('DIFFERENT', 'different')}, as must be", False, ""
        return f"{verdict}, but must differ", True, details
    return verdict, agrees is not True, details
