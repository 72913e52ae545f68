#!/usr/bin/python3
"""Every scenario that the README prints runs as printed, and its expectations hold."""

import json
import re

from program import AGREED, SOURCE, ProgramTest, main


def json_blocks(text):
    """What stands between ```json and ```."""
    return re.findall(r"^```json[^\n]*\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


class Readme(ProgramTest):
    """The README's JSON blocks."""

    def setUp(self):
        super().setUp()
        self.blocks = json_blocks((SOURCE / "README.md").read_text(encoding="utf-8"))

    def test_every_block_is_json(self):
        for block in self.blocks:
            json.loads(block)

    def test_every_scenario_runs_as_printed(self):
        scenarios = [block for block in self.blocks if "hyrax-scenario/1" in block]
        self.assertTrue(scenarios, "README.md shows no scenario")
        for number, block in enumerate(scenarios):
            self.expect(AGREED, "run", self.write(f"block-{number}.json", block), "-o", "block.h5")


if __name__ == "__main__":
    main()
