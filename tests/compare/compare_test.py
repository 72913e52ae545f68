#!/usr/bin/python3
"""hyrax-compare: each line of the card against an independent evaluation, refusals.

HYRAX_COMPARE_ALL=1 compares and refuses every candidate; without it, a few of each. The program is built here: only the build that runs this test needs it.
"""

import json
import math
import os
import pathlib
import re
import shutil
import unittest

import xxhash

import candidates
import evaluation
import flings
import replay
from process import run, succeed
from program import AGREED, BAD_INPUT, SOURCE, ProgramTest, main

BUILD = pathlib.Path(os.environ["HYRAX_BUILD"])
COMPARE = BUILD / "bin/hyrax-compare"
IS_ALL = os.environ.get("HYRAX_COMPARE_ALL") == "1"
SHIPPED = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
FLINGS, SEED = 4, 3
LIBRARY = ["flings/first-fling", "flings/corner-fling", "flings/into-the-ceiling", "clocks/hitch-in-flight",
           "clocks/jitter-uniform", "clocks/fling-144-hz", "recorded/caught-in-flight",
           "recorded/throw-into-the-lower-left-corner", "recorded/carried-and-laid-down", "hard/start-far-outside",
           "hard/window-of-no-size"]


def setUpModule():
    """Builds the program."""
    succeed("cmake", "--build", BUILD, "--target", "hyrax-compare", timeout=600)


class CompareTest(ProgramTest):
    """A folder with candidates and a small scenario library."""

    def header(self, name, edits):
        """A candidate's header."""
        return self.write(f"{name}.h", candidates.header(SHIPPED, edits))

    def library(self, paths=tuple(LIBRARY)):
        """Copies scenarios of the project."""
        for path in paths:
            target = self.folder / "library" / f"{path}.json"
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / "scenarios" / f"{path}.json", target)

    def compare(self, exit_code, *arguments):
        """Runs hyrax-compare in the folder; it leaves no temporary files, however it ends."""
        temporary = self.folder / "temporary"
        temporary.mkdir(exist_ok=True)
        outcome = run(COMPARE, *arguments, cwd=self.folder, env={**os.environ, "TMPDIR": str(temporary)})
        self.assertEqual(outcome.exit_code, exit_code, outcome)
        self.assertEqual(list(temporary.iterdir()), [], outcome)
        return outcome

    def card(self, name, edits=None, *arguments):
        """The card of a candidate over the small library."""
        self.library()
        header = self.header(name, candidates.COMPARED[name] if edits is None else edits)
        outcome = self.compare(AGREED, header, *arguments, "--json", "--scenarios", "library", "--flings", FLINGS,
                               "--seed", SEED)
        self.assertEqual(outcome.err, "")
        return json.loads(outcome.out)

    def assert_band(self, measured, values, delta):
        """A band of these values."""
        self.assertEqual(measured["samples"] if measured else 0, len(values))
        for key, value in zip(("median", "p10", "p90"), flings.band(values) if values else ()):
            self.assertAlmostEqual(measured[key], value, delta=delta)


class Evaluated(CompareTest):
    """Candidates whose step the oracle has too."""

    def test_lines_agree_with_the_oracle(self):
        for name in evaluation.CORES if IS_ALL else ("position_first",):
            with self.subTest(name):
                card = self.card(name)
                self.check_library(name, card)
                self.check_flings(name, card)
                self.check_displays(name, card)
                self.check_rest(name, card)
                # A control: with the oracle of another core each of these fails.
                for check in (self.check_library, self.check_flings, self.check_displays):
                    with self.assertRaises(AssertionError, msg=check):
                        check("bounce_softer" if name != "bounce_softer" else "no_rest_rule", card)

    def check_library(self, name, card):
        """Classes, contacts, distances and recordings."""
        changed = {each["scenario"]: each for each in card["scenarios"]["changed"]}
        counts = ("moved", "only_before", "only_after")
        classes, contacts, recordings, totals = [], [0, 0], [], dict.fromkeys((*counts, "scenarios"), 0)
        for path in LIBRARY:
            scenario = SOURCE / "scenarios" / f"{path}.json"
            with evaluation.core("same"):
                before = evaluation.play(replay.Scenario(replay.load(scenario)))
            with evaluation.core(name):
                after = evaluation.play(replay.Scenario(replay.load(scenario)))
            wanted = evaluation.compare(before, after)
            classes.append(wanted.kind)
            measured = changed.get(f"{path}.json")
            self.assertEqual(measured["class"] if measured else None, wanted.kind, path)
            if measured:
                for key in counts:
                    self.assertEqual(measured[key], getattr(wanted, key), (path, key))
                    totals[key] += measured[key]
                totals["scenarios"] += any(measured[key] for key in counts)
                self.assertAlmostEqual(measured["max_px"], wanted.max_px, delta=1e-12 * (1.0 + wanted.max_px))
                self.assertAlmostEqual(measured["end_shift_px"], wanted.end_px, delta=1e-12 * (1.0 + wanted.end_px))
            contacts = [a + b for a, b in zip(contacts, wanted.contacts)]
            if path.startswith("recorded/") and wanted.end_px > 0.5:
                recordings.append(f"{path}.json")
        for kind in ("rounding", "values", "contacts", "shape"):
            self.assertEqual(card["scenarios"][kind], classes.count(kind), kind)
        self.assertEqual((card["scenarios"]["count"], card["scenarios"]["cut"]), (len(LIBRARY), 0))
        for key, value in totals.items():
            self.assertEqual(card["contacts"][key], value, key)
        self.assertEqual(list(card["contacts"]["contacts"].values()), contacts)
        self.assertEqual([each["scenario"] for each in card["recordings"]["moved"]], sorted(recordings))

    def check_flings(self, name, card):
        """Where flings land, their classes, energy, and the distance from the exact motion."""
        runs = {}
        for which, core in (("before", "same"), ("after", name)):
            with evaluation.core(core):
                runs[which] = [evaluation.play_fling(evaluation.fling(SEED, number)) for number in range(FLINGS)]
        compared = [evaluation.compare(a, b) for a, b in zip(runs["before"], runs["after"])]
        measured = card["flings"]
        for kind in ("rounding", "values", "contacts"):
            self.assertEqual(measured["classes"][kind], sum(each.kind == kind for each in compared), kind)
        changed = sum(each.moved + each.only_before + each.only_after > 0 for each in compared)
        self.assertEqual((measured["contacts_changed"]["count"], measured["contacts_changed"]["of"]), (changed, FLINGS))
        settled = {which: [evaluation.settles_at(rows) is not None for rows in runs[which]] for which in runs}
        self.assertEqual(measured["settled"], {which: sum(settled[which]) for which in runs})
        ends = [(a[-1], b[-1]) for a, b, c, d in zip(runs["before"], runs["after"], settled["before"], settled["after"])
                if c and d]
        self.assert_band(measured["shift_px"], [b[2] - a[2] for a, b in ends], 1e-9)
        distances = [math.hypot(b[2] - a[2], b[3] - a[3]) for a, b in ends]
        self.assert_band(measured["distance_px"], distances, 1e-9)
        self.assertAlmostEqual(measured["distance_max_px"], max(distances, default=0.0), delta=1e-9)
        motions = [flings.ExactFling(*evaluation.fling(SEED, number)) for number in range(FLINGS)]
        exact = [[motion.at(second)[:2] for second in range(1, 6)] for motion in motions]
        for which, rows_of in runs.items():
            self.assert_band(card["energy"]["drift_px2_per_s2"][which], [evaluation.drift(rows) for rows in rows_of], 1e-3)
            for cause, values in zip(("lift", "bounce", "friction"), zip(*map(evaluation.at_walls, rows_of))):
                self.assert_band(card["energy"][f"{cause}_px2_per_s2"][which], list(values), 1e-3)
            for line in card["exact"]:
                second = int(line["t_s"])
                apart = [math.dist(exact[number][second - 1], rows[60 * second][2:4]) for number, rows in enumerate(rows_of)]
                self.assert_band(line["distance_px"][which], apart, 1e-6)

    def check_displays(self, name, card):
        """The spread over displays."""
        self.assertEqual(card["displays"]["flings"], FLINGS)
        spreads = []
        for core in ("same", name):
            with evaluation.core(core):
                spreads.append([evaluation.spread_px(evaluation.fling(SEED, number)) for number in range(FLINGS)])
        both = [pair for pair in zip(*spreads) if None not in pair]
        for which, values in zip(("before", "after"), zip(*both) if both else ((), ())):
            self.assert_band(card["displays"]["spread_px"][which], list(values), 1e-9)

    def check_rest(self, name, card):
        """What still moves on the floor."""
        self.assertEqual(card["rest"]["rate_hz"], evaluation.RATES)
        for core, which in (("same", "before"), (name, "after")):
            with evaluation.core(core):
                for rate_hz, measured_px in zip(evaluation.RATES, card["rest"]["moved_px"][which], strict=True):
                    self.assertAlmostEqual(measured_px, evaluation.moved_px(rate_hz), delta=1e-9)


class Text(CompareTest):
    """The card as people read it."""

    @unittest.skipUnless(IS_ALL, "nightly")
    def test_the_readme_shows_the_card_of_this_program(self):
        """All but the line that depends on the machine. HYRAX_COMPARE_UPDATE=1 writes it again."""
        path = SOURCE / "sim/card/README.md"
        readme = path.read_text(encoding="utf-8")
        shown = re.search(r"```text\n(.*?)```", readme, re.DOTALL)[1]
        text = self.compare(AGREED, self.header("drag_by_time", candidates.COMPARED["drag_by_time"])).out

        if os.environ.get("HYRAX_COMPARE_UPDATE") == "1":
            path.write_text(readme.replace(shown, text), encoding="utf-8")
            return

        self.assertEqual(*([line for line in card.splitlines() if "ns a step" not in line] for card in (text, shown)))


class Consequence(CompareTest):
    """The largest consequence for a user, in one sentence; and what the traced steps say, before any figure."""

    def test_a_rounding_rearrangement_breaks_no_invariant_of_any_core(self):
        hard_cases = self.card("rearranged")["hard_cases"]
        self.assertEqual(hard_cases["general"]["newly_broken"], [])
        self.assertGreater(hard_cases["listing"]["random_runs_broken"]["after"]["count"], 0)

    def test_a_change_in_random_runs_alone_is_said(self):
        card = self.card("lighter_in_a_small_window")
        self.assertEqual((card["scenarios"]["changed"], card["flings"]["classes"]["same_bits"]), ([], FLINGS))
        self.assertRegex(card["consequence"], r"[1-9]\d* of 500 random runs")

    @unittest.skipUnless(IS_ALL, "nightly")
    def test_two_headers_may_define_the_same_function_differently(self):
        base = self.header("base", candidates.HELPER_BASE)
        shipped = self.card("helper_of_the_same_name")
        other = self.card("helper_of_the_same_name", None, base)
        self.assertEqual(other["flings"], shipped["flings"])
        self.assertNotEqual(other["flings"]["shift_px"]["median"], 0)
        same = self.card("base", candidates.HELPER_BASE)
        self.assertEqual(same["consequence"], "None: every row has the same bits.")

    def test_what_is_not_proved_is_not_called_so(self):
        # No scenario or fling of these comes there.
        unseen = [("m_vx *= AIR_DRAG;", "m_vx *= AIR_DRAG;\n    if (screenWidth == 31001) m_vx *= 0.5;")]
        step = self.card("unseen", unseen)["step"]
        self.assertEqual((step["status"], step["why"]), ("not_proved", "its step is another one; no step is known whose bits differ"))
        table = [("m_vx *= AIR_DRAG;", "const double drag[] = {0.998, 0.999};\n    m_vx *= drag[objWidth % 2];")]
        step = self.card("table", table)["step"]
        self.assertEqual(step["status"], "changed")
        self.assertIn("integer", step["why"])


class Alone(CompareTest):
    """Without a candidate: the project's core against another one that was accepted."""

    def accepted(self, edits, step=None):
        """A golden folder whose accepted core is the shipped one, edited; without a step, as if none was traced."""
        header = candidates.header(SHIPPED, edits)
        constants = ", ".join(f"{name} {float(value):.12g}" for name, value in re.findall(r"double (\w+) = ([0-9.]+);", header))
        named = xxhash.xxh3_128_hexdigest(step.encode()) if step else "not complete: by hand"
        if step:
            self.write("golden/core/step.txt", step)
        text = (f"hyrax-core/1\nclass: hyrax-physics/1\nconstants: {constants}\n"
                f"header: {xxhash.xxh3_128_hexdigest(header.encode())}\nstep: {named}\nreason: a test\n")
        self.write("golden/core/physics.h", header)
        self.write("golden/core/accepted.txt", text + f"checksum: {xxhash.xxh3_128_hexdigest(text.encode())}\n")

    def test_the_accepted_core_is_the_base(self):
        self.library()
        self.accepted([("GRAVITY = 1200.0", "GRAVITY = 1100.0")])
        arguments = ["--golden", "golden", "--scenarios", "library", "--flings", FLINGS]
        text = self.compare(AGREED, *arguments).out
        self.assertTrue(text.startswith("sim/physics/physics.h against golden/core/physics.h\n"), text)
        self.assertIn("changed; not all paths are known: the step of golden/core/physics.h is not complete: by hand\n"
                      "                  line 16   constant: GRAVITY 1100 -> 1200\n", text)

    def test_an_accepted_header_that_takes_another_step_now_is_refused(self):
        """As after a change of a header that it includes."""
        self.library()
        text = (SOURCE / "golden/core/step.txt").read_text(encoding="utf-8").rsplit("checksum: ", 1)[0]
        changed = text.replace("1200{0x1.2cp+10}", "1250{0x1.388p+10}")
        self.assertNotEqual(changed, text)
        checksum = 0xcbf29ce484222325
        for byte in changed.encode():
            checksum = ((checksum ^ byte) * 0x100000001b3) % 2 ** 64
        self.accepted([("A body in a window.", "A body in its window.")], f"{changed}checksum: {checksum:016x}\n")
        outcome = self.compare(BAD_INPUT, "--golden", "golden", "--scenarios", "library", "--flings", FLINGS)
        self.assertEqual(outcome.err, "golden/core/physics.h: compiled now, it does not take the accepted step, golden/core/step.txt "
                                      "(an included header or a compiler option changed); name a base\n")


class OtherInterface(CompareTest):
    """Headers that are not written as the shipped one is."""

    def test_without_constants_or_default_constructor_it_has_the_other_lines(self):
        edits = [("  static constexpr double GRAVITY = 1200.0;       ///< px/s^2, downwards.\n", ""), ("GRAVITY", "1200.0"),
                 ("AIR_DRAG", "DRAG"), ("  physics() : physics(0.0, 0.0) {}\n", "")]
        card = self.card("same_step", edits)
        self.assertEqual((card["lacking"], card["step"]["status"]), ("the candidate has no GRAVITY, AIR_DRAG", "proved_equal"))
        self.assertEqual((card["claims"], card["hard_cases"]["general"], card["hard_cases"]["listing"]), (None, None, None))
        self.assertEqual((card["hard_cases"]["cases_changed"], card["hard_cases"]["random_runs_changed"]["count"]), (0, 0))
        self.assertEqual(card["scenarios"]["same_bits"], len(LIBRARY))

    def test_what_it_prints_and_its_macros_change_nothing(self):
        prints = [("#include <cmath>\n", "#include <cmath>\n#include <cstdio>\n#define State 1\n#define Bounds 2\n#  define core 3\n"
                                         "#define Row *\n#define updates 4\n"),
                  ("    m_vx *= AIR_DRAG;\n", "    m_vx *= AIR_DRAG;\n    if (m_x > 900.0) std::puts(\"far\");\n")]
        card = self.card("prints", prints)
        self.assertEqual(card["consequence"], "None: every row has the same bits.")


class Refused(CompareTest):
    """Candidates whose results cannot be compared, and bad input."""

    def test_hidden_defects_are_refused_with_the_reason(self):
        for name in candidates.REFUSED if IS_ALL else ("static_counter", "exits_when_loaded", "flushes_to_zero"):
            with self.subTest(name):
                edits, reason = candidates.REFUSED[name]
                outcome = self.compare(BAD_INPUT, self.header(name, edits), "--limit", 20)
                self.assertRegex(outcome.err, f"^{name}.h: refused: .*({reason})")
                self.assertEqual(outcome.out, "")

    def test_a_header_whose_class_lacks_a_function_gets_a_sentence(self):
        outcome = self.compare(BAD_INPUT, self.header("broken", [("double x() const", "double left() const")]), "--json")
        self.assertRegex(outcome.err, r"\Abroken\.h: does not compile: .*class physics needs .* const x, y, vx, vy\n\Z")
        self.assertEqual(outcome.out, "")


if __name__ == "__main__":
    main()
