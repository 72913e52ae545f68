#!/usr/bin/python3
"""What `check` answers to the edits of core_edits.py, over the project's own library.

HYRAX_ALL_EDITS is set: all of them over all of it, else a few over two folders.
"""

import concurrent.futures
import copy
import json
import math
import os
import pathlib
import re
import tempfile
import unittest
from xml.etree import ElementTree

from core_edits import ALL, EVERYDAY, at_ground, when
from program import AGREED, DISAGREED, PROGRAM, SOURCE, ProgramTest, fling, main
from process import preloading, succeed
from traced import SHIPPED, SHIPPED_CORE, traced

EDITS = [edit for edit in ALL if "HYRAX_ALL_EDITS" in os.environ or edit.name in EVERYDAY]
CORES = {edit.name: traced(edit.apply(SHIPPED)) for edit in (
    *EDITS, *(edit for edit in ALL if edit.name in ("half_moves", "static_variable")),
    at_ground("narrow", "m_vx > 500.0 && m_vx < 501.0"), when("1200_high", "screenHeight == 1200"),
    when("dt_of_0", "dt == 0.0 && m_vx > 123456.0"), when("dt_of_-0", "dt == 0.0 && m_vx > 123456.0 && std::signbit(dt)"))}
CHANGED = CORES["GRAVITY_1250.0+REST_THRESHOLD_7.0"]


def words_of(text):
    return "".join(text.split())


class Answer:
    """What is answered to an edit, and in what it is wrong: a list of sentences."""

    def __init__(self, edit):
        self.edit = edit
        self.core = CORES[edit.name]
        self.outcome = self.core.run("check", "--json")
        self.faults = []
        if self.outcome.exit_code not in (AGREED, DISAGREED):
            self.faults.append(str(self.outcome))
            return
        self.document = self.outcome.json
        (self.verdict,) = self.document["cores"]
        self.judge()

    def expect(self, holds, fault):
        """Notes a fault."""
        if not holds:
            self.faults.append(fault)

    def judge(self):
        """Compares everything with what the edit expects."""
        is_changed = self.edit.status == "changed"
        status, groups = self.verdict["status"], self.document["groups"]
        self.expect(status == self.edit.status, f"status {status} ({self.verdict['why']})")
        self.expect(self.outcome.exit_code == (DISAGREED if is_changed else AGREED), f"exit code {self.outcome.exit_code}")
        operations = {group["operation"] for group in groups}
        self.expect(operations <= ({"core", "non_finite"} if is_changed else set()), f"groups {operations}")
        self.expect(sum(len(group["scenarios"]) for group in groups) == self.document["disagreed"], "not all are in a group")
        details = [change["detail"] for change in self.verdict["changes"]]
        named = words_of("\n".join([*details, self.verdict["why"] or ""]))
        for name in self.edit.names:
            self.expect(words_of(name) in named, f"{name} is not named: {details}")
        if is_changed:
            self.judge_changed(groups)
        elif status == "not_proved":
            self.expect(self.verdict["why"], "no reason is given")

    def judge_changed(self, groups):
        """The detail of a group names the edit; what no scenario notices is shown by one."""
        shown = [entry["scenario"] for entry in self.verdict["unnoticed"] if entry["scenario"]]
        self.expect(groups or shown, "nothing shows the change")
        for entry in shown:
            self.expect(self.hash_of(entry) != self.hash_of(entry, is_accepted=True), f"shows nothing: {entry}")
        constants = [change for change in self.verdict["changes"] if change["kind"] == "constant"]
        is_of_constants = len(constants) == len(self.verdict["changes"])
        for group in groups:
            for change in constants if group["operation"] == "core" else ():
                self.expect(change["detail"] in group["detail"], f"{change['detail']} is not in {group['detail']}")
        for change in constants if is_of_constants and groups else ():
            self.expect(change["scenarios"] is not None, f"{change['detail']}: alone is not counted")
        if is_of_constants and len(constants) == 1 and groups:
            self.expect(constants[0]["scenarios"] == sum(len(group["scenarios"]) for group in groups if group["operation"] == "core"),
                        f"alone reproduces {constants[0]['scenarios']}")

    def hash_of(self, scenario, is_accepted=False):
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            path = pathlib.Path(folder, "unnoticed.json")
            path.write_text(json.dumps(scenario), encoding="utf-8")
            arguments = ("run", path, "--json", "-o", folder + "/")
            outcome = succeed(PROGRAM, *arguments, cwd=SOURCE) if is_accepted else self.core.run(*arguments)
            return outcome.json["runs"][0]["state_hash"]


class Unnoticed(ProgramTest):
    """What the text says of a change that no scenario notices."""

    def test_it_has_the_headers_constants_the_consequence_a_scenario_and_commands(self):
        core = CORES["narrow"]
        outcome = core.run("check", "--core")
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        self.assertRegex(outcome.out, r"^core: changed\n  line \d+ +added: if \(m_vx > 500.0 && m_vx < 501.0\) m_vx \*= 0.9;\n")
        differences = re.findall(r"^  no scenario notices `(.*)`(.*)$", outcome.out, re.MULTILINE)
        self.assertEqual({text for text, _ in differences},
                         {f"{speed} {band}" for band in ("> 500", "< 501", "* 0.9") for speed in (
                             "vx * AIR_DRAG * GROUND_FRICTION", "-(vx * AIR_DRAG * RESTITUTION * GROUND_FRICTION)")
                          if band != "* 0.9"} | {"vx * AIR_DRAG * GROUND_FRICTION * 0.9",
                                                 "vx * AIR_DRAG * RESTITUTION * GROUND_FRICTION * 0.9"})
        for _, says in differences:
            self.assertRegex(says, r"^(, which changes results: after 5(\.\d+)? s \S+ px apart in this one| either; unnoticed-\w{8} shows it)$")
        write, accept = (re.search(f"  to {what} +hyrax-sim (.*)", outcome.out)[1] for what in ("write them", "accept it"))
        written = core.run(*write.split()[:-1], self.folder)
        self.assertEqual(written.exit_code, DISAGREED, written)
        names = re.findall(r'"name": "(unnoticed-\w{8})"', outcome.out)
        self.assertEqual(set(names), {name[:-5] for name in self.names()})
        self.assertEqual(written.err, "".join(f"{self.folder}/{name}.json: written\n" for name in names))
        self.assertIn("core: would be accepted in golden/core\n", core.run(*accept.split(), "--dry-run").out)

    def test_every_report_has_a_core_by_which_the_check_fails(self):
        report, summary = self.folder / "report.xml", self.folder / "check.md"
        outcome = CORES["narrow"].run("check", "--annotate", "github", "--junit", report, "--summary", summary)
        self.assertEqual(outcome.exit_code, DISAGREED, outcome)
        core = "".join(re.findall("^(?:core:|  ).*\n", outcome.out, re.MULTILINE)).rstrip("\n")
        annotation, counts = outcome.out.splitlines()[:-3:-1]
        self.assertRegex(counts, r"^(\d+) checked: \1 agreed, 0 ")
        self.assertEqual(annotation, "::error file=golden/core/accepted.txt,title=hyrax-sim check%3A core::" + core.replace("\n", "%0A"))
        suite = ElementTree.parse(report).getroot()
        failure = suite.find("testcase[@name='golden/core/accepted.txt']/failure")
        self.assertEqual((suite.get("failures"), failure.get("message"), failure.text), ("1", "core: changed", core + "\n"))
        self.assertIn("## hyrax-sim check: not agreed\n", summary.read_text())
        self.assertIn("\n### core\n\n    " + core.replace("\n", "\n    ") + "\n", summary.read_text())
        for all_are_checked in ((), ("--last-failed",)):
            quiet = CORES["narrow"].run("check", "-q", *all_are_checked, env={**os.environ, "XDG_CACHE_HOME": str(self.folder)})
            self.assertEqual((quiet.exit_code, quiet.out), (DISAGREED, f"core: changed\n{counts}\n"))

    def test_a_number_of_the_header_is_not_called_by_the_name_of_a_constant(self):
        outcome = CORES["1200_high"].run("check", "--core")
        self.assertIn("\n  no scenario notices `window_height == 1200`", outcome.out)

    def test_a_dt_of_minus_0_is_shown_only_where_0_does_not_show_it(self):
        for dt_s in ("0", "-0"):
            outcome = CORES[f"dt_of_{dt_s}"].run("check", "--core")
            self.assertIn(f'"clock": {{ "dt_s": {dt_s} }}', outcome.out)
            self.assertRegex(outcome.out, r"after 0 s [\d,]+ px/s apart in this one")


class Contacts(unittest.TestCase):
    """By the step's comparisons, or by the rows."""

    def test_half_moves_move_none(self):
        groups = CORES["half_moves"].run("check", "--json", "scenarios/flings").json["groups"]
        self.assertTrue(groups)
        for group in groups:
            self.assertIn(group["class"], ("rounding", "values"))
            self.assertEqual(group["contacts_moved"], 0)

    def test_of_a_step_that_is_not_complete_are_from_the_rows(self):
        self.assertRegex(CORES["static_variable"].run("info").out, r"\ncontacts +from the rows\n")


class Library(ProgramTest):
    """A library of its own, blessed by cores that are given."""

    def add(self, name, **members):
        """A scenario; returns its path."""
        return self.folder / self.write(f"scenarios/{name}.json", fling(name=name, **members))

    def play(self, core, exit_code, *arguments, **options):
        """The outcome of a command with a core."""
        outcome = core.run(*arguments, **options)
        self.assertEqual(outcome.exit_code, exit_code, outcome)
        return outcome

    def groups(self, core):
        """{scenario: (operation, detail)} of what `check` says differs."""
        groups = self.play(core, DISAGREED, "check", "--json", f"{self.folder}/scenarios").json["groups"]
        return {os.path.basename(path)[:-5]: (group["operation"], group["detail"]) for group in groups for path in group["scenarios"]}

    def test_rows_of_a_long_golden_file_are_restored_by_the_accepted_step(self):
        core = CORES["half_moves"]  # Not the paper's step with its constants.
        path = self.add("long", steps=5000)
        self.play(core, AGREED, "bless", path, "--reason", "x")
        rows = []
        for played, exit_code in ((core, AGREED), (SHIPPED_CORE, DISAGREED)):
            self.play(played, exit_code, "run", path, "-o", self.folder / "rows.csv")
            lines = (self.folder / "rows.csv").read_text(encoding="utf-8").splitlines()[1:]
            rows.append([tuple(map(float, line.split(",")[3:7])) for line in lines])
        (result,) = self.play(SHIPPED_CORE, DISAGREED, "check", path, "--json").json["results"]
        step = next(step for step, (old, new) in enumerate(zip(*rows)) if old != new)
        first = result["first_divergence"]
        self.assertEqual((first["step"], first["field"], first["expected"]), (step, "x", rows[0][step][0]))
        self.assertAlmostEqual(result["max_px"] / max(math.dist(old[:2], new[:2]) for old, new in zip(*rows)), 1.0)

    def test_golden_files_that_agree_with_a_newly_accepted_core_are_judged_by_it(self):
        path = self.add("a")
        self.play(SHIPPED_CORE, AGREED, "bless", path, "--reason", "x")
        self.play(CORES["1200_high"], AGREED, "bless", path, "--reason", "x")
        self.assertEqual(self.groups(CHANGED)["a"][0], "core")

    def test_a_step_that_changes_while_its_header_does_not(self):
        path = self.add("a")
        self.play(SHIPPED_CORE, AGREED, "bless", path, "--reason", "x")
        core = copy.copy(CHANGED)
        core.header = SHIPPED_CORE.header
        says = "the core's step changed, its header did not: an included header or a compiler option"
        self.assertEqual(self.groups(core), {"a": ("core", says)})
        self.assertEqual(self.play(core, AGREED, "check", "--core", path).out, f"core: changed\n  {says}\n")

    def test_another_c_library_whose_pow_gives_other_bits(self):
        core, path = CORES["drag_by_time"], self.add("a")
        library = self.folder / "pow.so"
        self.write("pow.c", "double exp(double); double log(double); double pow(double x, double y) { return exp(y * log(x)) * (1 - 1e-15); }")
        succeed("cc", "-shared", "-fPIC", "-fno-builtin", self.folder / "pow.c", "-o", library, "-lm")
        self.play(core, AGREED, "bless", path, "--reason", "x")
        self.play(core, AGREED, "check", path)
        environment = {**os.environ, **preloading(library)}
        (group,) = self.play(core, DISAGREED, "check", "--json", path, env=environment).json["groups"]
        self.assertEqual(group["operation"], "unknown")
        self.assertRegex(group["detail"], "^the accepted core gives other bits, too: .* the C library, ")


class CoreEdits(unittest.TestCase):
    """Each edit, by what is answered."""

    def test_the_shipped_core_is_the_accepted_one(self):
        outcome = SHIPPED_CORE.run("check", "--json", "scenarios/flings")
        self.assertEqual((outcome.exit_code, outcome.json["cores"][0]["status"]), (AGREED, "accepted"))

    def test_each_edit_is_answered(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for answer in pool.map(Answer, EDITS):
                with self.subTest(edit=answer.edit.name):
                    self.assertEqual(answer.faults, [])


if __name__ == "__main__":
    main()
