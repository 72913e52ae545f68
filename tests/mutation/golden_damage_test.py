#!/usr/bin/python3
"""A golden pair with one bit flipped anywhere, or a row dropped, doubled, swapped or made a NaN, is found.

HYRAX_DAMAGE=all flips thousands of bits instead of a sample, and prints what became of them.
"""

import collections
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from damage import damaged_rows, flipped, region_of, regions, some_flips
from damage_test import LONG, SHORT
from golden_pair import GoldenPair
from program import DISAGREED, BAD_INPUT, PROGRAM

_IS_ALL = os.environ.get("HYRAX_DAMAGE") == "all"
_SEALED_FLIPS = 2000 if _IS_ALL else 60
_UNSEALED_FLIPS = 6000 if _IS_ALL else 150
_DIGEST_FLIPS = 10**9 if _IS_ALL else 200
_DIFFS = 400 if _IS_ALL else 40

# Lines of a digest that are words for people: what stands behind these keys is part of no comparison.
_WORDS = (b"scenario: ", b"margin: ", b"reason: ")
# The last 32 digits of a digest are the hash of the golden file's bytes: of another one, `check` only tells.
_FILE_HASH = 32
_READER = pathlib.Path(__file__).with_name("golden_contents.py")


def is_in_words(digest, place):
    """Whether a byte of a digest is one of the free words of a line, or of the file's hash."""
    if len(digest) - 1 - _FILE_HASH <= place < len(digest) - 1:
        return True
    begin = digest.rfind(b"\n", 0, place) + 1
    key = next((key for key in _WORDS if digest.startswith(key, begin)), None)
    return key is not None and place >= begin + len(key) and digest[place:place + 1] != b"\n"


def contents(files):
    """What golden_contents.py says of each golden file; "died" where the file kills it."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        paths = [pathlib.Path(folder, f"{number}.h5") for number in range(len(files))]
        for path, content in zip(paths, files):
            path.write_bytes(content)
        said = []
        while len(said) < len(paths):
            done = subprocess.run([sys.executable, _READER, *paths[len(said):]], capture_output=True, text=True,
                                  check=False, timeout=300)
            said += [tuple(line.split()) for line in done.stdout.splitlines()]
            if len(said) < len(paths):
                said.append(("died", "died"))
        return said


class Damage(unittest.TestCase):
    """The same for the two kinds of golden file."""

    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.pairs = {"rows": GoldenPair(SHORT), "blocks": GoldenPair(LONG)}

    def told(self, what, counts):
        """With HYRAX_DAMAGE=all: how many came to what."""
        if _IS_ALL:
            print(f"{what}: " + ", ".join(f"{name} {count}" for name, count in sorted(counts.items())))

    def test_whole_pairs_agree(self):
        for pair in self.pairs.values():
            self.assertEqual(pair.verdicts([(pair.h5, pair.txt), (pair.h5, None)]), ["agreed", "agreed"])

    def test_a_bit_anywhere_in_the_golden_file_is_found_under_its_digest(self):
        for kind, pair in self.pairs.items():
            flips = some_flips(pair.h5, _SEALED_FLIPS, seed=1)
            verdicts = pair.verdicts([(flipped(pair.h5, *flip), pair.txt) for flip in flips])
            self.told(f"{kind}, {len(flips)} bits of the golden file, digest whole", collections.Counter(verdicts))
            self.assertNotIn("died", verdicts, kind)
            agreed = [flip for flip, verdict in zip(flips, verdicts) if verdict == "agreed"]
            whole, *said = contents([pair.h5, *(flipped(pair.h5, *flip) for flip in agreed)])
            self.assertEqual([flip for flip, read in zip(agreed, said) if read not in (whole, ("died", "died"))], [], kind)

    def test_a_bit_anywhere_in_the_digest_is_found_but_in_words(self):
        for kind, pair in self.pairs.items():
            bits = [(place, bit) for place in range(len(pair.txt)) for bit in range(8)]
            flips = [bits[index] for index, _ in some_flips(bits, _DIGEST_FLIPS, seed=2)]
            verdicts = pair.verdicts([(pair.h5, flipped(pair.txt, *flip)) for flip in flips])
            self.told(f"{kind}, {len(flips)} bits of the digest", collections.Counter(verdicts))
            wrong = [(flip, verdict) for flip, verdict in zip(flips, verdicts)
                     if verdict == "died" or (verdict == "agreed" and not is_in_words(pair.txt, flip[0]))]
            self.assertEqual(wrong, [], kind)

    def test_without_a_digest_what_is_not_found_says_nothing_that_is_compared(self):
        for kind, pair in self.pairs.items():
            flips = some_flips(pair.h5, _UNSEALED_FLIPS, seed=3)
            files = [flipped(pair.h5, *flip) for flip in flips]
            verdicts = pair.verdicts([(file, None) for file in files])
            (compared, everything), = contents([pair.h5])
            agreed = [number for number, verdict in enumerate(verdicts) if verdict == "agreed"]
            said = dict(zip(agreed, contents([files[number] for number in agreed])))
            known = regions(pair.h5)
            counts, wrong = collections.Counter(), []
            for number, (flip, verdict) in enumerate(zip(flips, verdicts)):
                fate = verdict
                if number in said:
                    fate = "carries nothing" if said[number] == (compared, everything) else "words"
                    wrong += [] if said[number][0] in (compared, "died") else [(flip, "agreed")]
                wrong += [(flip, verdict)] if verdict == "died" else []
                counts[f"{region_of(known, flip[0])}: {fate}"] += 1
            self.told(f"{kind}, {len(flips)} bits of the golden file, no digest", counts)
            self.assertEqual(wrong, [], kind)
            self.assertNotIn("trajectory: carries nothing", counts, kind)

    def test_a_row_dropped_doubled_swapped_or_made_a_nan_is_found_with_and_without_a_digest(self):
        for kind, pair in self.pairs.items():
            names, files = zip(*damaged_rows(pair.h5))
            self.assertGreater(len(names), 40)
            for digest in (pair.txt, None):
                verdicts = pair.verdicts([(file, digest) for file in files])
                self.told(f"{kind}, {len(names)} rows, digest {'whole' if digest else 'missing'}",
                          collections.Counter(verdicts))
                unseen = [(name, verdict) for name, verdict in zip(names, verdicts) if verdict in ("agreed", "died")]
                self.assertEqual(unseen, [], kind)

    def diff(self, whole, damaged):
        """The exit code of `diff`."""
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            for name, content in (("a.h5", whole), ("b.h5", damaged)):
                pathlib.Path(folder, name).write_bytes(content)
            return subprocess.run([PROGRAM, "diff", "a.h5", "b.h5"], cwd=folder, capture_output=True, check=False,
                                  timeout=60).returncode

    def test_diff_finds_damaged_rows_and_survives_damaged_bits(self):
        whole = self.pairs["rows"].h5
        for name, damaged in damaged_rows(whole):
            if name.startswith(("/trajectory", "/contacts")):
                self.assertIn(self.diff(whole, damaged), (DISAGREED, BAD_INPUT), name)
        for flip in some_flips(whole, _DIFFS, seed=4):
            self.assertIn(self.diff(whole, flipped(whole, *flip)), (0, DISAGREED, BAD_INPUT), flip)


if __name__ == "__main__":
    unittest.main()
