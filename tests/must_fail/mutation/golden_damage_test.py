#!/usr/bin/python3
"""A golden file with one bit flipped anywhere, or a row dropped, doubled, swapped or made a NaN, is detected.

HYRAX_DAMAGE=all flips thousands of bits instead of a sample.
"""

import os
import pathlib
import sys
import tempfile
import unittest

from damage import damaged_rows, flipped, some_flips, spans_of_rows
from damage_test import LONG, SHORT
from golden_pair import GoldenPair
from process import run
from program import DISAGREED, BAD_INPUT, PROGRAM

_IS_ALL = os.environ.get("HYRAX_DAMAGE") == "all"
_H5_FLIPS = 6000 if _IS_ALL else 150
_READER = pathlib.Path(__file__).with_name("golden_contents.py")


def contents(files):
    """The output of golden_contents.py for each golden file; "died" where the file kills it."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        paths = [pathlib.Path(folder, f"{number}.h5") for number in range(len(files))]
        for path, content in zip(paths, files, strict=True):
            path.write_bytes(content)
        said = []
        while len(said) < len(paths):
            printed = run(sys.executable, _READER, *paths[len(said):], timeout=300).out
            said += printed.splitlines()
            if len(said) < len(paths):
                said.append("died")
        return said


class Damage(unittest.TestCase):
    """The same for the two kinds of golden file."""

    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.pairs = {"rows": GoldenPair(SHORT), "blocks": GoldenPair(LONG)}

    def test_complete_pairs_agree_and_half_ones_are_missing(self):
        for pair in self.pairs.values():
            self.assertEqual(pair.verdicts([(pair.h5, pair.txt), (pair.h5, None), (None, pair.txt)]),
                             ["agreed", "missing", "missing"])

    def test_a_flipped_bit_anywhere_in_the_golden_file_is_found_or_noted(self):
        for kind, pair in self.pairs.items():
            flips = some_flips(pair.h5, _H5_FLIPS, seed=1)
            files = [flipped(pair.h5, *flip) for flip in flips]
            verdicts = pair.verdicts([(file, pair.txt) for file in files])
            noted = [number for number, verdict in enumerate(verdicts) if verdict == "noted"]
            complete, *said = contents([pair.h5, *(files[number] for number in noted)])
            of_rows = spans_of_rows(pair.h5)
            self.assertNotIn("agreed", verdicts, kind)
            self.assertEqual([flips[number] for number, read in zip(noted, said, strict=True)
                              if read not in (complete, "died") or
                              any(begin <= flips[number][0] < end for begin, end in of_rows)], [], kind)

    def test_a_row_dropped_doubled_swapped_or_made_a_nan_is_found(self):
        for kind, pair in self.pairs.items():
            names, files = zip(*damaged_rows(pair.h5))
            self.assertGreater(len(names), 40)
            verdicts = pair.verdicts([(file, pair.txt) for file in files])
            unseen = [(name, verdict) for name, verdict in zip(names, verdicts, strict=True)
                      if verdict in ("agreed", "noted")]
            self.assertEqual(unseen, [], kind)

    def test_diff_finds_damaged_rows(self):
        whole = self.pairs["rows"].h5
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            pathlib.Path(folder, "a.h5").write_bytes(whole)
            for name, damaged in damaged_rows(whole):
                if name.startswith(("/trajectory", "/contacts")):
                    pathlib.Path(folder, "b.h5").write_bytes(damaged)
                    self.assertIn(run(PROGRAM, "diff", "a.h5", "b.h5", cwd=folder).exit_code, (DISAGREED, BAD_INPUT), name)


if __name__ == "__main__":
    unittest.main()
