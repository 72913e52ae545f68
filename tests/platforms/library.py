"""The scenarios, and the expected state hash of each."""

import dataclasses
import json
import pathlib
import re

from rows import PROJECT


class NoConstant(Exception):
    """A scenario without an expected hash."""


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
    state_hash = scenario.get("expect", {}).get("state_hash")
    if state_hash is None:
        raise NoConstant(f"{path}: has neither a golden file nor expect.state_hash")
    return Known(state_hash, scenario.get("steps", 0))


def library(golden: pathlib.Path):
    """{path below the project: its recorded results}, in name order."""
    paths = sorted((PROJECT / "scenarios").rglob("*.json"))
    return {path.relative_to(PROJECT).as_posix(): known_of(path, golden) for path in paths}
