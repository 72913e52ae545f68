"""The command study: the files, output and errors of needs, speed-error and hard-cases."""

import math
import re

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, SOURCE, ProgramTest, fling, is_long

HARD = SOURCE / "scenarios/hard"
CALM = fling(name="calm", steps=900)


class Needs(ProgramTest):
    """study needs. What the files of a study hold is in outputs.md."""

    def test_files_go_into_the_folder_that_is_named_and_are_named_in_the_end(self):
        self.write("fling.json", fling())
        study = ("study", "needs", "fling.json", "--quick", "--no-figures")
        self.assertIn("written: new/folder/needs.h5, new/folder/needs.csv", self.expect(AGREED, *study, "-o", "new/folder").out)
        self.assertEqual(self.names("new/folder"), ["needs.csv", "needs.h5"])
        with h5py.File(self.folder / "new/folder/needs.h5") as file:
            self.assertIn("hyrax-sim", file["provenance"].attrs["program"])
        document = self.expect(AGREED, *study, "--json").json
        self.assertEqual((document["study"], document["files"], document["broken"]), ("needs", ["needs.h5", "needs.csv"], []))

    def test_what_counts_depends_on_the_tolerance(self):
        self.write("fling.json", fling())
        for within, verdict in (("100000", "below the tolerance"), ("0.001 px", "needed")):
            study = self.expect(AGREED, "study", "needs", "fling.json", "--within", within, "--quick", "--no-figures", "--json").json
            self.assertEqual([part["verdict"] for part in study["scenes"][0]["parts"] if part["part"] == "drag"], [verdict])

    def test_a_scene_without_exact_solution_says_so(self):
        self.assertIn("No cheapest method: its window cannot hold its sprite, so that it has no exact solution.", self.expect(
            AGREED, "study", "needs", HARD / "sprite-larger-than-window.json", "--quick", "--no-figures").out)


class Removed(ProgramTest):
    def test_what_went_says_where_its_answers_are(self):
        for arguments, says in ((("paper", "--gate"), "study paper: was removed; the paper's claims and their figures are in sim/physics/claims.md"),
                                (("needs", "--expect", "x"), "study: --expect: was removed; the paper's claims and their verdicts are in sim/physics/claims.md")):
            self.expect(BAD_INPUT, "study", *arguments, says=says)


class Page(ProgramTest):
    """study --report."""

    def test_the_page_has_the_answer_the_pictures_and_the_tables_and_last_what_does_not_hold(self):
        document = self.expect(AGREED, "study", "hard-cases", HARD / "rest.json", "--quick", "-o", "out", "--report", "page.html", "--json").json
        self.assertEqual(document["files"], ["out/hard-cases.h5", "out/hard-cases.csv", "out/hard-cases.svg", "page.html"])
        page = (self.folder / "page.html").read_text(encoding="utf-8")
        picture = re.findall("<text.*(>.*</text>)", (self.folder / "out/hard-cases.svg").read_text(encoding="utf-8"))[-1]
        places = [page.index(part) for part in ("<html lang=\"en\" data-replay=\"none\" data-ready=\"\">", f"<h1>{document['answer'][:-1]}</h1>", picture,
                                                "<summary>", "No rule of the study is broken.", f"study hard-cases {HARD}/rest.json --quick --report page.html")]
        self.assertEqual(places, sorted(places))
        self.assertNotRegex(page, r"<script[^>]* src|<link")  # One file, which loads nothing.

    def test_replaces_neither_scenario_nor_golden_file_and_needs_its_folder(self):
        path, = self.project("calm")
        self.write("scenario.html", CALM)
        before = self.state_of(".")
        for exit_code, page, says in ((BAD_INPUT, "page.htm", "--report: unknown suffix (found page.htm); allowed: .html"), (BAD_INPUT, "golden/page.html", "golden"),
                                      (BAD_INPUT, "scenario.html", "would overwrite a scenario"), (CANNOT_ACCESS, "no/such/page.html", "no/such/page.html: cannot be written")):
            self.expect(exit_code, "study", "needs", path, "--quick", "-o", "out", "--report", page, says=says)
            self.assertEqual(self.state_of("."), before)


class SpeedError(ProgramTest):
    @is_long  # What it computes, by another clock: Results of unit.study.
    def test_scenarios_are_studied_too_and_drawn(self):
        self.write("mine.json", fling(name="mine", events=[{"step": 100, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -900}}]))
        document = self.expect(AGREED, "study", "speed-error", "mine.json", "--quick", "--gate", "--json").json
        self.assertIn("mine", {answer["problem"] for answer in document["cheapest"]})
        self.assertEqual([name for name in self.names() if name.endswith(".svg")],
                         [f"speed-error{part}.svg" for part in ("-fling-energy", "-fling-starts", "-long-arc", "-mine-energy", "-mine-starts", "-mine", "")])
        text = (self.folder / "speed-error-long-arc.svg").read_text(encoding="utf-8")
        for part in ("Pareto front", "rk8pd", "cost, ns"):
            self.assertNotEqual(part in text, "not measured: clock unsteady" in text, part)
        self.assertEqual((document["rounds"], document["order_seed"]), (5, 1))
        self.assertLessEqual(document["ranked_pairs"], document["pairs"])
        self.assertLessEqual(document["pairs"] * 2 ** (1 - document["processes"]), 0.05)
        self.assertGreater(document["pairs"] * 2 ** (2 - document["processes"]), 0.05, "no more processes than that takes")

    def test_a_process_measures_costs_for_the_one_that_started_it(self):
        arguments = ("study", "speed-error", "--quick", "--costs-of-process")
        times, = self.expect(AGREED, *arguments, "0").out.splitlines()
        self.assertGreater(len(times.split()), 200, "the clock, and a time of each work")
        self.assertTrue(all(float(time) >= 0 or math.isnan(float(time)) for time in times.split()))
        self.assertEqual(self.names(), [], "writes no file")
        self.expect(BAD_INPUT, *arguments, "1001", says="--costs-of-process: must be a whole number 0 .. 1000 (found 1001)")
        self.assertNotIn("--costs-of-process", self.expect(AGREED, "study", "--help").out)


class FrameRate(ProgramTest):
    def test_how_far_a_scenario_moves_at_another_rate_is_what_diff_says_of_its_two_runs(self):
        self.write("own.json", fling(name="own", steps=300, events=[{"step": 100, "place": {"x_px": 900, "y_px": 100}}, {"at_s": 3, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -900}}]))
        document = self.expect(AGREED, "study", "frame-rate", "own.json", "--quick", "--no-figures", "--json").json
        self.assertEqual({row["rate_hz"]: row["from_own_px"] for row in document["rates"]}[60], 0)
        self.expect(AGREED, "run", "own.json", "-o", "60.h5")
        self.expect(AGREED, "run", "own.json", "--set", "/clock/rate_hz=144", "--set", "/steps=720", "--set", "/events/0/step=240", "-o", "144.h5")
        distance = self.expect(DISAGREED, "diff", "60.h5", "144.h5", "--json").json["max_px"]
        self.assertGreater(distance, 20)
        self.assertEqual({row["rate_hz"]: row["from_own_px"] for row in document["rates"]}[144], distance)
        self.assertRegex(document["answer"], rf"^From the run at its own clock, 144 Hz is up to {distance:.3g} px away")

    def test_a_scenario_in_which_no_time_passes_is_left_out(self):
        self.write("timeless.json", fling(name="timeless", clock={"dt_s": 0}, steps=10**12))
        self.expect(BAD_INPUT, "study", "frame-rate", "timeless.json", says="timeless: left out, as no time passes in it")
        self.write("own.json", fling(name="own"))
        self.assertIn("\ntimeless: left out, as no time passes in it.\n", self.expect(AGREED, "study", "frame-rate", "timeless.json", "own.json", "--quick").out)


class HardCases(ProgramTest):
    """Of scenarios of the project and of the user's own."""

    def study(self, exit_code, *arguments, **options):
        """Runs the study without figures; its output goes into out/."""
        return self.expect(exit_code, "study", "hard-cases", "--quick", "--no-figures", "-o", "out", *arguments, **options)

    def test_a_failed_expectation_breaks_it_and_only_the_gate_changes_the_exit_code(self):
        self.write("calm.json", {**CALM, "expect": {"final_y_px": [0, 1]}})
        self.study(AGREED, "calm.json")
        self.study(DISAGREED, "calm.json", "--gate", says="calm: expectations: final_y_px: wanted 0 .. 1")

    def test_long_cases_are_left_out_of_the_quick_study(self):
        document = self.study(AGREED, HARD / "a-fling-a-minute.json", "--json").json
        self.assertEqual([case["case"] for case in document["cases"]], ["a-fling-a-minute", "a-fling-a-minute/an-hour", *(f"a-fling-a-minute/lossless-{fling}-{rate_hz}-hz" for fling in range(1, 11) for rate_hz in (24, 60, 144, 240))])

    def test_in_a_checkout_version_control_ignores_them(self):
        ignored = (SOURCE / ".gitignore").read_text(encoding="utf-8").split()
        for suffix in (".csv", ".h5", ".svg", ".html"):
            self.assertIn("/*" + suffix, ignored)
