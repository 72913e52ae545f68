#!/usr/bin/python3
"""The mutation tool distinguishes all fates: it reports a survivor, and does not count a broken build as caught.

HYRAX_BUILD is a build of the project.
"""

import os
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

from judge import Judge, Verdict
from mutation import one_in
from mutators import Mutant, mutants_of, numbers_near
from process import run
from program import SOURCE
from reasons import Reason, faults_of
from slips import names_in, slips_of
from subjects import SUBJECTS
from workshop import CannotBuild, Workshop

BUILD = pathlib.Path(os.environ["HYRAX_BUILD"])
TOOL = pathlib.Path(__file__).with_name("mutation.py")
CORE = "sim/physics/physics.h"
LINE = "m_x = rightBound;"


def change_of(line):
    """The core with another line where the right wall stops the sprite."""
    text = (SOURCE / CORE).read_text(encoding="utf-8")
    begin = text.index(LINE)
    return Mutant(CORE, "control", line, begin, begin + len(LINE), line)


class Fates(unittest.TestCase):
    """Each test is one change of the core."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="hyrax-test-")
        cls.addClassCleanup(folder.cleanup)
        core = [subject for subject in SUBJECTS if subject.path == CORE]
        cls.judge = Judge(Workshop(SOURCE, BUILD, folder.name), core, "scenarios")
        cls.judge.prepare()

    def fate(self, line):
        """The verdict on that change."""
        return self.judge.try_out(change_of(line), "control")

    def test_a_change_of_a_bit_is_caught_with_its_scenario_step_and_class(self):
        verdict = self.fate("m_x = std::nextafter(rightBound, 0.0);")
        self.assertEqual((verdict.fate, verdict.difference), ("caught", "contacts"))
        self.assertTrue((SOURCE / "scenarios" / f"{verdict.caught_by}.json").exists(), verdict)
        self.assertGreater(int(verdict.step), 0)

    def test_a_change_without_effect_survives(self):
        self.assertEqual(self.fate("m_x = rightBound * 1.0;").fate, "survived")

    def test_what_does_not_compile_is_not_caught(self):
        self.assertEqual(self.fate("m_x = rightBound").fate, "refused")

    def test_what_never_ends_hangs(self):
        verdict = self.fate("for (volatile bool again = true; again;) {}")
        self.assertEqual(verdict, Verdict("caught", difference="hangs"))

    def test_a_unit_test_passes_without_a_change_and_fails_with_one(self):
        caught = next(mutant for mutant in self.judge.subject_of[CORE].mutants(SOURCE)
                      if mutant.name.endswith("-> physics() : physics(-0.0, 0.0) {}"))
        self.judge.prepare_unit_tests([caught])
        self.assertFalse(self.judge.fails_unit_test(change_of("m_x = rightBound * 1.0;"), "control"))
        self.assertTrue(self.judge.fails_unit_test(caught, "control"))

    def test_a_unit_test_that_fails_without_a_change_is_refused(self):
        judge = Judge(mock.MagicMock(), SUBJECTS, "scenarios")
        with mock.patch.object(judge, "_limited", return_value=None), self.assertRaises(CannotBuild):
            judge.prepare_unit_tests([change_of(LINE)])

    def test_what_dies_crashes(self):
        self.assertEqual(self.fate("__builtin_trap();"), Verdict("caught", difference="crashes"))


class Tool(unittest.TestCase):
    """The tool as ctest calls it."""

    def run_tool(self, *options):
        """Exit code and standard output."""
        outcome = run(sys.executable, TOOL, "--build", BUILD, "--source", SOURCE, *options)
        return outcome.exit_code, outcome.out

    def test_a_survivor_fails_the_run(self):
        exit_code, said = self.run_tool("--scenarios", "tests/must_fail/mutation/scenarios", "--only",
                                        "physics.h: update: without m_vx .= AIR_DRAG")
        self.assertEqual(exit_code, 1)
        self.assertIn("0 of 1 that change a result are caught", said)
        self.assertIn("FAULT: sim/physics/physics.h: update: without m_vx *= AIR_DRAG;: survived; add a scenario", said)

    def test_without_scenarios_nothing_is_reported_as_caught(self):
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            exit_code, said = self.run_tool("--scenarios", folder, "--only", "physics.h: update: without m_vx .= AIR_DRAG")
        self.assertEqual((exit_code, said), (3, ""))

    def test_one_in_some_has_each_kind_of_change_in_each_file(self):
        mutants = [mutant for subject in SUBJECTS for mutant in subject.mutants(SOURCE)]
        chosen = one_in(5, mutants)
        self.assertEqual({(mutant.path, mutant.kind) for mutant in chosen},
                         {(mutant.path, mutant.kind) for mutant in mutants})
        self.assertLess(len(mutants) / 5, len(chosen))
        self.assertLess(len(chosen), len(mutants) / 4)
        self.assertEqual(one_in(1, mutants), mutants)

    def test_every_mutant_has_a_unique_name(self):
        exit_code, said = self.run_tool("--list")
        self.assertEqual(exit_code, 0)
        self.assertGreater(len(said.splitlines()), 600)
        self.assertEqual(len(set(said.splitlines())), len(said.splitlines()))


class Reasons(unittest.TestCase):
    """A reason must name an existing mutant that survives."""

    def setUp(self):
        self.mutant = change_of("m_x = 0.0;")
        self.reasons = {(CORE, "m_x = 0.0;"): Reason("for the test", False)}

    def test_of_a_survivor_it_holds(self):
        self.assertEqual(faults_of(self.reasons, [self.mutant], {self.mutant: Verdict("survived")}), [])

    def test_of_one_that_is_caught_or_does_not_compile_it_is_a_fault(self):
        for fate in ("caught", "refused"):
            (fault,) = faults_of(self.reasons, [self.mutant], {self.mutant: Verdict(fate)})
            self.assertIn(f"is said to be equivalent, and is {fate}", fault)

    def test_of_one_that_is_undefined_a_crash_is_none(self):
        reasons = {(CORE, "m_x = 0.0;"): Reason("for the test", False, may_crash=True)}
        self.assertEqual(faults_of(reasons, [self.mutant], {self.mutant: Verdict("caught", difference="crashes")}), [])
        self.assertEqual(len(faults_of(reasons, [self.mutant], {self.mutant: Verdict("caught", difference="rounding")})), 1)

    def test_of_one_that_is_gone_it_is_a_fault(self):
        (fault,) = faults_of(self.reasons, [change_of("m_x = 1.0;")], {})
        self.assertIn("there is no such mutant", fault)


class Mutators(unittest.TestCase):
    """The mutants of a few lines."""

    def names(self, text, kind):
        """The mutants of a kind."""
        return [mutant.name for mutant in mutants_of("a.h", text) if mutant.kind == kind]

    def test_constants(self):
        self.assertEqual(numbers_near("1200.0"),
                         ["1200.0000000000002", "1199.9999999999998", "1212.0", "1188.0", "-1200.0"])
        self.assertEqual(numbers_near("0.0"), ["5e-324", "-5e-324", "-0.0"])
        self.assertEqual(numbers_near("1'000.0")[2:], ["1010.0", "990.0", "-1000.0"])
        self.assertEqual(numbers_near("12"), ["13", "11"])
        self.assertEqual(numbers_near("0x9Eu"), ["0x9Fu", "0x1Eu"])

    def test_comparisons_by_strictness_and_direction(self):
        self.assertEqual(self.names("int f() {\n  if (a < b) c();\n}\n", "comparison"),
                         ["f: if (a < b) c(); -> if (a <= b) c();", "f: if (a < b) c(); -> if (a > b) c();"])

    def test_statements(self):
        text = "void f() {\n  a();\n  if (b) {\n    c();\n    d();\n  }\n}\n"
        self.assertEqual(self.names(text, "dropped"),
                         ["f: without c();", "f: without d();", "f: without a();", "f: without if (b) {...}"])
        self.assertEqual(self.names(text, "swapped"), ["f: d(); before c();", "f: if (b) {...} before a();"])

    def test_statements_of_try_and_throw(self):
        text = "void f() {\n  try {\n    a();\n  } catch (const Error& why) {\n    throw Failure(why);\n  }\n}\n"
        self.assertEqual(self.names(text, "dropped"),
                         ["f: without a();", "f: without throw Failure(why);", "f: without try {...}"])

    def test_members_of_a_class_with_a_base(self):
        text = "class A : public B {\n public:\n  void f() { a(); }\n};\n"
        self.assertEqual(self.names(text, "dropped"), ["f: without a();"])

    def test_a_constructor_whose_members_take_braces(self):
        text = "A::A(int b) : c_(b), d_(e({0, 0})), f_([this] { g(); }) {\n  h();\n}\n"
        self.assertEqual(self.names(text, "dropped"), ["A: without h();"])

    def test_no_text_within_a_literal(self):
        self.assertEqual(self.names('void f() {\n  a(R"({"b": 1, "c": 2 < 3})");\n}\n', "constant"), [])

    def test_types_but_not_those_of_templates(self):
        text = "double f(std::optional<double> a) {\n  return static_cast<double>(a);\n}\n"
        self.assertEqual(len(self.names(text, "float for double")), 2)

    def test_x_and_y_where_they_are_used(self):
        text = "void f(double x, double y) {\n  m_x = x;\n  m_y = y;\n}\n"
        self.assertEqual(self.names(text, "confused"),
                         ["f: m_x = x; -> m_y = x;", "f: m_x = x; -> m_x = y;", "f: m_y = y; -> m_x = y;",
                          "f: m_y = y; -> m_y = x;"])

    def test_a_duplicate_line_is_numbered(self):
        self.assertEqual(self.names("void f() {\n  a();\n  a();\n}\n", "dropped"),
                         ["f: without a();", "f: without a(); [2]"])

    def test_slips_of_a_person(self):
        header = ("enum class Wall { left, right = 4 };  // Sides.\nconstexpr std::size_t kBlock = 8;\n"
                  "struct Size {\n  double wide = 0.0;\n  double high = 0.0;\n  int other = 0;\n};\n")
        text = "void f(int a, int b) {\n  g(a, h(size.wide, b), kBlock);\n  if (is(Wall::right)) k(a);\n}\n"
        found = [(slip.kind, slip.replacement) for slip in slips_of("a.h", text, names_in([header]))]
        self.assertEqual(found, [("swapped arguments", "h(size.wide, b), a"),
                                 ("swapped arguments", "kBlock, h(size.wide, b)"),
                                 ("swapped arguments", "b, size.wide"), ("wrong member", "high"),
                                 ("named size", "(kBlock - 1)"), ("named size", "(kBlock + 1)"),
                                 ("neighbouring enumerator", "left")])


if __name__ == "__main__":
    unittest.main()
