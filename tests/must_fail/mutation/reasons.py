"""The reasons for mutants that `check` cannot distinguish from the program, and whether they still hold."""

import dataclasses
import json


@dataclasses.dataclass(frozen=True)
class Reason:
    """Why no scenario distinguishes a mutant from the program, and whether a unit test does.

    may_crash: its behaviour is undefined, so it may also be caught by a crash.
    """

    text: str
    is_caught_by_unit_test: bool
    may_crash: bool = False


def read_reasons(path):
    """{(file, mutant's name): Reason}"""
    reasons = {}
    for entry in json.loads(path.read_text(encoding="utf-8")):
        for file, names in entry["mutants"].items():
            for name in names:
                if (file, name) in reasons:
                    raise ValueError(f"{path}: {file}: {name}: duplicate reason")
                reasons[file, name] = Reason(entry["reason"], entry.get("caught_by") == "unit test",
                                             entry.get("may_crash", False))
    return reasons


def faults_of(reasons, mutants, verdicts):
    """Messages about reasons that do not hold: their mutant does not exist, is caught or does not compile.

    mutants: all there are; verdicts: {mutant: Verdict} of those that were tried.
    """
    known = {(mutant.path, mutant.name) for mutant in mutants}
    faults = [f"{path}: {name}: there is no such mutant; take its reason out" for path, name in reasons
              if (path, name) not in known]
    for mutant, verdict in verdicts.items():
        reason = reasons.get((mutant.path, mutant.name))
        if reason and verdict.fate != "survived" and not (reason.may_crash and verdict.difference == "crashes"):
            faults.append(f"{mutant.path}: {mutant.name}: is said to be equivalent, and is {verdict.fate}; "
                          "take its reason out")
    return faults
