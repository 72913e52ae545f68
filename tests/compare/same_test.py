#!/usr/bin/python3
"""hyrax-compare without a candidate: the project's core against the accepted one; and a header that cannot be compiled."""

import json
import os
import pathlib
import re
import shutil

from process import run
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, SOURCE, ProgramTest, main, needs_page

COMPARE = pathlib.Path(os.environ["HYRAX_COMPARE"])


class SameTest(ProgramTest):
    """The everyday build's hyrax-compare."""

    of_library = ("--json", "--scenarios", "library", "--flings", "3", "--seed", "5")

    def compare(self, *arguments):
        """Exit code, what is printed, and what is said of errors; it leaves no temporary files."""
        temporary = self.folder / "temporary"
        temporary.mkdir(exist_ok=True)
        outcome = run(COMPARE, *arguments, cwd=self.folder, env={**os.environ, "TMPDIR": str(temporary)})
        self.assertEqual(list(temporary.iterdir()), [], outcome)
        return outcome.exit_code, outcome.out, outcome.err

    def write_library(self):
        """Four scenarios, two of them recorded."""
        for path, name in (("recorded/caught-in-flight", "recorded/caught"), ("flings/stop-in-flight", "recorded/stop"),
                           ("hard/window-of-no-size", "hard/no-size"), ("flings/first-fling", "recorded-later/first-fling")):
            target = self.folder / f"library/{name}.json"
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / f"scenarios/{path}.json", target)

    def test_the_accepted_core_needs_no_card(self):
        self.assertEqual(self.compare(), (AGREED, "sim/physics/physics.h is the accepted core, golden/core/physics.h: "
                                                  "nothing to compare\n", ""))

    def test_a_header_that_is_not_there_has_a_line(self):
        self.write("broken.h", "// A core.\n#include \"none.h\"\n")
        self.assertEqual(self.compare("broken.h"),
                         (BAD_INPUT, "", "broken.h: does not compile: broken.h:2: none.h: No such file or directory\n"))

    def test_the_page_is_not_written_into_the_golden_folder(self):
        shutil.copytree(SOURCE / "golden/core", self.folder / "accepted/core")
        exit_code, _, err = self.compare("--golden", "accepted", "--report", "accepted/card.html")
        self.assertEqual(exit_code, BAD_INPUT)
        self.assertIn("--report: is a golden file or in a golden folder (found accepted/card.html)", err)

    @needs_page
    def test_the_page_has_the_command_and_both_cores(self):
        self.write_library()
        exit_code, _, err = self.compare(*self.of_library, "--report", "card.html")
        self.assertEqual((exit_code, err), (AGREED, ""))
        page = json.loads(re.search('id="data">(.*?)</script>', (self.folder / "card.html").read_text(), re.DOTALL)[1])
        self.assertEqual(page["command"], f"hyrax-compare {' '.join(self.of_library)} --report card.html")
        self.assertEqual(page["results"][0]["title"], "physics.h: candidate against base")
        self.assertEqual(page["results"][0]["origin"], {"candidate": "sim/physics/physics.h", "base": "golden/core/physics.h"})

    def test_everything_is_the_same(self):
        self.write_library()
        exit_code, out, err = self.compare(*self.of_library)
        self.assertEqual((exit_code, err), (AGREED, ""))
        card = json.loads(out)
        self.assertEqual((card["candidate"], card["base"], card["seed"]),
                         ("sim/physics/physics.h", "golden/core/physics.h", 5))
        self.assertEqual((card["step"], card["lacking"]), ({"status": "proved_equal", "why": None, "changes": []}, None))
        self.assertEqual(card["scenarios"], {"count": 4, "same_bits": 4, "rounding": 0, "values": 0, "contacts": 0, "shape": 0,
                                             "cut": 0, "changed": []})
        self.assertEqual(card["flings"]["classes"]["same_bits"], 3)
        hard = card["hard_cases"]
        self.assertEqual((hard["cases"], hard["cases_changed"], hard["random_runs_changed"]["count"]), (1, 0, 0))
        self.assertEqual((card["claims"]["changed"], card["claims"]["not_measured"], card["claims"]["other_numbers"]), ([], [], 0))
        self.assertEqual(card["recordings"], {"recordings": 2, "moved": []})
        self.assertEqual(card["consequence"], "None: every row has the same bits.")
        self.assertGreater(card["cost"]["step_ns"]["after"]["median"], 0.0)
        said, of_band, of_share = re.search(r"with all digits: (.*?)\. A band is `\{(.*?)\}`, a share\s`\{(.*?)\}`",
                                            " ".join((SOURCE / "sim/card/README.md").read_text(encoding="utf-8").split())).groups()
        self.assertEqual(re.findall(r"`(\w+)`", re.sub(r"\(.*?\)", "", said)), list(card)[list(card).index("step"):])
        self.assertEqual([of_band, of_share], [", ".join(each) for each in (card["cost"]["ratio"], hard["random_runs_changed"])])

    def test_an_accepted_core_that_is_damaged_or_missing_is_named(self):
        self.assertEqual(self.compare("--golden", "golden"),
                         (GOLDEN_MISSING, "", "golden/core: no accepted core; name a base, or accept this program's core: "
                                              "hyrax-sim bless --golden golden --core --reason TEXT\n"))
        shutil.copytree(SOURCE / "golden/core", self.folder / "golden/core")
        with open(self.folder / "golden/core/physics.h", "a", encoding="utf-8") as header:
            header.write("\n")
        self.assertEqual(self.compare("--golden", "golden"),
                         (DISAGREED, "", "golden/core/physics.h: does not have the checksum in accepted.txt; take the folder from "
                                         "version control\n"))

    def test_help_is_approved(self):
        approved = re.search("```text hyrax-compare --help\n(.*?)```", (SOURCE / "tests/cli/outputs.md").read_text(encoding="utf-8"), re.DOTALL)[1]
        self.assertEqual(self.compare("a.h", "--help"), (AGREED, approved, ""))

    def test_bad_usage_and_missing_files(self):
        for arguments, exit_code, says in (
                (["a.h", "b.h", "c.h"], BAD_INPUT, "hyrax-compare: CANDIDATE.h [BASE.h]: at most 2 allowed (found 3)"),
                (["a.h", "--jsn"], BAD_INPUT, "unknown option (found --jsn)"),
                (["a.h", "--seed", "x"], BAD_INPUT, "--seed: must be a whole number 0 .. 9223372036854775807 (found x)"),
                (["a.h", "--flings", "0"], BAD_INPUT, "--flings: must be a whole number 1 .. 100000 (found 0)"),
                (["a.h", "--limit", "86401"], BAD_INPUT, "--limit: must be a whole number 1 .. 86400 (found 86401)"),
                (["a.h", "--report", "card.txt"], BAD_INPUT, "--report: unknown suffix (found card.txt); allowed: .html"),
                (["missing.h"], CANNOT_ACCESS, "missing.h: cannot be read"),
                (["missing.h", "--scenarios", "nowhere"], CANNOT_ACCESS, "nowhere: cannot be read")):
            with self.subTest(arguments):
                outcome = self.compare(*arguments)
                self.assertEqual(outcome[:2], (exit_code, ""))
                self.assertIn(says, outcome[2])


if __name__ == "__main__":
    main()
