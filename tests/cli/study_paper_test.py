"""`study paper`: its measurements, its output, and the comparison with expected verdicts."""

import functools
import json
import re
import sys
import tempfile

from process import succeed
from program import AGREED, DISAGREED, PROGRAM, SOURCE, ProgramTest

ORACLE = SOURCE / "tests/oracle"
EXPECTED = SOURCE / "tests/cli/paper_verdicts.json"


@functools.cache
def measured():
    """{claim: what the program measures}, run once."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        claims = succeed(PROGRAM, "study", "paper", "--no-figures", "-o", folder, "--json").json["claims"]
    return {claim["claim"]: claim for claim in claims}


class Paper(ProgramTest):
    def study(self, exit_code, *arguments, **options):
        """Runs the study without figures; its output goes into out/."""
        return self.expect(exit_code, "study", "paper", "--no-figures", "-o", "out", *arguments, **options)

    def test_numbers_are_those_of_60_digits(self):
        """By tests/oracle/claims.py, which still gives what is checked in."""
        known = json.loads((ORACLE / "claims.json").read_text(encoding="utf-8"))
        again = json.loads(succeed(sys.executable, "-B", ORACLE / "claims.py").out)
        claims = measured()
        low, high = known.pop("explicit")
        self.assertEqual(claims["2.3-oscillators"]["remark"],
                         f"by explicit Euler {low:.3g} .. {high:.3g}; the core's at 2.01 rad a step {known.pop('past 2'):.3g}")
        for name, numbers in known.items():
            for key, number in numbers.items():
                self.assertAlmostEqual(again[name][key], number, delta=1e-13 * number)
                self.assertAlmostEqual(claims[name][key], number, delta=1e-9 * number, msg=f"{name} {key}")

    def test_numbers_that_are_known_from_elsewhere(self):
        for claim, number, off in (("2.2-terminal", 0.999 * 1200 / 60 / 0.001, 1e-6), ("2.2-stokes", 8, 1e-9),
                                   ("3.2.2-infinite-bounce", 0.999 * 1200 * 0.6 / 5, 0.01), ("5-energy-retention", 0.36, 1e-12)):
            self.assertAlmostEqual(measured()[claim]["number"], number, delta=off * max(1, number), msg=claim)

    def test_the_file_in_the_document_has_verdicts_of_the_program(self):
        shown = json.loads(re.search(r"```json\n(.*?)```", (SOURCE / "sim/study/README.md").read_text(encoding="utf-8"), re.DOTALL)[1])
        expected = json.loads(EXPECTED.read_text(encoding="utf-8"))
        self.assertEqual((shown.keys(), shown["format"]), (expected.keys(), expected["format"]))
        self.assertLessEqual(shown["verdicts"].items(), expected["verdicts"].items())

    def test_another_verdict_breaks_the_gate_and_is_named(self):
        document = json.loads(EXPECTED.read_text(encoding="utf-8"))
        path = self.write("expected.json", {**document, "verdicts": {**document["verdicts"], "2.3-energy": "holds"}})
        self.assertRegex(self.study(AGREED, "--expect", path, "-q").out,
                         r"\Adoes not hold: 2\.3-energy: does not hold, but expected\.json expects: holds \(.*\)\n\Z")
        self.study(DISAGREED, "--expect", path, "--gate", says="2.3-energy: does not hold, but expected.json expects: holds")
