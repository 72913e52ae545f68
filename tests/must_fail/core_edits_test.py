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
from program import AGREED, BAD_INPUT, DISAGREED, PROGRAM, SOURCE, ProgramTest, fling, main
from process import preloading, succeed
from traced import SHIPPED, SHIPPED_CORE, traced

EDITS = [edit for edit in ALL if "HYRAX_ALL_EDITS" in os.environ or edit.name in EVERYDAY]
CORES = {edit.name: traced(edit.apply(SHIPPED)) for edit in (
    *EDITS, *(edit for edit in ALL if edit.name in ("half_moves", "static_variable")),
    at_ground("narrow", "m_vx > 500.0 && m_vx < 501.0"), when("1200_high", "screenHeight == 1200"),
    when("dt_of_0", "dt == 0.0 && m_vx > 123456.0"), when("dt_of_-0", "dt == 0.0 && m_vx > 123456.0 && std::signbit(dt)"))}
CHANGED = CORES["GRAVITY_1250.0+REST_THRESHOLD_7.0"]
# Gravity changes every row; a bound of the left wall decides where a sprite ends on it to the bit.
BESIDE = traced(SHIPPED.replace("GRAVITY = 1200.0", "GRAVITY = 1250.0").replace("if (m_x < 0.0)", "if (m_x <= 0.0)"))
# A sprite that turns, at two rates: no file holds how far.
SPINNING = [traced(SHIPPED.replace(" private:\n", " private:\n  double m_spin = 0.0;\n").replace(
    "    m_x += m_vx * dt;\n", f"    m_x += m_vx * dt;\n    m_spin += {rate} * m_vx;\n    if (m_spin > 6.25) m_spin -= 6.25;\n")) for rate in (0.5, 0.25)]


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
            self.assertRegex(says, r"^(, which changes results: this one, played for 5(\.\d+)? s, ends (in the same state, after at most )?\S+ px apart| either; unnoticed-\w{8} shows it)$")
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
        self.assertEqual(annotation, "::error file=golden/core/accepted.txt,title=hyrax-sim check%3A core::" +
                         core.replace("%", "%25").replace("\n", "%0A"))
        suite = ElementTree.parse(report).getroot()
        failure = suite.find("testcase[@name='golden/core/accepted.txt']/failure")
        self.assertEqual((suite.get("failures"), failure.get("message"), failure.text), ("1", "core: changed", core + "\n"))
        self.assertIn("## hyrax-sim check: not agreed\n", summary.read_text())
        heading, lines = core.split("\n", 1)
        self.assertIn(f"\n### `{heading}`\n\n    " + lines.replace("\n", "\n    ") + "\n", summary.read_text())
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
            self.assertRegex(outcome.out, r"this one, played for 0 s, ends [\d,]+ px/s apart")


class Beyond(ProgramTest):
    """Random flings by both cores."""

    def test_shares_have_their_intervals_and_errors_are_those_of_the_same_constants(self):
        for name, has_errors in (("GRAVITY_1250.0+REST_THRESHOLD_7.0", False), ("half_moves", True)):
            beyond = CORES[name].run("check", "--core", "--json", "--flings", "200").json["cores"][0]["beyond"]
            self.assertEqual((beyond["flings"], beyond["end_error_px"] is not None), (200, has_errors))
            shares = [beyond[part] for part in ("other_bits", "ends_elsewhere", "other_bounces", "settles_in_one")]
            for share in shares:
                part, z2 = share["share"], 1.959964 ** 2 / 200  # E. B. Wilson, 1927.
                half = math.sqrt(z2 * (part * (1 - part) + z2 / 4))
                for side, bound in (("low", -half), ("high", half)):
                    self.assertAlmostEqual(share[side], (part + z2 / 2 + bound) / (1 + z2), places=6)
            self.assertGreaterEqual(shares[0]["share"], shares[1]["share"])
            self.assertEqual(shares[1]["median_px"] is None, shares[1]["share"] == 0)

    def test_it_is_left_out_with_a_reason_or_where_the_core_did_not_change(self):
        for core, flings, arguments, why in ((CHANGED, 0, ("--core",), "--flings 0"),
                                             (CHANGED, 9, ("scenarios/flings/first-fling.json",), "the library was not played whole"),
                                             (CORES["static_variable"], 9, (), "this program's step is not complete: memory outside the body"),
                                             (SHIPPED_CORE, 9, (), None)):
            core, = core.run("check", "--json", "--flings", str(flings), *arguments).json["cores"]
            self.assertTrue(core["beyond"]["why"].startswith(why) if why else "beyond" not in core, core)

    def test_text_has_one_paragraph(self):
        outcome = CHANGED.run("check", "--flings", "100")
        share = r"[\d.]+ % \([\d.]+ \.\. [\d.]+\)"
        self.assertRegex(outcome.out, rf"\n  beyond the library: of 100 random flings of 10 s, {share} have other bits; {share} end elsewhere, by \S+ px "
                         rf"\(median; 90 %: \S+ px\); {share} have another number of contacts; {share} settle in one only\n")


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

    def test_a_core_is_accepted_only_where_every_other_scenario_of_the_library_agrees(self):
        path, other = self.add("a"), self.add("b", steps=0)  # Every core gives its bits.
        library, (h5,) = f"{self.folder}/scenarios", [self.folder / "golden/b.h5"]
        self.play(SHIPPED_CORE, AGREED, "bless", library, "--reason", "x")
        accepted, text, golden = self.state_of("golden/core"), other.read_text(encoding="utf-8"), h5.read_bytes()
        for spoil in (h5.unlink, lambda: other.write_text("{", encoding="utf-8"), lambda: other.write_text(text.replace('"steps": 0', '"steps": 1'), encoding="utf-8")):
            spoil()
            why = f"1 of 2 scenarios do not agree, the first is {other}"
            for command in ((path, "--accept", "contacts"), (library, "--core")):
                document = self.play(CHANGED, AGREED if command[0] == path else DISAGREED, "bless", *command, "--reason", "x", "--json").json
                self.assertEqual(document["cores"], [{"golden": f"{self.folder}/golden", "accepted": False, "why_not": why}])
                self.assertEqual((document["written"], self.state_of("golden/core")), (command[0] == path, accepted))
            other.write_text(text, encoding="utf-8")
            h5.write_bytes(golden)
        document = self.play(CHANGED, AGREED, "bless", library, "--core", "--reason", "x", "--json").json
        self.assertEqual((document["written"], document["cores"][0]["accepted"]), (True, True))

    def test_a_change_is_not_noticed_by_what_another_one_changes(self):
        path = self.add("a")  # It never ends on the left wall to the bit.
        self.play(SHIPPED_CORE, AGREED, "bless", path, "--reason", "x")
        core, = self.play(BESIDE, DISAGREED, "check", "--core", path, "--json").json["cores"]
        self.assertEqual(core["status"], "changed")
        self.assertEqual([one["difference"] for one in core["unnoticed"]], ["x + dt * (vx * AIR_DRAG) < 0", "x + dt * (vx * AIR_DRAG) <= 0"])
        for one in core["unnoticed"]:
            self.assertIsNotNone(one["scenario"])

    def test_a_changed_rule_that_no_row_depends_on_is_not_recorded(self):
        path = self.add("a")
        self.play(SPINNING[0], AGREED, "bless", path, "--reason", "x")
        self.play(SPINNING[0], AGREED, "check", "--core", path)
        out = self.play(SPINNING[1], DISAGREED, "check", f"{self.folder}/scenarios").out
        self.assertIn("core: not proved equal to the accepted one: m_spin is not recorded: describe it\n", out)
        self.assertRegex(out, "\n  no scenario can notice `vx .*`: it changes m_spin alone, which no file holds\n")
        self.assertRegex(out, "\n  to accept it    hyrax-sim bless .* --core --reason \"...\"\n")
        core, = self.play(SPINNING[1], DISAGREED, "check", "--core", path, "--json").json["cores"]
        self.assertEqual((core["status"], core["why"]), ("not_proved", "m_spin is not recorded: describe it"))
        self.play(SPINNING[1], AGREED, "bless", f"{self.folder}/scenarios", "--core", "--reason", "x")
        self.play(SPINNING[1], AGREED, "check", "--core", path)

    def test_scenarios_of_unnoticed_changes_replace_no_file(self):
        self.play(SHIPPED_CORE, AGREED, "bless", self.add("a"), "--reason", "x")
        command = ("check", "--core", f"{self.folder}/scenarios", "--unnoticed", self.folder / "unnoticed")
        self.play(CORES["narrow"], DISAGREED, *command)
        kept, *others = sorted((self.folder / "unnoticed").iterdir())
        self.assertTrue(others)
        for path in others:
            path.unlink()
        kept.write_text("edited", encoding="utf-8")
        outcome = self.play(CORES["narrow"], BAD_INPUT, *command)
        self.assertEqual(outcome.err, f"hyrax-sim check: --unnoticed: exists already (found {kept}); nothing written; name another folder\n")
        self.assertEqual((kept.read_text(encoding="utf-8"), list(kept.parent.iterdir())), ("edited", [kept]))

    def test_a_step_that_changes_while_its_header_does_not(self):
        path = self.add("a")
        self.play(SHIPPED_CORE, AGREED, "bless", path, "--reason", "x")
        core = copy.copy(CHANGED)
        core.header = SHIPPED_CORE.header
        says = "the core's step changed, its header did not: an included header or a compiler option"
        self.assertEqual(self.groups(core), {"a": ("core", says)})
        self.assertIn(f"core: changed\n  {says}\n", self.play(core, AGREED, "check", "--core", path).out)

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
