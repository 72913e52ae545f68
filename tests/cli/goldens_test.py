"""The folder golden/: a pair of files of each scenario, small files and no others."""

import pathlib
import re
import shutil
import tempfile
import unittest

from process import run, succeed
from program import PROGRAM, SOURCE

BYTES_MAX = 10_000_000


class Goldens(unittest.TestCase):

    def test_each_summary_is_what_bless_writes(self):
        """But for its reason, and the checksum of a file that names the program."""
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            shutil.copytree(SOURCE / "scenarios", f"{folder}/scenarios")
            succeed(PROGRAM, "bless", "scenarios", "--reason", "again", cwd=folder)
            for scenario in (SOURCE / "scenarios").rglob("*.json"):
                path = pathlib.Path("golden", scenario.relative_to(SOURCE / "scenarios")).with_suffix(".txt")
                again, kept = (re.sub(r"^(reason: .*|(checksums: \w+) \w+)$", r"\2", (root / path).read_text(encoding="utf-8"), flags=re.MULTILINE)
                               for root in (pathlib.Path(folder), SOURCE))
                self.assertEqual(again, kept, path)

    def test_only_a_disagreement_is_bad_for_git_bisect(self):
        """Each command of the README with a tools/check that ends so; a commit that cannot be judged is skipped."""
        text = (SOURCE / "golden/README.md").read_text(encoding="utf-8")
        commands = re.findall(r"^git bisect run (sh -c '[^']*')$", text, re.MULTILINE)
        self.assertEqual(len(commands), 2)
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            (pathlib.Path(folder) / "project/tools").mkdir(parents=True)
            script = pathlib.Path(folder) / "project/tools/check"
            for exit_code, of_bits, of_contacts in ((0, 0, 0), (1, 1, 1), *((code, 125, 125) for code in (2, 3, 4, 5))):
                moved = """echo '"class": "contacts"'\n""" if exit_code == 1 else ""
                script.write_text(f"#!/bin/sh\n{moved}exit {exit_code}\n")
                script.chmod(0o755)
                self.assertEqual([run("sh", "-c", command, cwd=script.parents[1]).exit_code for command in commands],
                                 [of_bits, of_contacts], exit_code)

    def test_every_path_of_the_step_is_taken_by_two_scenarios(self):
        scenarios = sorted((SOURCE / "scenarios").rglob("*.json"))
        paths = [succeed(PROGRAM, "check", "--json", *half, cwd=SOURCE).json["cores"][0]
                 for half in (scenarios[::2], scenarios[1::2], ["scenarios/flings/first-fling.json"])]
        taken = [core["paths_taken"] for core in paths]
        self.assertEqual(taken[:2], [core["paths"] for core in paths[:2]])
        self.assertIn(taken[2], range(1, paths[2]["paths"]))  # The control: one scenario takes some of them only.

    def test_each_scenario_has_its_two_and_nothing_else_is_there(self):
        files = [path for path in (SOURCE / "golden").rglob("*") if path.is_file()]
        self.assertLess(sum(path.stat().st_size for path in files), BYTES_MAX)
        scenarios = [path.relative_to(SOURCE / "scenarios") for path in (SOURCE / "scenarios").rglob("*.json")]
        pairs = [str(path.with_suffix(suffix)) for path in scenarios for suffix in (".h5", ".txt")]
        self.assertEqual(sorted(str(path.relative_to(SOURCE / "golden")) for path in files),
                         sorted(["README.md", "core/accepted.txt", "core/physics.h", "core/step.txt", *pairs]))
