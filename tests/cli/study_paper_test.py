#!/usr/bin/python3
"""`study paper`: its measurements, its output, and the comparison with expected verdicts."""

import csv
import functools
import json
import sys
import tempfile

import h5py

from process import succeed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, PROGRAM, SOURCE, ProgramTest, main

ORACLE = SOURCE / "tests/oracle"
EXPECTED = SOURCE / "tests/cli/paper_verdicts.json"
VERDICTS = {"holds", "holds when", "does not hold", "not measured"}
SECTIONS = {"1", "2.1", "2.2", "2.3", "2.4", "3", "3.1", "3.2.1", "3.2.2", "4.1", "4.2", "4.3", "5", "6", "6.1", "6.2", "7"}


@functools.cache
def measured():
    """{claim: what the program measures}, run once."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        claims = succeed(PROGRAM, "study", "paper", "--no-figures", "-o", folder, "--json").json["claims"]
    return {claim["claim"]: claim for claim in claims}


class Paper(ProgramTest):
    """The study and its files."""

    def study(self, exit_code, *arguments, **options):
        """Runs the study without figures; its output goes into out/."""
        return self.expect(exit_code, "study", "paper", "--no-figures", "-o", "out", *arguments, **options)

    def expected(self, change=None):
        """A file of expected verdicts: the project's own, changed by `change`."""
        document = json.loads(EXPECTED.read_text(encoding="utf-8"))
        if change is not None:
            change(document)
        return self.write("expected.json", document)

    def test_every_section_with_a_claim_is_measured(self):
        claims = measured().values()
        self.assertEqual({claim["section"] for claim in claims}, SECTIONS)
        self.assertGreaterEqual(len(claims), 40)
        for claim in claims:
            self.assertIn(claim["verdict"], VERDICTS)
            self.assertGreater(len(claim["measured"]), 10)
            self.assertGreater(len(claim["sentence"]), 10)
            self.assertTrue(claim["expected"], claim)
            if claim["verdict"] == "holds when":
                self.assertTrue(claim["remark"].startswith("when "), claim)

    def test_what_is_measured_from_many_starts_has_a_range(self):
        claims = measured()
        for name in ("2.3-energy", "2.3-oscillators", "2.4-explicit", "2.4-first-order", "4.1-energy-drift", "4.1-missed", "6.1-frame-rate"):
            claim = claims[name]
            self.assertLessEqual(claim["number_low"], claim["number"], name)
            self.assertLess(claim["number_low"], claim["number_high"], name)
            self.assertLessEqual(claim["number"], claim["number_high"], name)
        self.assertIsNone(claims["1-axes"]["number_low"])

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
                                   ("2.4-first-order", 1, 0.1), ("4.1-energy-drift", 12, 0.01), ("3.2.2-infinite-bounce", 0.999 * 1200 * 0.6 / 5, 0.01),
                                   ("5-energy-retention", 0.36, 1e-12)):
            self.assertAlmostEqual(measured()[claim]["number"], number, delta=off * max(1, number), msg=claim)

    def test_the_projects_core_is_as_expected(self):
        self.study(AGREED, "--expect", EXPECTED, "--gate")

    def test_another_verdict_breaks_the_gate_and_is_named(self):
        def change(document):
            document["verdicts"]["2.3-energy"] = "holds"
        path = self.expected(change)
        self.study(AGREED, "--expect", path)
        self.study(DISAGREED, "--expect", path, "--gate", says="2.3-energy: does not hold, but expected.json expects: holds")

    def test_a_gate_without_expected_verdicts_is_refused(self):
        self.study(BAD_INPUT, "--gate", says="--gate needs --expect FILE")

    def test_a_claim_without_expected_verdict_breaks_the_gate(self):
        path = self.expected(lambda document: document["verdicts"].pop("7-fast"))
        self.study(DISAGREED, "--expect", path, "--gate", says="7-fast: holds, but expected.json has no verdict for it")

    def test_tables(self):
        self.study(AGREED)
        with open(self.folder / "out/paper.csv", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        with h5py.File(self.folder / "out/paper.h5") as file:
            self.assertEqual(len(rows) - 1, len(file["claims/claim"]))
            self.assertEqual(set(file["claims/verdict"].asstr()[:]) - VERDICTS, set())

    def test_all_faults_of_a_file_are_reported_at_once(self):
        def change_form(document):
            document["format"] = "hyrax-verdicts/2"
            document["verdicts"]["7-fast"] = 1
            document["more"] = 1
        self.study(BAD_INPUT, "--expect", self.expected(change_form), says=(
            'expected.json: /format: must be "hyrax-verdicts/1" (found "hyrax-verdicts/2")',
            "expected.json: /verdicts/7-fast: must be a text (found 1)",
            "expected.json: /more: unknown key (found more); allowed: format, verdicts"))
        def change_names(document):
            document["verdicts"]["9-moon"] = document["verdicts"]["9-sun"] = "holds"
            document["verdicts"]["7-fast"] = "maybe"
        self.study(BAD_INPUT, "--expect", self.expected(change_names), says=(
            "expected.json: /verdicts: unknown claim (found 9-moon, 9-sun)",
            "expected.json: /verdicts/7-fast: unknown verdict (found maybe); allowed: holds, holds when, does not hold, not measured"))
        twice = EXPECTED.read_text(encoding="utf-8").replace('"7-fast": "holds"', '"7-fast": "holds", "7-fast": "holds"')
        self.study(BAD_INPUT, "--expect", self.write("twice.json", twice), says="/verdicts/7-fast: duplicate key")
        self.study(BAD_INPUT, "--expect", self.write("list.json", "[]"), says="list.json: /: must be an object")
        self.study(BAD_INPUT, "--expect", self.write("empty.json", "{}"), says=("/format: is missing", "/verdicts: is missing"))
        self.study(CANNOT_ACCESS, "--expect", "none.json", says="none.json: cannot be read")
        self.assertFalse((self.folder / "out").exists())

    def test_scenarios_are_refused(self):
        self.study(BAD_INPUT, SOURCE / "scenarios/hard/rest.json", says="takes no scenarios")

    def test_the_figure_has_a_line_for_each_claim(self):
        self.expect(AGREED, "study", "paper", "-o", "out")
        picture = (self.folder / "out/paper.svg").read_text(encoding="utf-8")
        for text in ("does not hold", "holds when", "Stokes law", "4.3", "the position stands still"):
            self.assertIn(text, picture)
        self.assertNotIn("an expected verdict", picture)

    def test_the_figure_has_a_column_of_expected_verdicts(self):
        self.expect(AGREED, "study", "paper", "-o", "out", "--expect", EXPECTED)
        picture = (self.folder / "out/paper.svg").read_text(encoding="utf-8")
        self.assertIn("an expected verdict that differs is coloured", picture)


if __name__ == "__main__":
    main()
