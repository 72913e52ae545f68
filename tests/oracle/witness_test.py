#!/usr/bin/python3
"""Compares the C++ replay with the second program: every row and contact of short runs, bit for bit, and the vectors; and the
second program with the formulas of the documents.

HYRAX_PRINT_ROWS names the program of print_rows.cpp.
"""

import io
import json
import math
import os
import pathlib
import re
import struct
import unittest

import xxhash

from process import succeed
from program import SOURCE
import clock
import replay
import sweep
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


def stated(path, *patterns):
    """What each pattern's groups have in a document."""
    text = " ".join((SOURCE / path).read_text(encoding="utf-8").split())
    return [each for pattern in patterns for each in re.search(pattern, text).groups()]


def value(formula, **names):
    """Of a document's formula."""
    return eval(formula.replace("^", "**"), {"floor": math.floor}, names)  # pylint: disable=eval-used


class Documents(unittest.TestCase):
    """Who computes by the documents gets the numbers of the second program."""

    def test_the_generator_and_the_jitter(self):
        state, *mix, unit, uniform, normal, first, last, missed, kept = stated(
            "scenarios/README.md", r"k of seed s is `mix\((.*?)\)` modulo 2\^64, where `mix` shifts by (\d+), (\d+), (\d+) and multiplies by (0x\w+) and (0x\w+);",
            r"; u_k = (.*?)\. The", r"\| `uniform` [^`]*`fraction`[^`]* `(.*?)` \|",
            r"\| `normal` [^`]*`sigma_s`[^`]* `(.*?)`, S the sum of u_(\d+)i \.\. u_12i\+(\d+) from left to right.*?; a result <= 0 becomes 0\.0 ",
            r"\| `missed_frames` [^`]*`probability`[^`]* `(.*?)` if u_i < probability, else (\w+) \|")
        for seed, i in ((7, 0), (clock.MASK_64, 5), (1 << 63, 12345)):
            z = value(state, s=seed, k=i) % 2**64
            for shift, factor in zip(mix[:3], (*mix[3:], "1")):
                z = (z ^ z >> int(shift)) * int(factor, 0) % 2**64
            self.assertEqual((z, value(unit, output=z)), (clock.splitmix64(seed, i), clock.unit(seed, i)))
            total = sum(clock.unit(seed, int(first) * i + k) for k in range(int(last) + 1))
            names = {"dt": 1 / 60, "fraction": 0.35, "sigma_s": 0.35, "u_i": clock.unit(seed, i), "S": total}
            self.assertEqual([value(uniform, **names), max(0.0, value(normal, **names)), value(missed, **names), value(kept, **names)],
                             [rule(1 / 60, parameter, seed, i) for rule, parameter in (
                                 (clock.uniform_dt_s, 0.35), (clock.normal_dt_s, 0.35), (clock.missed_frames_dt_s, 1), (clock.missed_frames_dt_s, 0))])

    def test_the_inputs_of_a_sweep(self):
        draw, real, whole, entry, place, between = stated(
            "sim/ensemble/README.md", r"sorted by their bytes, k = 0 \.\. K-1, member i draws u = `u_\((.*?)\)` of", r"\| `uniform` \| `(.*?)`; of a whole number `(.*?)` \|",
            r"\| `choice` \| entry `(.*?)` \|", r"\| `grid` \| with j = \((.*?)\) mod n: `(.*?)`, and `high` at the end")
        place = place.replace("/", "//").replace("product of the n of all later grids", "later")
        vary = {"/e": {"uniform": [-7, 11]}, "/a": {"choice": [0, 1, 2]}, "/b": {"grid": [-2, 5, 3]}, "/d/steps": {"uniform": [3, 9]}, "/c": {"grid": [0, 7, 4]}}

        def by(formula, i, k, low, high, n=3, later=1):
            j = value(place, i=i, later=later) % n
            u = clock.unit(7, value(draw, i=i, k=k, K=len(vary)))
            return high if formula == between and j == n - 1 else value(formula, low=low, high=high, n=n, j=j, u=u)

        for i in range(24):
            self.assertEqual(sweep.inputs({"vary": vary, "seed": 7}, i), {
                "/a": by(entry, i, 0, 0, 2), "/b": by(between, i, 1, -2, 5, later=4), "/c": by(between, i, 2, 0, 7, n=4),
                "/d/steps": by(whole, i, 3, 3, 9), "/e": by(real, i, 4, -7, 11)})

    def test_the_step(self):
        items = stated("sim/physics/README.md", "does in this order: 1. (Gravity.*?) 2. (Drag.*?) 3. (Position.*?) 4. (Left.*?) 5. (Top.*?) 6. (Ground.*?) \\| constant")
        for start, wall, bound in (((300, 200, 50.5, -70), None, {}), ((0.5, 200, -50.5, 70), 3, {"x": 0.0}), ((499, 200, 90, 7), 3, {"x": 500}),
                                   ((300, 0.25, 50.5, -90), 4, {"y": 0.0}), ((300, 399.5, 50.5, 900), 5, {"y": 400})):
            names = {"dt": 1 / 60, **dict(zip(("x", "y", "vx", "vy"), start))}
            for item in (*items[:3], *([items[wall]] if wall else ())):
                for formula in re.findall("`(.*?)`", item):
                    exec(re.sub(r"(?<=[\dvxy]) (?=[dv])", " * ", formula), {}, names)  # pylint: disable=exec-used
            sprite = replay.Sprite(*start)
            sprite.update(1 / 60, 500, 400)
            self.assertEqual({**names, **bound}, {"dt": 1 / 60, "x": sprite.x, "y": sprite.y, "vx": sprite.vx, "vy": sprite.vy}, wall)

    def test_the_state_hash(self):
        order, fields, block, kind, seed, of_blocks = stated(
            "golden/README.md", r"A row is 41 bytes: (\w+)-endian binary64 ([\w, ]*?), and the contact byte\.",
            r"Each block of ([\d,]+) rows .*? is hashed with XXH(\w+-\d+), seed (\d+), in canonical big-endian", r"`state_hash` is the XXH(\w+-\d+) of these hashes in order, as 32 lower-case")
        state_hash, packed = replay.StateHash(), []
        for i in range(5000):
            row = {"t": i / 60, "dt": 1 / 60, "x": i, "y": -i, "vx": 3.5, "vy": 1e-9 * i}
            names = fields.split(", ")
            packed.append(struct.pack(("<" if order == "little" else ">") + "d" * len(names) + "B", *map(row.get, names), i % 32))
            state_hash.add(row["dt"], row["x"], row["y"], row["vx"], row["vy"], i % 32)
        hashed = {name: getattr(xxhash, f"xxh{name.replace('-', '_')}_digest") for name in (kind, of_blocks)}
        rows = int(block.replace(",", ""))
        digests = [hashed[kind](b"".join(packed[i:i + rows]), seed=int(seed)) for i in range(0, len(packed), rows)]
        self.assertEqual(hashed[of_blocks](b"".join(digests)).hex(), state_hash.hexdigest())


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
