#!/usr/bin/python3
"""What `check` answers to the edits of core_edits.py, over the project's own library.

HYRAX_ALL_EDITS is set: all of them, else a few.
"""

import concurrent.futures
import json
import os
import re
import tempfile
import unittest

import h5py
import numpy as np

from core_edits import ALL, CONDITIONAL, EQUAL, EVERYDAY, PAIRS, SINGLE, at_ground
from program import AGREED, DISAGREED, PROGRAM, SOURCE, fling, main
from process import succeed
from traced import SHIPPED, traced

EDITS = [edit for edit in ALL if "HYRAX_ALL_EDITS" in os.environ or edit.name in EVERYDAY]


def words_of(text):
    """The text without blanks."""
    return "".join(text.split())


class Answer:
    """What is answered to an edit, and in what it is wrong: a list of sentences."""

    def __init__(self, edit):
        self.edit = edit
        self.header = edit.apply(SHIPPED)
        self.core = traced(self.header)
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
        self.judge_lines()
        if is_changed:
            self.judge_changed(groups)
        elif status == "not_proved":
            self.expect(self.verdict["why"], "no reason is given")

    def judge_lines(self):
        """Every change is in the line that it names."""
        lines = {"removed": SHIPPED.splitlines()}
        for change in self.verdict["changes"]:
            line = lines.get(change["kind"], self.header.splitlines())[change["line"] - 1]
            text = change["detail"].split(" -> ")[-1] if change["kind"] == "altered" else change["detail"]
            self.expect(re.match(r"\W*\w*", text)[0] in line, f"line {change['line']} ({line}) has no {text}")

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
        """The state hash of a scenario by the edited core, or the shipped one."""
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            path = f"{folder}/unnoticed.json"
            with open(path, "w", encoding="utf-8") as file:
                json.dump(scenario, file)
            arguments = ("run", path, "--json", "-o", folder + "/")
            outcome = succeed(PROGRAM, *arguments, cwd=SOURCE) if is_accepted else self.core.run(*arguments)
            return outcome.json["runs"][0]["state_hash"]


class Unnoticed(unittest.TestCase):
    """What the text says of a change that no scenario notices."""

    def test_it_has_the_headers_constants_the_consequence_a_scenario_and_commands(self):
        core = traced(at_ground("narrow", "m_vx > 500.0 && m_vx < 501.0").apply(SHIPPED))
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
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            written = core.run(*write.split()[:-1], folder)
            self.assertEqual(written.exit_code, DISAGREED, written)
            self.assertEqual(set(re.findall(r'"name": "(unnoticed-\w{8})"', outcome.out)), {path[:-5] for path in os.listdir(folder)})
        self.assertIn("core: would be accepted in golden/core\n", core.run(*accept.split(), "--dry-run").out)


class LongRun(unittest.TestCase):
    """A golden file of blocks, by a core whose step is not the paper's with its constants."""

    def test_its_rows_are_restored_by_the_accepted_step(self):
        (edit,) = (edit for edit in SINGLE if edit.name == "half_moves")
        core = traced(edit.apply(SHIPPED))
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            path = f"{folder}/scenarios/long.json"
            os.mkdir(f"{folder}/scenarios")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(fling(name="long", steps=20000), file)
            self.assertEqual(core.run("bless", path, "--reason", "x").exit_code, AGREED)
            rows = {}
            for name, played in (("accepted", core), ("program", traced(SHIPPED))):
                self.assertEqual(played.run("run", path, "-o", f"{folder}/{name}.h5").exit_code,
                                 AGREED if name == "accepted" else DISAGREED)
                with h5py.File(f"{folder}/{name}.h5") as file:
                    rows[name] = np.column_stack([file[f"trajectory/{field}"] for field in ("x", "y", "vx", "vy")])
            (result,) = traced(SHIPPED).run("check", path, "--json").json["results"]
        step = int(np.flatnonzero((rows["accepted"] != rows["program"]).any(axis=1))[0])
        first = result["first_divergence"]
        self.assertEqual((first["step"], first["field"], first["expected"]), (step, "x", rows["accepted"][step, 0]))
        apart = np.hypot(*(rows["accepted"] - rows["program"])[:, :2].T)
        self.assertAlmostEqual(result["max_px"] / apart.max(), 1.0)


class CoreEdits(unittest.TestCase):
    """Each edit, by what is answered."""

    def test_there_are_enough_of_every_kind(self):
        self.assertEqual(len({edit.name for edit in ALL}), len(ALL))
        for edits, count in ((SINGLE, 40), (CONDITIONAL, 40), (EQUAL, 20), (PAIRS, 10)):
            self.assertGreaterEqual(len(edits), count)
        self.assertLessEqual(set(EVERYDAY), {edit.name for edit in ALL})

    def test_the_shipped_core_is_the_accepted_one(self):
        outcome = traced(SHIPPED).run("check", "--json", "scenarios/flings")
        self.assertEqual((outcome.exit_code, outcome.json["cores"][0]["status"]), (AGREED, "accepted"))

    def test_each_edit_is_answered(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for answer in pool.map(Answer, EDITS):
                with self.subTest(edit=answer.edit.name):
                    self.assertEqual(answer.faults, [])


if __name__ == "__main__":
    main()
