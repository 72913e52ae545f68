#!/usr/bin/python3
"""To what `check` puts the runs of every altered core: the core, the clock, the inputs; and of edits outside of it.

    cause_test.py             tests, and compares README.md beside this file with the table
    cause_test.py --update    writes the table into README.md
"""

import functools
import json
import sys

from altered import CONTROLS, SAME_BITS, altered_cores, run_altered
from process import run
from program import AGREED, SOURCE, ProgramTest, main

README = SOURCE / "tests/must_fail/README.md"
BEGIN, END = "<!-- table of cause_test.py -->\n", "<!-- end of the table -->\n"

SCENARIOS = [f"scenarios/{name}.json" for name in (
    "flings/first-fling", "flings/grab-and-throw", "flings/slide-and-refling", "flings/stop-in-flight", "flings/into-the-ceiling",
    "flings/sprite-grows-and-shrinks", "flings/window-edge-dragged", "paper/exact-bounds", "paper/corner-x-before-y",
    "hard/corners", "hard/rest", "hard/on-a-bound", "hard/grazing", "hard/sprite-larger-than-window", "hard/frames-of-no-time",
    "hard/trace-of-extremes", "clocks/jitter-normal", "clocks/jitter-uniform", "clocks/missed-frames")]

# Runs whose golden files keep blocks and no frame times.
LONG = [f"scenarios/{name}.json" for name in (
    "clocks/hour-at-60-hz", "clocks/missed-frames-ten-minutes", "hard/a-fling-a-minute")]
OUTSIDE = ("first_frame_longer", "jitter_of_first_frame", "jitter_shifted", "last_input_late", "comparer_and_rest_rule",
           "frames_longer", "jitter_longer", "inputs_late", "inputs_later", "comparer_and_gravity")

# Which runs it changes depends on the runs before and beside them.
NOT_REPEATABLE = "hidden_state"

# What a group says. An altered header has other constants, or one more statement in the line after the last.
CORE = f"the core changed at line {len((SOURCE / 'sim/physics/physics.h').read_text().splitlines()) + 1}"
DETAILS = {"core": rf"({CORE}|[A-Z_]+ \S+ -> [^ ;]+(; [A-Z_]+ \S+ -> [^ ;]+)*)$",
           "clock": "the clock gives other frame times: dt of row ",
           "input": "inputs differ: .* in frame ",
           "non_finite": r"(in the worst, )?(x|y|vx|vy) is (infinite|not a number)",
           "unknown": "the core is the accepted one, and its step gives the golden file, but this program does not"}


@functools.cache
def document_of(core):
    """What `check` says of a core, or of the fused build."""
    arguments = ("check", "--json", *SCENARIOS)
    if core == "contracted":
        return json.loads(run(CONTROLS / "control_contracted", *arguments, cwd=SOURCE).out)
    return json.loads(run_altered(core, *arguments).out)


def all_cores():
    """Their names, that of the fused build last."""
    return [*(core for core in altered_cores() if core != NOT_REPEATABLE), "contracted"]


def table():
    """A row for each set of causes: the altered cores of which it is said."""
    rows = {}
    for core in all_cores():
        causes = ", ".join(sorted({group["operation"] for group in document_of(core)["groups"]}))
        rows.setdefault(causes or "no bit differs", []).append(f"`{core}`")
    lines = [f"| {said} | {', '.join(rows[said])} |\n" for said in sorted(rows)]
    return "".join(["| causes | altered cores |\n|---|---|\n", *lines])


class Causes(ProgramTest):
    """Each altered core, by what is said of it."""

    def test_each_has_the_causes_of_the_readme_and_a_detail_of_each(self):
        text = README.read_text(encoding="utf-8")
        self.assertEqual(text.partition(BEGIN)[2].partition(END)[0], table())
        for core in all_cores():
            with self.subTest(core=core):
                document = document_of(core)
                groups = document["groups"]
                self.assertEqual(len(groups), len({group["operation"] for group in groups}), "a cause has two groups")
                self.assertEqual(sum(len(group["scenarios"]) for group in groups), document["disagreed"])
                for group in groups:
                    self.assertRegex(group["detail"], f"^{DETAILS[group['operation']]}")

    def test_edits_outside_the_core_are_told_apart_in_long_runs_too(self):
        for core in OUTSIDE:
            with self.subTest(core=core):
                document = json.loads(run_altered(core, "check", "--json", *LONG).out)
                self.assertGreater(document["disagreed"], 0)
                self.assertEqual({group["operation"] for group in document["groups"]} - {"non_finite"},
                                 {{"clock": "clock", "inputs": "input"}.get(altered_cores()[core], "core")})

    def test_of_a_program_that_does_not_repeat_itself_that_is_said(self):
        details = [group["detail"] for group in document_of(NOT_REPEATABLE)["groups"]]
        self.assertIn("this program does not repeat itself: played twice, the scenario gives different bits", details)
        # Two plays may be the same by chance: then the core, never the golden file.
        self.assertLessEqual(set(group["operation"] for group in document_of(NOT_REPEATABLE)["groups"]), {"unknown", "core"})
        for options, says in (((), "does not repeat itself"), (("--verbose",), ": disagreed\n")):
            printed = run_altered(NOT_REPEATABLE, "check", *options, *SCENARIOS).out
            self.assertIn(says, printed)
            self.assertNotIn("to accept it", printed)

    def test_a_core_that_is_not_traced_is_not_proved(self):
        for core in SAME_BITS - {"none"}:
            (verdict,) = document_of(core)["cores"]
            self.assertEqual((verdict["status"], verdict["why"]), ("not_proved", "altered for a test"))
        for core, status in (("none", "accepted"), ("inputs_late", "accepted"), ("fling_swapped", "changed")):
            self.assertEqual(document_of(core)["cores"][0]["status"], status)
        self.assertEqual(run_altered("turn_before_clamp", "check", SCENARIOS[0]).exit_code, AGREED)


if __name__ == "__main__":
    if "--update" in sys.argv:
        readme = README.read_text(encoding="utf-8")
        README.write_text(readme[:readme.index(BEGIN)] + BEGIN + table() + readme[readme.index(END):], encoding="utf-8")
    else:
        main()
