"""What became of a row."""

import dataclasses

from machine import IN_CI, missing_features, missing_packages


@dataclasses.dataclass(frozen=True)
class Result:
    """A line of the table."""

    name: str
    built_by: str = ""
    flags: str = ""
    runs_on: str = ""
    verdict: str = ""
    is_bad: bool = False
    details: str = ""  # Why it is bad.


def hindrance_of(row, name, built_by="", flags="", runs_on=""):
    """Why a row or variant is not played here, as its line; nothing where it can be."""
    if features := missing_features(row):
        return Result(name, built_by, flags, runs_on, f"not run here: the processor lacks {features[0]}")
    if packages := missing_packages(row):
        return Result(name, built_by, flags, runs_on, f"skipped: needs {' '.join(packages)}", IN_CI,
                      "with CI=true, what is missing is a failure")
    return None
