#!/usr/bin/env python3
"""The pages' numbers against the cases of those of the program (tests/unit/sim/result/number_text_test.cpp)."""

import json
import subprocess

from process import skip_unless_installed
from program import SOURCE, ProgramTest, main

CASES = SOURCE / "tests/unit/sim/result/numbers.txt"
SCRIPT = """import(process.argv[1]).then(({ rounded }) => console.log(JSON.stringify(
  JSON.parse(process.argv[2]).map(([value, digits]) => rounded(Number(value), Number(digits))))))"""


class Numbers(ProgramTest):
    """Rounded numbers."""

    def test_a_page_writes_them_as_the_program_does(self):
        skip_unless_installed("node")
        cases = [line.split() for line in CASES.read_text(encoding="utf-8").splitlines()]
        copy = self.folder / "numbers.mjs"  # By its name a module.
        copy.write_bytes((SOURCE / "tools/report/page/numbers.js").read_bytes())
        told = subprocess.run(["node", "-e", SCRIPT, copy, json.dumps([case[:2] for case in cases])],
                              check=True, capture_output=True, text=True).stdout
        self.assertEqual(json.loads(told), [text.replace("-", "−") for *_, text in cases])


if __name__ == "__main__":
    main()
