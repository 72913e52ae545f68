"""Processor features and commands of this machine, and what a row lacks."""

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


def missing_packages(row):
    """Debian packages without which the row cannot be built or run."""
    return [need.package for need in row.needs if not (glob.glob(need.what) or shutil.which(need.what))]


def missing_features(row):
    """Features without which this processor cannot run the row."""
    return [feature for feature in row.cpu if feature not in processor_features()]
