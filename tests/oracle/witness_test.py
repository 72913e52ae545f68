#!/usr/bin/python3
"""Compares the C++ replay with the second program: every row and contact of short runs, bit for bit, and the vectors.

HYRAX_PRINT_ROWS names the program of print_rows.cpp.
"""

import io
import json
import os
import pathlib
import struct
import unittest

from process import succeed
from program import SOURCE
import replay
import vectors

PRINT_ROWS = os.environ["HYRAX_PRINT_ROWS"]
FOLDERS = (SOURCE / "scenarios", SOURCE / "tests/oracle/scenarios")

STEPS_MAX = 3000
ROW_KEYS = ("t", "dt", "x", "y", "vx", "vy")
CONTACT_KEYS = ("t", "x", "y", "vx_before", "vy_before", "vx_after", "vy_after", "overshoot")


def bits(text):
    """The 16 digits of a double's bits, from exact text."""
    return struct.pack(">d", float.fromhex(text)).hex()


def lines_of(path, scenario):
    """The expected output of PRINT_ROWS for a scenario."""
    run = replay.all_rows(scenario)
    yield f"scenario {path}"
    for row in run["rows"]:
        yield " ".join(["row", str(row["step"]), *(bits(row[key]) for key in ROW_KEYS), str(row["contact"])])
    for contact in run["contacts"]:
        numbers = (str(contact[key]) for key in ("step", "last_step", "wall"))
        yield " ".join(["contact", *numbers, *(bits(contact[key]) for key in CONTACT_KEYS)])
    yield f"state_hash {replay.summarise(scenario)['state_hash']}"


def first_difference(expected, actual):
    """A message about the first line that differs, or None."""
    for number, (a, b) in enumerate(zip(expected, actual, strict=True)):
        if a != b:
            scenario = [line for line in expected[:number + 1] if line.startswith("scenario")][-1]
            return f"{scenario}\nexpected {a}\nactual   {b}"
    return None if len(expected) == len(actual) else f"{len(expected)} lines expected, {len(actual)} printed"


class Witness(unittest.TestCase):
    """The second program's opinion of the first."""

    def test_every_row_and_contact_agrees(self):
        runs = {str(path): replay.Scenario(replay.load(path))
                for folder in FOLDERS for path in sorted(folder.rglob("*.json"))}
        short = {path: scenario for path, scenario in runs.items() if scenario.steps <= STEPS_MAX}
        self.assertGreaterEqual(len(short), 30)
        expected = [line for path, scenario in short.items() for line in lines_of(path, scenario)]
        self.assertIsNone(first_difference(expected, succeed(PRINT_ROWS, *short).out.splitlines()))

    def test_a_difference_of_one_bit_is_detected(self):
        path = sorted(FOLDERS[0].rglob("first-fling.json"))[0]
        expected = list(lines_of(str(path), replay.Scenario(replay.load(path))))
        actual = list(expected)
        actual[7] = actual[7][:-3] + ("0" if actual[7][-3] != "0" else "1") + actual[7][-2:]
        self.assertIn("row 6", first_difference(expected, actual))

    def test_the_vectors_are_what_the_second_program_makes(self):
        made = io.StringIO()
        print(json.dumps(vectors.all_vectors(), indent=1), file=made)
        stored = pathlib.Path(__file__).with_name("vectors.json").read_text(encoding="utf-8")
        self.assertTrue(made.getvalue() == stored, "vectors.json is not what `second_program.py vectors` prints")


if __name__ == "__main__":
    unittest.main()
