"""What a row lacks on this machine, what became of it, and the table of all."""

import dataclasses
import functools
import glob
import os
import pathlib
import re
import shutil

IN_CI = os.environ.get("CI") == "true"


@functools.cache
def processor_features():
    """The flags of /proc/cpuinfo; none where the processor is of another family."""
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    text = cpuinfo.read_text(encoding="utf-8") if cpuinfo.exists() else ""
    found = re.search(r"^flags\s*:(.*)$", text, re.MULTILINE)
    return frozenset(found.group(1).split()) if found else frozenset()


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
    if features := [feature for feature in row.cpu if feature not in processor_features()]:
        return Result(name, built_by, flags, runs_on, f"not run here: the processor lacks {features[0]}")
    if packages := [need.package for need in row.needs if not (glob.glob(need.what) or shutil.which(need.what))]:
        return Result(name, built_by, flags, runs_on, f"skipped: needs {' '.join(packages)}", IN_CI,
                      "with CI=true, what is missing is a failure")
    return None


def to_markdown(results):
    """All results, one a line."""
    rows = [("platform", "built by", "flags", "run by", "state hashes"), *(
        (result.name, result.built_by, f"`{result.flags}`" if result.flags else "", result.runs_on, result.verdict)
        for result in results)]
    widths = [max(map(len, column)) for column in zip(*rows)]
    head, *lines = ("| " + " | ".join(f"{cell:<{width}}" for cell, width in zip(row, widths)) + " |" for row in rows)
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([head, rule, *lines]) + "\n"
