"""Which mutants a few lines have, and which reasons hold."""

import unittest

from build_copy import Verdict
from mutators import Mutant, mutants_of
from reasons import Reason, faults_of
from slips import names_in, slips_of


class Reasons(unittest.TestCase):
    """A reason must name an existing mutant, and agree with its fate."""

    def test_hold_or_are_a_fault(self):
        mutant = Mutant("a.h", "control", "a -> b")
        equivalent, of_unit, undefined = Reason(""), Reason("", True), Reason("", may_crash=True)
        for reason, verdict, says in (
                (None, ("caught", "check"), None), (None, ("survived",), "survived; add a test that catches it"),
                (equivalent, ("survived",), None), (equivalent, ("not tried",), None),
                (equivalent, ("caught", "unit.a"), "is said to be equivalent, and is caught"),
                (equivalent, ("refused",), "is said to be equivalent, and is refused"),
                (undefined, ("caught", "check", "crashes"), None), (undefined, ("caught", "check", "rounding"), "is caught"),
                (of_unit, ("caught", "unit.a"), None), (of_unit, ("survived",), "survived; add a test that catches it"),
                (of_unit, ("caught", "check"), "is said to be caught by a unit test alone, and is caught")):
            with self.subTest(reason=reason, verdict=verdict):
                reasons = {("a.h", "a -> b"): reason} if reason else {}
                faults = faults_of(reasons, [mutant], {mutant: Verdict(*verdict)})
                self.assertEqual(len(faults), 1 if says else 0, faults)
                self.assertIn(says or "", "".join(faults))
        (fault,) = faults_of({("a.h", "gone"): equivalent}, [mutant], {})
        self.assertIn("there is no such mutant", fault)


class Slips(unittest.TestCase):
    """The mutants of a few lines; document_numbers_test counts those of the core, and finds each that has a reason."""

    def test_statements_that_the_core_has_none_of(self):
        for text, dropped in (
                ("void f() {\n  try {\n    a();\n  } catch (const Error& why) {\n    throw Failure(why);\n  }\n}\n",
                 ["f: without a();", "f: without throw Failure(why);", "f: without try {...}"]),
                ('A::A(int b) : c_(b), d_(e({0, 0})), f_([this] { g(); }) {\n  h(R"({"b": 1 < 2})");\n}\n',
                 ['A: without h(R"({"b": 1 < 2})");'])):
            self.assertEqual([mutant.name for mutant in mutants_of("a.h", text) if mutant.kind in ("dropped", "comparison")], dropped)

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
