"""The matrix of platforms notices what it must: its own controls.

HYRAX_REPLAY names the program to play with.
"""

import os
import pathlib
import re
import shutil
import tempfile
import unittest

import result
from matrix import again_after_signal
from process import Outcome, run, succeed
from result import processor_features
from rows import BUILDS, CONTROLS, HERE, MASKED, PROJECT, THIS_BUILD, Needs, Row

NOT_AS_MUST_BE = 1
SCENARIO = "flings/first-fling"
LOADER = "/lib64/ld-linux-x86-64.so.2"


class Matrix(unittest.TestCase):
    """The driver, with golden files of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-test-"))
        self.addCleanup(shutil.rmtree, self.folder)
        shutil.copytree(PROJECT / "golden", self.folder / "golden", ignore=shutil.ignore_patterns("*.h5"))

    def play(self, program):
        """Plays a program, which is not as it must be; returns its table and its messages on stderr."""
        outcome = run(HERE / "run", "--program", program, "--golden", self.folder / "golden", "--folder", self.folder,
                      exit_code=NOT_AS_MUST_BE)
        return outcome.out, outcome.err

    def test_one_digit_of_one_golden_hash_turns_it_red(self):
        digest = self.folder / "golden" / f"{SCENARIO}.txt"
        text = digest.read_text(encoding="utf-8")
        found = re.search(r"^state hash: ([0-9a-f]{31})([0-9a-f])$", text, re.MULTILINE)
        digest.write_text(text.replace(found.group(0), f"state hash: {found.group(1)}{int(found.group(2), 16) ^ 1:x}"),
                          encoding="utf-8")
        table, errors = self.play(os.environ["HYRAX_REPLAY"])
        self.assertRegex(table, r"this build .* 1 of \d+ DIFFERENT")
        self.assertIn(f"scenarios/{SCENARIO}.json: golden {found.group(1)}", errors)

    def test_a_program_that_plays_and_refuses_nothing_is_red_in_every_line(self):
        table, errors = self.play(shutil.which("true"))
        must = [variant.must.kind for variant in THIS_BUILD] + ["agrees"]
        self.assertEqual(table.count("FAILED: exit code 0, 0 of "), must.count("agrees"))
        self.assertEqual(table.count("NOT REFUSED: exit code 0"), must.count("starts"))
        self.assertEqual(errors.count("BAD: "), len(THIS_BUILD) + 1)


class AgainAfterSignal(unittest.TestCase):
    """A second start in node."""

    def test_it_is_made_after_a_signal_and_only_once(self):
        for codes, expected in (([0], 0), ([1, 0], 1), ([-11, 0], 0), ([-11, -11, 0], -11)):
            outcomes = iter([Outcome(code, b"", b"") for code in codes])
            self.assertEqual(again_after_signal(lambda outcomes=outcomes: next(outcomes)).exit_code, expected, codes)


class Rows(unittest.TestCase):
    """The table of rows."""

    @unittest.skipUnless(os.path.exists(LOADER) and "avx2" in processor_features(), "no processor features to mask")
    def test_the_mask_of_processor_features_is_one_that_glibc_follows(self):
        def levels(**environment):
            listed = succeed(LOADER, "--list-diagnostics", env={**os.environ, **environment}).out
            return re.search(r"^dl_hwcaps_subdirs_active=(.*)$", listed, re.MULTILINE).group(1)

        self.assertNotEqual(levels(), levels(GLIBC_TUNABLES=MASKED))

    def test_what_is_missing_is_skipped_and_in_ci_a_failure_but_an_unsupported_processor_is_none(self):
        self.addCleanup(setattr, result, "IN_CI", result.IN_CI)
        for row, verdict, is_bad_in_ci in (
                (Row("none", needs=(Needs("no-such-compiler", "g++-none"),)), "skipped: needs g++-none", True),
                (Row("none", cpu=("no_such_feature",)), "not run here: the processor lacks no_such_feature", False)):
            for in_ci in (False, True):
                result.IN_CI = in_ci
                hindrance = result.hindrance_of(row, row.name)
                self.assertEqual((hindrance.verdict, hindrance.is_bad), (verdict, is_bad_in_ci and in_ci))

    def test_every_package_is_one_that_the_scripts_install(self):
        setup = (PROJECT / "tools/setup.sh").read_text(encoding="utf-8")
        installed = {package for packages in re.findall(r"^packages_\w+=\(([^)]*)\)", setup, re.MULTILINE)
                     for package in packages.split()}
        needed = {need.package for row in (*BUILDS, *CONTROLS, *THIS_BUILD) for need in row.needs}
        self.assertEqual(needed - installed, set())

    def test_each_row_has_a_name_of_its_own(self):
        names = [row.folder for row in (*BUILDS, *CONTROLS)]
        self.assertEqual(len(names), len(set(names)))
