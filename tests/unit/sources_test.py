"""The sources of sim/ and tools/: nothing is defined that none of them uses, and gravity is a number in two places alone."""

import collections
import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["HYRAX_SOURCE_DIR"])
CONSTANT = re.compile(r"\b(k[A-Z]\w*)(?:\[\w*\])? *[={]")
# Of a header, outside of a class.
FUNCTION = re.compile(r"^(?:\[\[nodiscard\]\] )?(?!return|using|class|struct)[\w:<>,&*][\w:<>,&* ]* [&*]?(\w+)\([^;{]*\);", re.MULTILINE)
GRAVITY = re.compile(r"(?<![-\w.'])1200(?:\.0)?(?![\w.])")  # Not a speed upwards.


def code(path):
    """A source without its comments."""
    return re.sub(r"(?m)//.*$", "", path.read_text(encoding="utf-8"))


def unused(sources):
    """Constants, and functions of headers, of {path: code} that are named where they are declared and defined alone."""
    words = collections.Counter(word for text in sources.values() for word in re.findall(r"\w+", text))
    for path, text in sources.items():
        yield from (f"{path}: {name}" for name in CONSTANT.findall(text) if words[name] == 1)
        if path.suffix == ".h":
            yield from (f"{path}: {name}" for name in FUNCTION.findall(text) if words[name] <= 2)


class Sources(unittest.TestCase):
    def setUp(self):
        self.sources = {path.relative_to(SOURCE): code(path) for folder in ("sim", "tools")
                        for path in sorted((SOURCE / folder).rglob("*")) if path.suffix in (".h", ".cpp", ".cmake")}
        self.assertGreater(len(self.sources), 300)

    def test_what_is_defined_is_used(self):
        self.assertEqual(list(unused(self.sources)), [])

    def test_what_is_unused_is_found(self):
        header = "constexpr int kNames[] = {1};\nint shown(int which);\nint hidden(\n    int which);\n"
        self.assertEqual(list(unused({pathlib.PurePath("a.h"): header, pathlib.PurePath("a.cpp"):
                                      "int shown(int) {}\nint hidden(int) {}\nint main() { shown(1); }"})), ["a.h: kNames", "a.h: hidden"])

    def test_gravity_stands_in_the_core_and_in_the_reference(self):
        holders = [str(path) for path, text in self.sources.items()
                   if path.suffix in (".h", ".cpp") and GRAVITY.search(re.sub(r'"[^"\n]*"', "", text))]
        self.assertEqual(holders, ["sim/physics/physics.h", "sim/reference/model.h"])
