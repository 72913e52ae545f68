#!/usr/bin/python3
"""Which mutants a few lines have, and which reasons hold."""

import unittest

from build_copy import Verdict
from mutators import Mutant, mutants_of, numbers_near
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


class Mutators(unittest.TestCase):
    """The mutants of a few lines."""

    def names(self, text, kind):
        return [mutant.name for mutant in mutants_of("a.h", text) if mutant.kind == kind]

    def test_constants(self):
        self.assertEqual(numbers_near("1200.0"),
                         ["1200.0000000000002", "1199.9999999999998", "1212.0", "1188.0", "-1200.0"])
        self.assertEqual(numbers_near("0.0"), ["5e-324", "-5e-324", "-0.0"])
        self.assertEqual(numbers_near("1'000.0")[2:], ["1010.0", "990.0", "-1000.0"])
        self.assertEqual(numbers_near("12"), ["13", "11"])
        self.assertEqual(numbers_near("0x9Eu"), ["0x9Fu", "0x1Eu"])

    def test_of_a_few_lines(self):
        statements = "void f() {\n  a();\n  if (b) {\n    c();\n    d();\n  }\n}\n"
        for kind, text, expected in (
                ("comparison", "int f() {\n  if (a < b) c();\n}\n",
                 ["f: if (a < b) c(); -> if (a <= b) c();", "f: if (a < b) c(); -> if (a > b) c();"]),
                ("dropped", statements,
                 ["f: without c();", "f: without d();", "f: without a();", "f: without if (b) {...}"]),
                ("swapped", statements, ["f: d(); before c();", "f: if (b) {...} before a();"]),
                ("dropped", "void f() {\n  try {\n    a();\n  } catch (const Error& why) {\n    throw Failure(why);\n  }\n}\n",
                 ["f: without a();", "f: without throw Failure(why);", "f: without try {...}"]),
                ("dropped", "class A : public B {\n public:\n  void f() { a(); }\n};\n", ["f: without a();"]),
                ("dropped", "A::A(int b) : c_(b), d_(e({0, 0})), f_([this] { g(); }) {\n  h();\n}\n", ["A: without h();"]),
                ("dropped", "void f() {\n  a();\n  a();\n}\n", ["f: without a();", "f: without a(); [2]"]),
                ("constant", 'void f() {\n  a(R"({"b": 1, "c": 2 < 3})");\n}\n', []),
                ("confused", "void f(double x, double y) {\n  m_x = x;\n  m_y = y;\n}\n",
                 ["f: m_x = x; -> m_y = x;", "f: m_x = x; -> m_x = y;", "f: m_y = y; -> m_x = y;",
                  "f: m_y = y; -> m_y = x;"])):
            with self.subTest(kind=kind, text=text):
                self.assertEqual(self.names(text, kind), expected)
        template = "double f(std::optional<double> a) {\n  return static_cast<double>(a);\n}\n"
        self.assertEqual(len(self.names(template, "float for double")), 2, "not those of templates")

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
