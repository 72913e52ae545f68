"""The reasons for mutants that the tests cannot distinguish from the program, and whether they still hold."""

import dataclasses
import json


@dataclasses.dataclass(frozen=True)
class Reason:
    """Why a mutant is equivalent; or, of a mutant of the core, why only a unit test can catch it.

    may_crash: its behaviour is undefined, so it may also be caught by a crash.
    """

    text: str
    is_caught_by_unit_test: bool = False
    may_crash: bool = False

    def holds(self, verdict):
        """Whether the verdict does not contradict it."""
        is_caught = verdict.fate in ("caught", "refused")
        is_unit_test = self.is_caught_by_unit_test and verdict.caught_by not in ("", "check")
        return not is_caught or is_unit_test or (self.may_crash and verdict.difference == "crashes")


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
    """Messages about survivors without a reason, and about reasons that do not hold.

    mutants: all there are; verdicts: {mutant: Verdict} of those that were tried.
    """
    known = {(mutant.path, mutant.name) for mutant in mutants}
    faults = [f"{path}: {name}: there is no such mutant; take its reason out" for path, name in reasons
              if (path, name) not in known]
    for mutant, verdict in verdicts.items():
        reason, place = reasons.get((mutant.path, mutant.name)), f"{mutant.path}:{mutant.line}: {mutant.name}"
        if verdict.fate == "survived" and (reason is None or reason.is_caught_by_unit_test):
            faults.append(f"{place}: survived; add a test that catches it, or its reason to reasons.json")
        if reason and not reason.holds(verdict):
            said = "caught by a unit test alone" if reason.is_caught_by_unit_test else "equivalent"
            faults.append(f"{place}: is said to be {said}, and is {verdict.fate}; take its reason out")
    return faults
