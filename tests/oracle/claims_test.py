"""The page of the paper's claims says what claims.py measures: verdicts, figures, and what the page begins with."""

import re
import unittest

import claims
from program import SOURCE

NUMBER = r"(?<![\w./])-?\d+(?:,\d{3})*(?:\.\d+)?(?:e-?\d+)?"
TIMING = "7-fast"  # Named with its benchmark.


def cells_of(text):
    """{claim: (verdict, measured)} of the page's tables."""
    rows = re.findall(r"^\| (\d[\w.-]*) \| .*? \| ([a-z ]+) \| (.*) \| [\w ]*\|$", text, re.MULTILINE)
    return {name: (verdict, measured) for name, verdict, measured in rows}


def is_rounded(printed, value):
    """Whether the number with all its printed digits is the value."""
    digits, _, exponent = printed.replace(",", "").partition("e")
    unit = 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))
    return abs(float(printed.replace(",", "")) - value) <= 0.5 * unit * (1 + 1e-9)


def differs(cells, measured):
    """Whether a row is not what was measured."""
    (verdict, text), (of_program, *figures) = cells, measured
    printed = re.findall(NUMBER, text)
    return verdict != of_program or len(printed) != len(figures) or not all(map(is_rounded, printed, figures))


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.text = claims.PAGE.read_text(encoding="utf-8")
        cls.rows = cells_of(cls.text)
        cls.measured = {name: measure() for name, measure in claims.CLAIMS.items()}

    def test_every_verdict_and_figure_is_measured(self):
        self.assertEqual(set(self.rows), {*self.measured, TIMING})
        for name, measured in self.measured.items():
            self.assertFalse(differs(self.rows[name], measured), (name, self.rows[name], measured))

    def test_an_altered_figure_or_verdict_is_noticed(self):
        for name, measured in self.measured.items():
            verdict, text = self.rows[name]
            places = list(re.finditer(NUMBER, text))
            self.assertTrue(places, name)
            for place in places:
                at = place.end() if "e" not in place[0] else place.start() + place[0].index("e")
                other = str((int(text[at - 1]) + 1) % 10)
                self.assertTrue(differs((verdict, text[:at - 1] + other + text[at:]), measured), (name, place[0]))
                self.assertTrue(differs((verdict, text[:place.start()] + text[place.end():]), measured), (name, place[0]))
            self.assertTrue(differs(("holds" if verdict != "holds" else "holds when", text), measured), name)

    def test_the_beginning_says_what_the_tables_say(self):
        counts, bullets = re.search(r"\n\n(.*?)\n\n(.*?)\n\n## ", self.text, re.DOTALL).groups()
        verdicts = [verdict for verdict, _ in self.rows.values()]
        of, *numbers = map(int, re.findall(r"\d+", counts))
        self.assertEqual((of, numbers), (len(verdicts), [verdicts.count(each) for each in ("holds", "holds when", "does not hold")]))
        for bullet in bullets.split("\n- ")[1:]:
            named = re.findall(r"\((\d[\w.]*-[\w-]+)\)", bullet)
            known = {number for name in named for number in re.findall(NUMBER, self.rows[name][1])}
            self.assertTrue(named, bullet)
            self.assertLessEqual(set(re.findall(NUMBER, re.sub(r"\([^)]*\)", "", bullet))), known, bullet)

    def test_the_time_is_one_of_the_benchmarks(self):
        line = re.search('"(.*?)"', self.rows[TIMING][1])[1]
        self.assertIn(line, (SOURCE / "tests/benchmarks/README.md").read_text(encoding="utf-8"))
        self.assertIn(line, (SOURCE / "tests/benchmarks/core_figures.cpp").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
