#!/usr/bin/python3
"""The command study: the files, output and errors of speed-error and needs."""

import csv
import math
import pathlib
import xml.etree.ElementTree

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, NUMBER, SOURCE, ProgramTest, fling, main



class StudyTest(ProgramTest):
    """Runs studies, and reads the files they write."""

    def table(self, path, name):
        """A table of a study's HDF5 file as {column: list}, text decoded."""
        with h5py.File(self.folder / path) as file:
            return {key: [value.decode() if isinstance(value, bytes) else value for value in column[:].tolist()]
                    for key, column in file[name].items()}

    def rows(self, path):
        """The rows of a CSV file."""
        with open(self.folder / path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def text_of(self, path):
        """All text of a picture."""
        tree = xml.etree.ElementTree.parse(self.folder / path)
        return " ".join("".join(text.itertext()) for text in tree.iter("{http://www.w3.org/2000/svg}text"))


class Files(StudyTest):
    """The files of every study."""

    def setUp(self):
        super().setUp()
        self.write("fling.json", fling())
        self.outcome = self.expect(AGREED, "study", "needs", "fling.json", "--quick", "--no-figures", "-o", "new/folder")

    def test_they_go_into_the_folder_that_is_named_and_are_named_in_the_end(self):
        self.assertEqual(self.names("new/folder"), ["needs.csv", "needs.h5"])
        self.assertIn("written: new/folder/needs.h5, new/folder/needs.csv", self.outcome.out)

    def test_in_a_checkout_version_control_ignores_them(self):
        ignored = (SOURCE / ".gitignore").read_text(encoding="utf-8").split()
        for suffix in (".csv", ".h5", ".svg", ".html"):
            self.assertIn("/*" + suffix, ignored)

    def test_the_file_says_what_it_is_and_where_it_is_from(self):
        with h5py.File(self.folder / "new/folder/needs.h5") as file:
            self.assertEqual(file.attrs["format"], "hyrax-study/1")
            self.assertEqual(file.attrs["study"], "needs")
            self.assertIn("hyrax-sim", file["provenance"].attrs["program"])
            for name, table in file.items():
                lengths = {len(column) for column in table.values()}
                self.assertLessEqual(len(lengths), 1, name)
                for column in table.values():
                    self.assertTrue(column.attrs["long_name"])

    def test_the_csv_file_is_the_first_table(self):
        rows = self.rows("new/folder/needs.csv")
        parts = self.table("new/folder/needs.h5", "parts")
        self.assertEqual([row["part"] for row in rows], parts["part"])
        self.assertEqual([float(row["path_difference_px"]) for row in rows], parts["path_difference"])

    def test_json_is_one_document_that_names_them(self):
        document = self.expect(AGREED, "study", "needs", "fling.json", "--quick", "--no-figures", "--json").json
        self.assertEqual(document["study"], "needs")
        self.assertEqual(document["files"], ["needs.h5", "needs.csv"])
        self.assertEqual(document["broken"], [])


class Needs(StudyTest):
    """study needs."""

    def needs(self, *arguments):
        """One scene's entry of the JSON document."""
        document = self.expect(AGREED, "study", "needs", *arguments, "--quick", "--no-figures", "--json").json
        return document["scenes"][0]

    def verdicts(self, *arguments):
        """{part: verdict} of one scene."""
        return {part["part"]: part["verdict"] for part in self.needs(*arguments)["parts"]}

    def test_a_throw_needs_what_it_meets(self):
        verdicts = self.verdicts(self.write("fling.json", fling()))
        for part in ("gravity", "drag", "right wall", "ground", "restitution"):
            self.assertEqual(verdicts[part], "needed", part)
        for part in ("left wall", "top"):
            self.assertEqual(verdicts[part], "not exercised", part)

    def test_it_counts_the_paths_of_the_step(self):
        self.write("still.json", fling(name="still", steps=0))
        document = self.expect(AGREED, "study", "needs", self.write("fling.json", fling()), "still.json", "--quick",
                               "--no-figures", "--json").json
        self.assertEqual([scene["paths_taken"] for scene in document["scenes"]][1], 0)
        self.assertGreaterEqual(document["scenes"][0]["paths_taken"], 3)
        self.assertEqual(document["paths_taken"], document["scenes"][0]["paths_taken"])
        self.assertEqual(document["paths"], 12)

    def test_what_counts_depends_on_the_tolerance(self):
        path = self.write("fling.json", fling())
        self.assertEqual(self.verdicts(path, "--within", "100000px")["drag"], "below the tolerance")
        self.assertEqual(self.verdicts(path, "--within", "0.001 px")["drag"], "needed")

    def test_events_and_jitter_are_parts(self):
        verdicts = self.verdicts(SOURCE / "scenarios/flings/corner-fling.json")
        for part in ("jitter", "fling, frame 120", "hitch, frame 200", "hold, frame 300", "resize, frame 400"):
            self.assertEqual(verdicts[part], "needed", part)

    def test_all_unneeded_parts_can_go_at_once_and_the_cheapest_method_is_reported(self):
        scene = self.needs(self.write("fling.json", fling()))
        self.assertLessEqual(scene["without_all_unneeded_px"], 1.0)
        if scene["cheapest"] is not None:  # The clock was steady.
            self.assert_shape(scene["cheapest"], {"method": str, "rate_hz": NUMBER, "cost_ns_per_s": NUMBER})

    def test_a_scene_without_exact_solution_says_so(self):
        path = SOURCE / "scenarios/hard/sprite-larger-than-window.json"
        self.assertIn("its window cannot hold its sprite",
                      self.expect(AGREED, "study", "needs", path, "--quick", "--no-figures").out)

    def test_a_scene_without_frames_needs_nothing(self):
        self.assertEqual(set(self.verdicts(self.write("still.json", fling(steps=0))).values()), {"not exercised"})

    def test_many_scenes_make_a_coverage_table_that_shows_gaps(self):
        start = {"x_px": 900, "y_px": 300, "vx_px_per_s": 0, "vy_px_per_s": 0}
        for number in range(5):
            self.write(f"all/{number}.json", fling(name=f"drop-{number}", start=start, steps=100 + number))
        outcome = self.expect(AGREED, "study", "needs", "all", "--quick", "--gate", "--no-figures")
        self.assertIn("Exercised by no scenario: left wall, right wall, top, friction, rest rule, jitter", outcome.out)
        coverage = self.table("needs.h5", "coverage")
        self.assertEqual(coverage["gravity"], [2] * 5)
        self.assertEqual(coverage["left_wall"], [0] * 5)


class SpeedError(StudyTest):
    """study speed-error."""

    def test_it_holds_and_prints_cost_error_and_order(self):
        outcome = self.expect(AGREED, "study", "speed-error", "--quick", "--gate", "--no-figures")
        for text in ("the paper's step", "explicit Euler", "keeps the paper's step from converging",
                     "error is 9.85 px at 60 Hz"):
            self.assertIn(text, outcome.out)
        points = self.table("speed-error.h5", "points")
        self.assertIn("gsl-rk8pd-1e-12", points["method"])
        self.assertEqual(set(points["problem"]), {"long-arc", "fling"})
        clock = self.table("speed-error.h5", "clock")
        self.assertGreaterEqual(clock["repetitions"][0], 20)
        self.costs_are_measured_if_the_clock_is_steady(clock["steady"][0], points)
        for text, is_said in (("for an error below", clock["steady"][0]), ("at no rate", clock["steady"][0]),
                              ("costs are not measured: clock unsteady", not clock["steady"][0])):
            self.assertEqual(text in outcome.out, bool(is_said), outcome.out)
        bands = self.table("speed-error.h5", "bands")
        self.assertEqual((set(bands["flings"]), set(bands["seed"]), set(bands["rate"])), ({120}, {13}, {60.0}))
        exact = bands["method"].index("exact-flight")
        self.assertIn(f"in {bands['nearer'][exact]} of 120 flings", outcome.out)
        orders = self.table("speed-error.h5", "orders")
        order = {method: value for problem, method, value in zip(orders["problem"], orders["method"], orders["order"])
                 if problem == "long-arc"}
        self.assertAlmostEqual(order["euler"], 1, delta=0.1)
        self.assertAlmostEqual(order["verlet"], 2, delta=0.1)
        self.assertAlmostEqual(order["rk4"], 4, delta=0.1)
        self.assertLess(order["paper"], 0)

    def costs_are_measured_if_the_clock_is_steady(self, is_steady, points):
        """All or none has a cost, and what is ranked gives 60 rows a second."""
        costs = [cost for cost, failed in zip(points["cost"], points["failed"], strict=True) if not failed]
        if not is_steady:  # As a machine's that does other things.
            self.assertTrue(all(math.isnan(cost) for cost in costs))
            self.assertEqual(sum(points["ranked"]), 0)
            return
        self.assertTrue(all(cost > 0 for cost in costs))
        self.assertGreater(sum(points["pareto"]), 1)
        self.assertEqual({rate >= 60 and method != "event-driven" for rate, method, ranked
                          in zip(points["rate"], points["method"], points["ranked"], strict=True) if ranked}, {True})

    def test_scenarios_are_studied_too(self):
        self.write("mine.json", fling(name="mine", events=[{"step": 100, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -900}}]))
        document = self.expect(AGREED, "study", "speed-error", "mine.json", "--quick", "--no-figures", "--json").json
        self.assertIn("mine", {answer["problem"] for answer in document["cheapest"]})

    def test_one_that_has_no_exact_solution_is_refused(self):
        self.write("large.json", fling(sprite={"width_px": 4000, "height_px": 128}))
        self.expect(BAD_INPUT, "study", "speed-error", "large.json", "--quick",
                    says="large.json: cannot be studied for speed against error: its window cannot hold its sprite")
        self.assertEqual(self.names(), ["large.json"])

    def test_a_name_that_is_taken_is_refused(self):
        self.write("mine.json", fling())
        self.expect(BAD_INPUT, "study", "speed-error", "mine.json", "--quick", says="must differ from the other problems' (found fling)")


class Figures(StudyTest):
    """The pictures."""

    def test_needs_are_drawn_scene_by_scene(self):
        self.expect(AGREED, "study", "needs", self.write("fling.json", fling()), "--quick")
        text = self.text_of("needs-fling.svg")
        for part in ("What fling needs", "gravity", "rest rule", "not exercised", "px"):
            self.assertIn(part, text)

    def test_many_scenes_are_one_picture(self):
        for number in range(5):
            self.write(f"all/{number}.json", fling(name=f"fling-{number}", steps=10 + number))
        self.expect(AGREED, "study", "needs", "all", "--quick", "-o", "out")
        self.assertEqual(self.names("out"), ["needs.csv", "needs.h5", "needs.svg"])
        self.assertIn("left wall (never)", self.text_of("out/needs.svg"))

    def test_speed_against_error_is_drawn_for_every_problem(self):
        self.expect(AGREED, "study", "speed-error", "--quick")
        self.assertEqual([name for name in self.names() if name.endswith(".svg")],
                         ["speed-error-fling-starts.svg", "speed-error-long-arc.svg", "speed-error.svg"])
        self.assertIn("a fling that bounces until it settles", self.text_of("speed-error.svg"))
        self.assertIn("ends nearer in", self.text_of("speed-error-fling-starts.svg"))
        text = self.text_of("speed-error-long-arc.svg")
        for part in ("dt, s", "order 2.00", "from converging"):
            self.assertIn(part, text)
        for part in ("Pareto front", "rk8pd", "cost, ns"):
            self.assertNotEqual(part in text, "not measured: clock unsteady" in text, part)


class Usage(StudyTest):
    """Bad usage is refused before anything is written."""

    def test_an_unknown_study_lists_the_known_ones(self):
        self.expect(BAD_INPUT, "study", "speed", says=("unknown study (found speed)", "speed-error", "needs"))
        self.expect(BAD_INPUT, "study", says="study")

    def test_options_without_use_are_refused(self):
        self.write("fling.json", fling())
        for arguments, words in ((("speed-error", "--within", "1px"), "speed-error: takes no --within"),
                                 (("speed-error", "--expect", "x.json"), "speed-error: takes no --expect"),
                                 (("needs",), "a scenario must be given"),
                                 (("needs", "fling.json", "--within", "1 mm"), "--within: must be a length of at least 0, "
                                                                               "as 1px (found '1 mm')"),
                                 (("needs", "fling.json", "--within=-1px"), "--within"),
                                 (("needs", "fling.json", "--within", "nan"), "--within"),
                                 (("needs", "fling.json", "fling.json"), "fling.json: /name: duplicate scenario name (found fling)")):
            self.expect(BAD_INPUT, "study", *arguments, says=words)
        self.assertEqual(self.names(), ["fling.json"])

    def test_bad_scenarios_leave_nothing_behind(self):
        self.write("bad.json", fling(steps=-1))
        self.expect(BAD_INPUT, "study", "needs", "bad.json", "-o", "out", says="bad.json: /steps")
        self.expect(CANNOT_ACCESS, "study", "needs", "none.json", says="none.json: cannot be read")
        self.assertEqual(self.names(), ["bad.json"])

    def test_a_folder_that_cannot_be_created_is_reported(self):
        self.write("fling.json", fling())
        self.expect(CANNOT_ACCESS, "study", "needs", "fling.json", "--quick", "--no-figures", "-o", "fling.json",
                    says="fling.json: ")
        self.assertEqual(pathlib.Path(self.folder / "fling.json").stat().st_nlink, 1)

    def test_the_first_help_screen_lists_it_and_its_help_names_the_studies(self):
        common, _ = self.expect(AGREED, "--help").out.split("\nMore:\n")
        self.assertIn("\n  study ", common)
        text = self.expect(AGREED, "study", "--help").out
        for name in ("speed-error", "needs", "--quick", "--gate", "--within", "--no-figures"):
            self.assertIn(name, text)


if __name__ == "__main__":
    main()
