#!/usr/bin/python3
"""The second program and hyrax-sim agree on every scenario of moderate length, bit for bit."""

import json
import pathlib
import struct
import sys

from process import succeed
from program import AGREED, SOURCE, ProgramTest, main

SECOND_PROGRAM = SOURCE / "tests/oracle/second_program.py"
sys.path.append(str(SECOND_PROGRAM.parent))
import replay  # noqa: E402  (its reader gives the length)

STEPS_MAX = 20_000
KEYS = ("steps", "simulated_s", "contacts", "clamped_steps", "final", "at_rest_since_s", "state_hash")


def exact(value):
    """The value with every number as the digits of its bits, so that -0.0 and 0.0 differ."""
    if isinstance(value, dict):
        return {key: exact(inner) for key, inner in value.items()}
    return struct.pack(">d", value).hex() if isinstance(value, float) else value


class SecondProgram(ProgramTest):
    """Two programs, one specification."""

    def test_they_agree_on_every_scenario_of_moderate_length(self):
        paths = sorted(map(str, pathlib.Path(SOURCE, "scenarios").rglob("*.json")))
        paths = [path for path in paths if replay.Scenario(replay.load(path)).steps <= STEPS_MAX]
        self.assertGreaterEqual(len(paths), 30)
        printed = succeed(sys.executable, SECOND_PROGRAM, "replay", *paths).out
        played = self.expect(AGREED, "run", *paths, "--json", "-o", "out/").out
        expected, actual = (json.loads(text, parse_int=float)["runs"] for text in (printed, played))
        for second, first in zip(expected, actual, strict=True):
            self.assertEqual(second["scenario"], first["scenario"])
            for key in KEYS:
                self.assertEqual(exact(second[key]), exact(first[key]), f"{first['scenario']}: {key}")


if __name__ == "__main__":
    main()
