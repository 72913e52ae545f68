"""The JUnit document of `check`, and the commands that it suggests."""

import json
import os
import re
import time
import xml.etree.ElementTree

from check_program import CheckTest
from process import run
from program import AGREED, ANOTHER_START, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, PROGRAM, fling


class Document(CheckTest):
    def test_junit_is_well_formed_for_any_path(self):
        names = (b"bad \xff\xfe utf8", b"cut \xe2\x82", b"too long \xc0\xaf", b"surrogate \xed\xa0\x80", b"escape \x1b[31m",
                 b"line\nbreak\ttab\rcr", b"\x01\x08\x7f", "nonchar \uffff\ufffe".encode(), "é €𝄞".encode(),
                 b"beyond \xf4\x90\x80\x80", b"]]>&<\"'")
        for name in names:
            (self.folder.joinpath(os.fsdecode(b"scenarios/" + name + b".json"))).write_text("{")
        begin_s = time.monotonic()
        self.check(BAD_INPUT, "--junit", "report.xml", "--jobs", "1")
        elapsed_s = time.monotonic() - begin_s
        suite = xml.etree.ElementTree.parse(self.folder / "report.xml").getroot()
        self.assertTrue(elapsed_s / 1000 < float(suite.get("time")) < elapsed_s, suite.attrib)
        cases = [case.get("name") for case in suite.iter("testcase")]
        self.assertEqual(len(set(cases)), len(names) + 3)
        for name in ("bad \\xff\\xfe utf8", "escape \\u001b[31m", "line\nbreak\ttab\\u000dcr", "\\u0001\\u0008\\u007f", "é €𝄞", "]]>&<\"'"):
            self.assertIn(f"scenarios/{name}.json", cases)

    def test_junit_is_not_written_to_a_device(self):
        self.expect(CANNOT_ACCESS, "check", "--junit", "/dev/stdout", says="/dev/stdout: cannot be written: is a device or a pipe")


class Suggested(CheckTest):
    """The commands that are suggested work when they are pasted into a shell."""

    def paste(self, command):
        return run("bash", "-c", command.replace("hyrax-sim ", f'"{PROGRAM}" '), cwd=self.folder).exit_code

    def suggestions(self, out):
        return re.findall(r"(?:^|: |  )(hyrax-sim .*)$", out, re.MULTILINE)

    def assert_mended(self, exit_code, *check):
        """`check` suggests a command that makes it agree."""
        suggested = self.suggestions(self.expect(exit_code, *check).out)
        self.assertGreater(len(suggested), 0)
        for command in suggested:
            self.assertIn(self.paste(command), (AGREED, DISAGREED), command)
        self.expect(AGREED, *check)

    def test_for_a_missing_golden_file(self):
        for name in ("it's $HOME `x` \"y\" * !! é", "-dash", "\x1b[31m\nr'e\\d\x7f\u009b1m\udc9b\udcff"):
            path = f"my folder/scenarios/{name}.json"
            self.write(path, fling(name="fling"))
            self.assert_mended(GOLDEN_MISSING, "check", path)

    def test_for_expectations_that_do_not_hold_any_more(self):
        expect = {"finite": True, "contacts": {"right": 1, "ground": [8, 8]}, "final_x_px": [990, 1000]}
        for name in ("one", "two"):
            self.write(f"scenarios/b/{name}.json", fling(name=name, expect=expect if name == "one" else None))
        self.expect(AGREED, "bless", "scenarios/b", "--reason", "x", "--update-expect")
        path = self.folder / "scenarios/b/one.json"
        path.write_text(path.read_text().replace('"x_px": 1100', '"x_px": 1000'))
        out = self.expect(DISAGREED, "check").out
        self.assertIn("hyrax-sim bless scenarios/b/one.json --reason \"...\" --update-expect", out)
        self.assert_mended(DISAGREED, "check")
        path.write_text(path.read_text().replace('"x_px": 1000', '"x_px": 1100').replace("true", "false"))
        (self.folder / "scenarios/third.json").write_text(json.dumps(fling(name="third", start=ANOTHER_START)))
        self.assertIn("\n  to accept it    hyrax-sim bless scenarios/third.json --reason \"...\"\n", self.expect(DISAGREED, "check").out)

    def test_with_golden(self):
        self.write("-x.json", fling(name="x"))
        self.assert_mended(GOLDEN_MISSING, "check", "--golden=golden", "./-x.json")
        self.assert_mended(GOLDEN_MISSING, "check", "scenarios/third.json", "--golden=-else where")
        self.write("scenarios/third.json", fling(steps=200))
        self.assertIn("hyrax-sim check --verbose scenarios/third.json --golden './-else where'\n",
                      self.expect(DISAGREED, "check", "scenarios/third.json", "--golden=-else where").out)
        self.assert_mended(DISAGREED, "check", "scenarios/third.json", "--golden=-else where")

    def test_outside_of_scenarios(self):
        self.write("my/x.json", fling())
        suggested, = self.suggestions(self.expect(GOLDEN_MISSING, "check", "my/x.json").out)
        self.assertEqual(self.paste(suggested), AGREED)
        self.expect(AGREED, "check", "my/x.json", "--golden", "golden")

    def test_by_run(self):
        path, golden = "scenarios/it's a.json", ("--golden", "g h")
        self.write(path, fling(name="a"))
        suggested, = self.suggestions(self.expect(AGREED, "run", path, *golden, "-o", "a b.h5").out)
        self.assertEqual(self.paste(suggested), AGREED)
        self.write(path, fling(name="a", steps=20))
        for output in ("a b.h5", "a b.csv"):
            suggested, = self.suggestions(self.expect(DISAGREED, "run", path, *golden, "-o", output).out)
            self.assertEqual(self.paste(suggested), DISAGREED)

    def test_for_a_run_of_blocks(self):
        self.write("scenarios/long.json", fling(name="long", steps=9000))
        self.bless("scenarios/long.json")
        self.write("scenarios/long.json", fling(name="long", steps=9001, start=ANOTHER_START))
        self.assert_mended(DISAGREED, "check", "scenarios/long.json")
