#!/usr/bin/env python3
"""Compares two builds of hyrax-sim over scenarios: results, files and JSON must be equal.

    tests/oracle/compare_builds.py OLD_PROGRAM NEW_PROGRAM [--without KEY]... [SCENARIO]...

Each scenario is run, measured with `drift`, and compared with its golden file by both programs. Equal must be: exit
codes; every dataset and attribute of the trajectory files except /provenance; every value of the JSON documents that
the old program prints (the new one may print more). Measured times are left out, and the JSON keys that --without
names (KEY or COMMAND:KEY). Without scenarios: all of scenarios/. Exit code 1 if anything differs.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys
import tempfile

import h5py
import numpy

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests/cli"))
import process  # noqa: E402  # Found by the line above.

LEFT_OUT = {"output", "step_ns", "files"}  # Measured, or named after the output; --without adds to it.


def call(program, *arguments):
    """Exit code, and the JSON document on standard output, or what was printed instead."""
    outcome = process.run(program, *arguments, cwd=SOURCE, timeout=600)
    try:
        return outcome.exit_code, outcome.json
    except json.JSONDecodeError:
        return outcome.exit_code, outcome.out + outcome.err


def json_differences(old, new, place):
    """Places where the new document lacks or changes a value of the old one; `place` begins with the command."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in old:
            if {key, f"{place.split(':')[0]}:{key}"} & LEFT_OUT:
                continue
            if key not in new:
                yield f"{place}/{key}: missing"
            else:
                yield from json_differences(old[key], new[key], f"{place}/{key}")
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for number, (old_entry, new_entry) in enumerate(zip(old, new, strict=True)):
            yield from json_differences(old_entry, new_entry, f"{place}/{number}")
    elif old != new:
        yield f"{place}: {json.dumps(old)[:60]} -> {json.dumps(new)[:60]}"


def contents(path):
    """{name: value} of all datasets and attributes, provenance left out."""
    found = {}

    def add(name, item):
        if name.split("/")[0] == "provenance":
            return
        for key, value in item.attrs.items():
            if key not in ("DIMENSION_LIST", "REFERENCE_LIST"):  # References within the file.
                found[f"{name}@{key}"] = value
        if isinstance(item, h5py.Dataset):
            found[name] = item[()]

    with h5py.File(path, "r") as file:
        add("", file)
        file.visititems(add)
    return found


def file_differences(old_path, new_path):
    old, new = contents(old_path), contents(new_path)
    for name, value in old.items():
        if name not in new:
            yield f"{name}: missing"
        elif numpy.asarray(value).tobytes() != numpy.asarray(new[name]).tobytes() and not (
                isinstance(value, str) and value == new[name]):
            yield f"{name}: differs"


def outcome_differences(command, old, new):
    if old[0] != new[0]:
        yield f"{command}: exit code {old[0]} -> {new[0]}"
    yield from json_differences(old[1], new[1], f"{command}: ")


def output_differences(old, new, *arguments):
    yield from outcome_differences(arguments[0], call(old, *arguments), call(new, *arguments))


def differences(old, new, scenario):
    """The differences of one scenario."""
    with tempfile.TemporaryDirectory(prefix="hyrax-builds-") as folder:
        files = [pathlib.Path(folder, name) for name in ("old.h5", "new.h5")]
        ran = [call(program, "run", scenario, "--json", "-o", file) for program, file in zip((old, new), files, strict=True)]
        found = list(outcome_differences("run", *ran))
        if all(file.exists() for file in files):
            found += [f"file: {name}" for name in file_differences(*files)]
        found += output_differences(old, new, "check", scenario, "--json")
        if json.loads((SOURCE / scenario).read_text()).get("steps", 0) <= 1_000_000:
            found += output_differences(old, new, "drift", scenario, "--json")
        return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("scenarios", nargs="*")
    parser.add_argument("--without", action="append", default=[], metavar="KEY")
    arguments = parser.parse_args()
    LEFT_OUT.update(arguments.without)
    old, new = (str(pathlib.Path(program).resolve()) for program in (arguments.old, arguments.new))
    scenarios = arguments.scenarios or [str(path.relative_to(SOURCE)) for path in sorted(SOURCE.glob("scenarios/**/*.json"))]
    different = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for scenario, found in zip(scenarios, pool.map(lambda path: differences(old, new, path), scenarios), strict=True):
            different += bool(found)
            for place in found:
                print(f"{scenario}: {place}")
    print(f"{len(scenarios)} scenarios compared: {len(scenarios) - different} equal, {different} different")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
