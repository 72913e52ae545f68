"""`run`: the files it writes, their paths, and memory. The second program has its numbers, outputs.md what it prints."""

import os
import re

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, SOURCE, ProgramTest, fling, is_long

MEBIBYTE = 2**20


class Memory(ProgramTest):
    """Memory does not grow with the size of the output."""

    @is_long
    def test_a_million_contacts_in_a_billion_steps_take_little(self):
        # Wider than its window, the sprite is clamped by a side wall in every step.
        path = self.write("scenarios/tight.json", fling(window={"width_px": 100, "height_px": 1080}, steps=10**9, record={"every": 10**6}))
        self.expect_below(50e6, AGREED, "run", path, "-o", "tight.h5")
        self.expect_below(100e6, AGREED, "bless", "scenarios", "--reason", "x")
        self.expect_below(100e6, AGREED, "check")
        for name in ("tight.h5", "golden/tight.h5"):
            with h5py.File(self.folder / name) as file:
                self.assertEqual(len(file["contacts/step"]), 1_000_000)
                wall, first, last = (file[f"contacts/{column}"][:1000] for column in ("wall", "step", "last_step"))
            self.assertEqual(last[wall == 8][-1], 10**9)
            self.assertTrue((last[wall != 8] == first[wall != 8]).all())

    def test_a_trace_takes_memory_in_proportion_to_its_text(self):
        path = self.write("trace.json", fling(clock={"dt_s": [0] * 1_000_000}, steps=None))
        size = (self.folder / path).stat().st_size
        self.expect_below(20 * MEBIBYTE + 25 * size, AGREED, "validate", path)


class StandardOutput(ProgramTest):
    """`-o -` writes CSV there, and nothing else."""

    def test_it_is_the_csv_file(self):
        self.write("fling.json", fling(expect={"finite": True}))
        self.expect(AGREED, "run", "fling.json", "-o", "fling.csv")
        rows = (self.folder / "fling.csv").read_text()
        for name in ("-", "/dev/stdout"):
            outcome = self.expect(AGREED, "run", "fling.json", "-o", name, "--figure", "fling.svg")
            self.assertEqual((outcome.out, outcome.err), (rows, "fling: agreed\n"))
        for steps in (300, 3):  # More than fits a buffer, and less.
            with open("/dev/full", "wb") as full:
                outcome = self.expect(CANNOT_ACCESS, "run", "fling.json", "--set", f"/steps={steps}", "-o", "-", stdout=full)
            self.assertEqual(outcome.err, "hyrax-sim: standard output cannot be written\n")
        self.assertEqual(self.names(), ["fling.csv", "fling.json", "fling.svg"])


class Output(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("in/fling.json", fling())
        self.write("in/other.json", fling(name="other"))

    def test_a_figure_of_several_is_a_sheet_of_all_with_those_that_fail(self):
        self.write("in/half.json", "{")
        self.write("in/low.json", fling(name="low", expect={"contacts": {"top": 1}}))
        runs = self.expect(BAD_INPUT, "run", "in", "-o", "out", "--figure", "sheet.svg", "--json").json["runs"]
        self.assertEqual([run["status"] for run in runs], ["played", "failed", "disagreed", "played"])
        wide = (self.folder / "sheet.svg").read_text().split('<svg class="narrow"')[0]
        self.assertEqual(re.findall(r"<text [^>]*>([^<]*)", wide), ["4 scenarios: 1 disagreed, 1 failed, 2 played", "half", "✗ failed",
                                                                    "low", "✗ disagreed", "fling", "– played", "other", "– played"])
        self.assertEqual(wide.count("<title>window<"), 3)

    def test_it_is_a_file_or_a_folder(self):
        self.write("some-file.json", fling(name="its-name"))
        self.write("no-name.json", fling(name=None))
        (self.folder / "there").mkdir()
        for arguments, written in ((("some-file.json", "no-name.json"), ("its-name.h5", "no-name.h5")),
                                   (("in/fling.json", "-o", "here.h5"), ("here.h5",)),
                                   (("in/fling.json", "--output", "in/there.h5"), ("in/there.h5",)),
                                   (("in/fling.json", "-o", "there"), ("there/fling.h5",)),
                                   (("in/fling.json", "-o", "new/deep/"), ("new/deep/fling.h5",)),
                                   (("in/fling.json", "in/other.json", "-o", "out"), ("out/fling.h5", "out/other.h5"))):
            before = set(self.state_of("."))
            self.expect(AGREED, "run", *arguments)
            self.assertEqual(set(self.state_of(".")) - before, {str(self.folder / path) for path in written})


class Options(ProgramTest):
    def test_an_override_names_the_file_which_holds_the_scenario_with_it(self):
        """Which ones are possible, a unit test of scenario files shows."""
        self.write("fling.json", fling())
        run, = self.expect(AGREED, "run", "fling.json", "--json", "--set", "/clock/rate_hz=144",
                           "--set", "/name=somewhere-else", "--set", '/events=[{"step": 3, "hitch": {"dt_s": 0.5}}]',
                           "--set", '/events/-={"step": 9, "stop": {}}').json["runs"]
        self.assertEqual(run["output"], "somewhere-else.h5")
        with h5py.File(self.folder / "somewhere-else.h5") as file:
            self.assertEqual(list(file["events/frame"]), [3, 9])
            self.write("stored.json", file.attrs["scenario"])
        again = self.expect(AGREED, "run", "stored.json", "--json").json["runs"][0]
        self.assertEqual(again["state_hash"], run["state_hash"])

    def test_skipping_repetition_changes_nothing(self):
        self.write("soak.json", fling(name="soak", steps=120_000, record={"every": 777}))
        skipped = self.expect(AGREED, "run", "soak.json", "--json", "-o", "skipped.h5").json["runs"][0]
        computed = self.expect(AGREED, "run", "soak.json", "--json", "-o", "all.h5", "--no-skip").json["runs"][0]
        self.assertIsNotNone(skipped["periodic_from_step"])
        self.assertIn("of 120000 steps", skipped["not_computed"][0])
        self.assertNotIn("of 120000 steps", computed["not_computed"][0])
        for key in computed.keys() - {"output", "periodic_from_step", "not_computed"}:
            self.assertEqual(skipped[key], computed[key], key)
        self.assertEqual((self.folder / "skipped.h5").read_bytes(), (self.folder / "all.h5").read_bytes())


class Bounces(ProgramTest):
    """Bounces and resting contact apart: in text, JSON, and the statistics of drift."""

    def test_of_a_run_on_uneven_frames_those_at_rest_are_no_bounces(self):
        path = SOURCE / "scenarios/clocks/missed-frames-ten-minutes.json"
        run = self.expect(AGREED, "run", path, "--json").json["runs"][0]
        self.assertEqual((run["contacts"]["ground"], run["bounces"], run["resting_contact_from_step"]),
                         (1166, {"left": 0, "right": 1, "top": 0, "ground": 5}, 240))
        self.assertIn("  contacts       right 1, ground 5 bounces, then resting contact from row 240\n", self.expect(AGREED, "run", path).out)
        restitution = self.expect(AGREED, "drift", path, "--reference", "closed", "--json").json["runs"][0]["effective_restitution"]
        self.assertEqual((restitution["contacts"], round(restitution["smallest"], 3), round(restitution["largest"], 3)), (6, 0.52, 0.6))

    def test_each_stretch_between_events_is_judged_by_itself(self):
        rest = {"x_px": 300, "y_px": 952}
        for events, bounces, text in (
                ([{"step": 30, "hitch": {"dt_s": 0.02}}], 0, "ground in resting contact from row 31"),  # It goes on.
                ([{"step": 30, "fling": {"vx_px_per_s": 0, "vy_px_per_s": -600}}], 0, "ground 0 bounces and 1 resting contact"),
                ([{"step": 30, "fling": {"vx_px_per_s": 0, "vy_px_per_s": -200}}], 2, "ground 2 bounces, then resting contact from row")):
            path = self.write("rest.json", fling(start=rest, steps=70 if bounces == 0 else 200, events=events))
            run = self.expect(AGREED, "run", path, "--json").json["runs"][0]
            self.assertIn(text, self.expect(AGREED, "run", path).out)
            self.assertEqual(run["bounces"]["ground"], bounces, events)


class Golden(ProgramTest):
    """`run` compares with the golden file if there is one."""

    def setUp(self):
        super().setUp()
        self.path, = self.project("fling")

    def test_where_it_is_missing_nothing_agreed(self):
        for expect in (None, {"in_bounds": True}):
            path = self.write("scenarios/alone.json", fling(name="alone", expect=expect))
            run, = self.expect(AGREED, "run", path, "--json").json["runs"]
            self.assertEqual((run["status"], run["golden"]["status"]), ("played", "missing"))
            self.assertEqual(self.expect(AGREED, "run", path, "-q").out, "alone: played: golden file missing; written: alone.h5\n")

    def test_a_difference_is_exit_1_and_the_output_is_written_all_the_same(self):
        self.write(self.path, fling(start={"x_px": 101, "y_px": 100}))
        run = self.expect(DISAGREED, "run", self.path, "--json").json["runs"][0]
        self.assertIn("fling.h5", self.names())
        self.assertEqual((list(run["golden"]), run["golden"]["first_divergence"]["field"]),
                         (["file", "status", "class", "max_px", "contacts_moved", "first_divergence"], "x"))
        self.assertEqual((run["status"], run["golden"]["class"]), ("disagreed", "shape"))

    def test_with_a_damaged_golden_file_nothing_is_written(self):
        os.truncate(self.folder / "golden/fling.h5", 5000)
        self.expect(BAD_INPUT, "run", self.path, says="golden/fling.h5: ")
        self.assertEqual(self.names(), ["golden", "scenarios"])
