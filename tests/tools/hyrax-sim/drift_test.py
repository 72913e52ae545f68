#!/usr/bin/python3
"""`drift` and `run --drift`: what is measured, how it is told, stored and drawn, and how it ends."""

import fractions
import itertools
import json
import math
import xml.etree.ElementTree

import h5py
import numpy

from program import (AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, NUMBER, SOURCE, Maybe, ProgramTest, fling, main)

ARC = {
    "first_step": int, "last_step": int, "duration_s": NUMBER, "ended_by": str, "implementation_px": NUMBER,
    "truncation_px": NUMBER, "model_px": NUMBER, "energy_drift_rel_max": Maybe(NUMBER),
    "energy_drift_rel_end": Maybe(NUMBER), "energy_drift_slope_per_s": Maybe(NUMBER),
    "gsl_vs_closed_px": Maybe(NUMBER),
}
CONTACT = {
    "step": int, "wall": str, "time_error_s": Maybe(NUMBER), "overshoot_px": NUMBER, "energy_jump_rel": Maybe(NUMBER),
    "effective_restitution": Maybe(NUMBER),
}
WIDTH_MAX = 100


def flight(rate_hz, steps=None, **changes):
    """A second of flight from vy = -900 px/s that meets nothing."""
    return fling(window={"width_px": 100000, "height_px": 100000},
                 start={"x_px": 4000, "y_px": 50000, "vx_px_per_s": 0, "vy_px_per_s": -900},
                 clock={"rate_hz": rate_hz}, steps=steps or rate_hz, **changes)


class DriftTest(ProgramTest):
    """What is asked again and again."""

    def drift(self, *arguments):
        """The measured runs, as JSON."""
        return self.expect(AGREED, "drift", *arguments, "--json").json["runs"]

    def drift_of(self, document, *arguments):
        """The one measured run of a document."""
        return self.drift(self.write("scenario.json", document), *arguments)[0]

    def errors(self, run):
        """What does not depend on the machine's speed."""
        return {key: run[key] for key in ("arcs", "contacts", "skipped_arcs", "worst", "effective_restitution",
                                          "margin", "steps_astray")}


class Errors(DriftTest):
    """The numbers."""

    def test_the_document_has_the_published_keys_and_types(self):
        run = self.drift_of(fling())
        self.assertEqual(run["scenario"], "scenario.json")
        self.assertGreater(len(run["arcs"]), 3)
        self.assert_shape(run["arcs"], [ARC])
        self.assert_shape(run["contacts"], [CONTACT])
        self.assertIsInstance(run["skipped_arcs"], int)
        for key in ("implementation_px", "truncation_px", "model_px", "energy_drift_rel_max", "gsl_vs_closed_px"):
            self.assertEqual(run["worst"][key], max(arc[key] for arc in run["arcs"]))

    def test_a_second_of_flight_errs_as_the_order_of_the_step_says(self):
        for rate_hz, truncation_px, model_px in ((30, 19.84, None), (60, 9.84, 9.84), (120, 4.84, None),
                                                 (240, 2.34, 42.3), (480, 1.09, None), (1920, None, 232.7)):
            arc, = self.drift_of(flight(rate_hz), "--reference", "closed")["arcs"]
            self.assertLess(arc["implementation_px"], 1e-8)
            if truncation_px:
                self.assertAlmostEqual(arc["truncation_px"], truncation_px, delta=0.005)
            if model_px:
                self.assertAlmostEqual(arc["model_px"], model_px, delta=0.05)

    def test_arcs_end_where_the_scenario_says(self):
        events = [{"step": 20, "fling": {"vx_px_per_s": 0, "vy_px_per_s": -500}}, {"step": 30, "grab": {}},
                  {"step": 35, "release": {"vx_px_per_s": 100, "vy_px_per_s": 0}},
                  {"step": 40, "hitch": {"dt_s": 0.1}}]
        run = self.drift_of(flight(60, events=events))
        self.assertEqual([(arc["first_step"], arc["last_step"], arc["ended_by"]) for arc in run["arcs"]],
                         [(0, 20, "input"), (20, 30, "hold"), (35, 60, "end")])

    def test_gsl_agrees_with_the_closed_form_within_the_bound(self):
        for arc in self.drift_of(fling())["arcs"]:
            self.assertLess(arc["gsl_vs_closed_px"], 1e-9)

    def test_a_coarser_stepper_is_told_but_judges_nothing(self):
        run = self.drift_of(fling(), "--stepper", "msbdf", "--tolerance", 1e-3)
        self.assertGreater(run["worst"]["gsl_vs_closed_px"], 1e-9)

    def test_without_gsl_its_distance_is_null(self):
        run = self.drift_of(fling(), "--reference", "closed")
        self.assertEqual({arc["gsl_vs_closed_px"] for arc in run["arcs"]}, {None})
        self.assertIsNone(run["worst"]["gsl_vs_closed_px"])

    def test_a_long_rest_is_counted_without_being_played(self):
        steps = 400_000
        self.expect(AGREED, "run", self.write("long.json", fling(name="long", steps=steps)))
        live, stored = self.drift("long.json", "long.h5", "--reference", "closed")
        self.assertEqual(self.errors(live), self.errors(stored))
        endless = self.drift_of(fling(name="endless", steps=1e12), "--reference", "closed")
        self.assertGreater(endless["skipped_arcs"], 999_999_000_000)
        self.assertEqual(endless["arcs"], live["arcs"])


class Files(DriftTest):
    """Trajectories instead of scenarios."""

    def test_a_file_with_every_row_is_measured_as_its_scenario_is(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()))
        live, stored = self.drift("fling.json", "fling.h5")
        self.assertEqual(self.errors(live), self.errors(stored))

    def test_a_decimated_file_is_replayed_from_its_scenario(self):
        self.expect(AGREED, "run", self.write("fling.json", fling(record={"every": 7})))
        live, stored = self.drift("fling.json", "fling.h5")
        self.assertEqual(self.errors(live), self.errors(stored))
        text = self.expect(AGREED, "drift", "fling.h5").out
        self.assertIn("replayed from its scenario, since it holds 44 of 301 rows", text)

    def test_golden_files_are_measured_short_or_long(self):
        for name in ("flings/first-fling", "clocks/hour-at-60-hz"):
            live, stored = self.drift(SOURCE / f"scenarios/{name}.json", SOURCE / f"golden/{name}.h5")
            self.assertEqual(self.errors(live), self.errors(stored))

    def test_a_row_that_is_not_finite_ends_the_measuring(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()))
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file["trajectory/y"][50] = math.nan
        outcome = self.expect(DISAGREED, "drift", "fling.h5")
        self.assertIn("NOT FINITE   from row 50", outcome.out)
        self.assertEqual(self.expect(DISAGREED, "drift", "fling.h5", "--json").json["runs"][0]["non_finite_step"], 50)

    def test_rows_that_do_not_count_up_are_refused(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()))
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file["trajectory/step"][50] = 7
        self.expect(BAD_INPUT, "drift", "fling.h5", says="/trajectory/step: holds 7 where row 50 belongs")

    def test_each_run_stands_alone(self):
        self.write("good.json", fling())
        outcome = self.expect(CANNOT_ACCESS, "drift", "none.json", "good.json", "none.h5", "--json",
                              says=("none.json", "none.h5"))
        none, good, _ = outcome.json["runs"]
        self.assertEqual(none["status"], "failed")
        self.assertIn("arcs", good)


class WrongCores(DriftTest):
    """Controls: rows of another step in the place of the core's."""

    def measured(self, step):
        """The flight's rows by another step, measured."""
        document = flight(144, 600)
        document["start"] |= {"vx_px_per_s": 407}
        self.expect(AGREED, "run", self.write("flight.json", document), "-o", "flight.h5")
        state = (4000.0, 50000.0, 407.0, -900.0)
        with h5py.File(self.folder / "flight.h5", "r+") as file:
            for row, dt_s in enumerate(file["trajectory/dt"][1:], 1):
                state = step(*state, float(dt_s))
                for name, value in zip(("x", "y", "vx", "vy"), state):
                    file[f"trajectory/{name}"][row] = value
        return self.drift("flight.h5")[0]

    def test_the_papers_step_is_not_astray(self):
        def paper(x, y, vx, vy, dt):
            vy = (vy + 1200.0 * dt) * 0.999
            vx = vx * 0.999
            return x + vx * dt, y + vy * dt, vx, vy
        run = self.measured(paper)
        self.assertEqual(run["steps_astray"], 0)
        self.assertLess(run["worst"]["implementation_px"], 1e-8)

    def test_drag_before_gravity_is_seen(self):
        def drag_first(x, y, vx, vy, dt):
            vy = vy * 0.999 + 1200.0 * dt
            vx = vx * 0.999
            return x + vx * dt, y + vy * dt, vx, vy
        run = self.measured(drag_first)
        self.assertGreater(run["steps_astray"], 500)
        self.assertGreater(run["worst"]["implementation_px"], 1e-3)

    def test_a_fused_operation_is_seen(self):
        def fused(x, y, vx, vy, dt):
            vy = float(fractions.Fraction(vy) + 1200 * fractions.Fraction(dt)) * 0.999
            vx = vx * 0.999
            return x + vx * dt, y + vy * dt, vx, vy
        self.assertGreater(self.measured(fused)["steps_astray"], 0)
        self.assertIn("ASTRAY", self.expect(AGREED, "drift", "flight.h5").out)


class Table(DriftTest):
    """What stands on a terminal."""

    def table_of(self, document, *arguments):
        return self.expect(AGREED, "drift", self.write("scenario.json", document), *arguments).out

    def test_it_lists_arcs_contacts_margin_and_ends_with_speed_against_error(self):
        table = self.table_of(fling())
        for words in ("fling: 300 steps, 5 s at 60 Hz", "closed form, checked by GSL rk8pd at 1e-12", "  worst",
                      "restitution  0.", "the paper's is 0.6", "  any start within ±",
                      "keeps all contacts; nearest decision:", "  left out     "):
            self.assertIn(words, table)
        last = table.splitlines()[-1]
        self.assertRegex(last, r"this machine \S+ ns a step, truncation \S+ px, drift \S+ %/s; "
                               r"half dt: \S+ ns, \S+ px, \S+ %/s")

    def test_long_lists_are_cut(self):
        events = [{"step": step, "fling": {"vx_px_per_s": 10, "vy_px_per_s": -100}} for step in range(5, 300, 5)]
        table = self.table_of(flight(60, 300, events=events))
        self.assertIn("  ... 40 more; --json lists them", table)
        self.assertLess(len(table.splitlines()), 32)

    def test_it_says_what_was_left_out(self):
        table = self.table_of(flight(60), "--reference", "closed")
        for words in ("x in 1 arc without horizontal motion", "GSL (--reference gsl)", "errors of every row (--rows)"):
            self.assertIn(words, table)

    def test_it_says_that_and_why_the_step_does_not_converge(self):
        words = "paper's step does not converge"
        self.assertIn(words, self.table_of(flight(240)))
        self.assertNotIn(words, self.table_of(flight(20)))

    def test_it_says_why_half_the_frame_was_not_measured(self):
        jittered = flight(60)
        jittered["clock"]["jitter"] = {"kind": "uniform", "fraction": 0.1, "seed": 1}
        self.assertIn("; half dt unmeasured: jitter", self.table_of(jittered))

    def test_a_run_without_arcs_has_a_table_too(self):
        self.assertIn("no flight arc of two steps or more", self.table_of(fling(steps=1)))
        self.table_of(fling(steps=0))


class EveryScenario(DriftTest):
    """The project's own scenarios, hard and far-away ones included."""

    def test_none_is_a_fault_of_the_reference_and_none_is_astray(self):
        runs = self.drift(SOURCE / "scenarios")
        self.assertGreater(len(runs), 40)
        for run in runs:
            self.assertEqual((run["reference_faults"], run["steps_astray"]), (0, 0), run["scenario"])

    def test_every_table_fits_a_terminal(self):
        for line in self.expect(AGREED, "drift", SOURCE / "scenarios").out.splitlines():
            self.assertLessEqual(len(line), WIDTH_MAX, line)


class Stored(DriftTest):
    """The groups /reference and /drift."""

    def groups(self, *arguments, **changes):
        """The file of a throw, measured as it was played."""
        self.write("fling.json", fling(**changes))
        self.expect(AGREED, "run", "fling.json", "--drift", *arguments)
        return h5py.File(self.folder / "fling.h5")

    def test_without_rows_arcs_and_contacts_are_stored(self):
        with self.groups() as file:
            self.assertEqual(sorted(file["drift"]), ["arcs", "contacts"])
            self.assertEqual(sorted(file["reference"]), ["arcs"])
        self.expect(AGREED, "run", "fling.json")
        with h5py.File(self.folder / "fling.h5") as file:
            self.assertNotIn("drift", file)

    def test_arcs_and_contacts_are_those_of_the_document(self):
        run = self.drift_of(fling())
        with self.groups("--reference", "gsl") as file:
            names = {"duration_s": "duration", "implementation_px": "implementation", "truncation_px": "truncation",
                     "model_px": "model", "energy_drift_slope_per_s": "energy_drift_slope"}
            for key in ("first_step", "last_step", "energy_drift_rel_max", "energy_drift_rel_end", *names):
                stored = file[f"drift/arcs/{names.get(key, key)}"][:].tolist()
                self.assertEqual(stored, [arc[key] for arc in run["arcs"]], key)
            self.assertEqual(file["reference/arcs/gsl_vs_closed"][:].tolist(),
                             [arc["gsl_vs_closed_px"] for arc in run["arcs"]])
            ends = {code: name for name, code in h5py.check_enum_dtype(file["drift/arcs/ended_by"].dtype).items()}
            self.assertEqual([ends[code] for code in file["drift/arcs/ended_by"]],
                             [arc["ended_by"] for arc in run["arcs"]])
            for key, name in (("step", "step"), ("overshoot_px", "overshoot"), ("time_error_s", "time_error"),
                              ("effective_restitution", "effective_restitution")):
                self.assertEqual(file[f"drift/contacts/{name}"][:].tolist(),
                                 [contact[key] for contact in run["contacts"]])
            self.assertEqual(file["drift/arcs"].attrs["skipped"], run["skipped_arcs"])
            self.assertEqual(file["drift/arcs"].attrs["total"], len(run["arcs"]))
            self.assertEqual(file["reference"].attrs["checked_by"], "GSL rk8pd, tolerance 1e-12")

    def test_rows_stand_beside_the_trajectory_and_are_nan_where_nothing_flies(self):
        with self.groups("--rows") as file:
            rows = len(file["trajectory/y"])
            flies = numpy.zeros(rows, bool)
            for first, last in zip(file["drift/arcs/first_step"], file["drift/arcs/last_step"]):
                flies[first:last + 1] = True
                apart = numpy.hypot(file["trajectory/x"][first:last + 1] - file["reference/x"][first:last + 1],
                                    file["trajectory/y"][first:last + 1] - file["reference/y"][first:last + 1])
                numpy.testing.assert_allclose(file["drift/truncation"][first:last + 1], apart, atol=1e-9)
            for name in ("reference/x", "reference/energy", "drift/implementation", "drift/model", "drift/energy_drift"):
                self.assertEqual(file[name].shape, (rows,))
                numpy.testing.assert_array_equal(numpy.isnan(file[name][:]), ~flies, name)
            self.assertEqual(file["drift/t"][-1], file["trajectory/t"][-1])

    def test_of_a_decimated_run_its_recorded_rows_are_stored(self):
        with self.groups("--rows") as file:
            whole = {name: file[name][:] for name in ("drift/truncation", "reference/vy")}
        with self.groups("--rows", record={"every": 7}) as file:
            for name, values in whole.items():
                numpy.testing.assert_array_equal(file[name][:], values[file["trajectory/step"][:]])

    def test_a_row_between_two_arcs_holds_the_errors_of_the_one_it_ends(self):
        events = [{"step": 20, "fling": {"vx_px_per_s": 0, "vy_px_per_s": -500}}]
        with self.groups("--rows", events=events) as file:
            self.assertEqual(file["drift/arcs/last_step"][0], 20)
            self.assertGreater(file["drift/truncation"][20], file["drift/truncation"][19])

    def test_everything_has_a_name_and_a_unit(self):
        with self.groups("--rows") as file:
            def look(name, item):
                if isinstance(item, h5py.Dataset):
                    self.assertIn("long_name", item.attrs, name)
                    if item.dtype.kind == "f":
                        self.assertIn("units", item.attrs, name)
            file["drift"].visititems(look)
            file["reference"].visititems(look)

    def test_the_same_run_gives_the_same_bytes_by_either_command(self):
        self.write("fling.json", fling())
        for name in ("a.h5", "b.h5"):
            self.expect(AGREED, "run", "fling.json", "--drift", "--rows", "--reference", "gsl", "-o", name)
        self.expect(AGREED, "drift", "fling.json", "--rows", "-o", "c.h5")
        first, *others = [(self.folder / f"{name}.h5").read_bytes() for name in "abc"]
        for other in others:
            self.assertEqual(other, first)

    def test_a_measured_file_is_a_trajectory_like_any_other(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()), "--drift", "--rows", "-o", "measured.h5")
        self.expect(AGREED, "run", "fling.json", "-o", "plain.h5")
        self.expect(AGREED, "diff", "plain.h5", "measured.h5")


class Run(DriftTest):
    """`run --drift`."""

    def test_its_document_holds_what_drift_measures_by_the_closed_form(self):
        self.write("fling.json", fling())
        run = self.expect(AGREED, "run", "fling.json", "--drift", "--json").json["runs"][0]
        self.assertEqual(self.errors(run["drift"]), self.errors(self.drift("fling.json", "--reference", "closed")[0]))
        self.assertNotIn("reference and energy (hyrax-sim drift)", run["not_computed"])

    def test_it_prints_the_table(self):
        outcome = self.expect(AGREED, "run", self.write("fling.json", fling()), "--drift")
        self.assertIn("  any start within", outcome.out)

    def test_how_to_measure_is_refused_where_nothing_is_measured(self):
        self.write("fling.json", fling())
        for option in (("--rows",), ("--reference", "gsl"), ("--tolerance", 1e-9)):
            self.expect(BAD_INPUT, "run", "fling.json", *option, says="add --drift")
        self.assertEqual(self.names(), ["fling.json"])


class Expectations(DriftTest):
    """Bounds of errors in `expect`."""

    BOUNDS = {"implementation_px_max": 1e-9, "truncation_px_max": 10, "energy_drift_rel_max": 0.5}

    def verdicts(self, exit_code, document):
        run = self.expect(exit_code, "run", self.write("scenario.json", document), "--json").json["runs"][0]
        return {verdict["rule"]: verdict for verdict in run["expect"]}

    def test_they_are_judged_by_what_drift_measures(self):
        document = flight(60, expect=self.BOUNDS)
        verdicts = self.verdicts(AGREED, document)
        worst = self.drift_of(document)["worst"]
        for rule, verdict in verdicts.items():
            self.assertTrue(verdict["holds"])
            self.assertEqual(verdict["measured"], worst[rule.removesuffix("_max") if "px" in rule else rule])

    def test_one_that_is_exceeded_does_not_hold(self):
        verdicts = self.verdicts(DISAGREED, flight(60, expect={**self.BOUNDS, "truncation_px_max": 9.8}))
        self.assertEqual([rule for rule, verdict in verdicts.items() if not verdict["holds"]], ["truncation_px_max"])

    def test_one_of_what_is_undefined_does_not_hold(self):
        still = fling(start={"x_px": 0, "y_px": 952, "vx_px_per_s": 0, "vy_px_per_s": 0}, clock={"dt_s": 0}, steps=5,
                      expect={"energy_drift_rel_max": 1})
        self.assertEqual(self.verdicts(DISAGREED, still)["energy_drift_rel_max"],
                         {"rule": "energy_drift_rel_max", "holds": False, "measured": None})

    def test_check_and_bless_judge_them_too(self):
        good, bad = flight(60, expect=self.BOUNDS), flight(60, expect={"truncation_px_max": 9.8})
        self.write("scenarios/good.json", {**good, "name": "good"})
        self.write("scenarios/bad.json", {**bad, "name": "bad"})
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "for the test",
                    says="scenarios/bad.json: not blessed: its expectations do not hold; truncation_px_max: wanted at "
                         "most 9.8, measured 9.8")
        self.expect(AGREED, "check", "scenarios/good.json")
        self.write("scenarios/good.json", {**bad, "name": "good"})
        self.assertIn("truncation_px_max", self.expect(DISAGREED, "check", "scenarios/good.json").out)


class Margin(DriftTest):
    """How near a run is to being another one."""

    def contacts(self, shift):
        """Steps and walls of the contacts of the throw with its start moved."""
        document = fling()
        for key, by in zip(("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"), shift):
            document["start"][key] += by
        self.expect(AGREED, "run", self.write("moved.json", document), "-o", "moved.h5")
        with h5py.File(self.folder / "moved.h5") as file:
            return [file[f"contacts/{name}"][:].tolist() for name in ("step", "last_step", "wall")]

    def test_within_it_all_contacts_stay_and_past_it_one_goes(self):
        width = self.drift_of(fling())["margin"]["half_width"]
        here = self.contacts((0, 0, 0, 0))

        def corners(size):
            return [self.contacts(shift) for shift in itertools.product((-size, size), repeat=4)]
        self.assertTrue(all(contacts == here for contacts in corners(0.999 * width)))
        self.assertFalse(all(contacts == here for contacts in corners(1.001 * width)))

    def test_the_digest_says_it(self):
        self.project("one")
        digest = (self.folder / "golden/one.txt").read_text(encoding="utf-8")
        self.assertRegex(digest, r"\nmargin: any start within ±[0-9.]+ px and px/s keeps all contacts; "
                                 r"nearest decision: [a-z ]+, step [0-9]+\nreason: ")

    def test_a_knife_edge_is_told_from_a_robust_run(self):
        edge = fling(start={"x_px": 0, "y_px": 100}, steps=50)
        self.assertIn("KNIFE EDGE", self.expect(AGREED, "drift", self.write("edge.json", edge)).out)
        self.assertNotIn("KNIFE", self.expect(AGREED, "drift", self.write("fling.json", fling())).out)

    def test_bless_renews_a_digest_of_an_older_form(self):
        self.project("one")
        digest = self.folder / "golden/one.txt"
        lines = digest.read_text(encoding="utf-8").splitlines(keepends=True)
        digest.write_text("".join(line for line in lines if not line.startswith("margin: ")), encoding="utf-8")
        rows = (self.folder / "golden/one.h5").stat()
        outcome = self.expect(AGREED, "bless", "scenarios", "--reason", "the margin, too")
        self.assertIn("its digest, golden/one.txt, is written anew", outcome.out)
        self.assertIn("\nmargin: ", digest.read_text(encoding="utf-8"))
        self.assertIn("\nreason: the margin, too\n", digest.read_text(encoding="utf-8"))
        self.assertEqual((self.folder / "golden/one.h5").stat().st_mtime_ns, rows.st_mtime_ns)
        self.assertIn("nothing written", self.expect(AGREED, "bless", "scenarios", "--reason", "again").out)


class Figures(DriftTest):
    """--figures."""

    def texts(self, name):
        tree = xml.etree.ElementTree.parse(self.folder / name)
        return " ".join("".join(text.itertext()) for text in tree.iter("{http://www.w3.org/2000/svg}text"))

    def test_four_pictures_with_units_on_their_axes(self):
        self.expect(AGREED, "drift", self.write("fling.json", fling()), "--figures", "out")
        self.assertEqual(self.names("out"), ["fling-energy-drift.svg", "fling-energy.svg", "fling-errors.svg",
                                             "fling-restitution.svg"])
        for name, words in (("energy", ("time, s", "px²/s²")), ("energy-drift", ("time, s", "%")),
                            ("errors", ("time, s", "distance, px", "10⁻¹²")), ("restitution", ("0.60", "0.6, the paper"))):
            for word in words:
                self.assertIn(word, self.texts(f"out/fling-{name}.svg"))

    def test_a_run_without_arcs_says_so(self):
        self.expect(AGREED, "drift", self.write("fling.json", fling(steps=1)), "--figures", "out")
        self.assertIn("no flight of two steps or more", self.texts("out/fling-energy.svg"))

    def test_equal_names_are_refused(self):
        self.write("a.json", fling())
        self.write("b.json", fling())
        self.expect(BAD_INPUT, "drift", "a.json", "b.json", "--figures", "out", says="another run of the name fling")

    def test_standard_output_is_the_document_alone(self):
        outcome = self.expect(AGREED, "drift", self.write("fling.json", fling()), "--figures", "out", "--json")
        json.loads(outcome.out)


class Usage(DriftTest):
    """What is refused."""

    def test_options_that_make_no_sense(self):
        self.write("fling.json", fling())
        self.write("other.json", fling(name="other"))
        for arguments, words in (
                (("--tolerance", 1), "--tolerance: must be at most 0.1, is 1"),
                (("--tolerance", 1e-15), "--tolerance"),
                (("--stepper", "euler"), "--stepper"),
                (("--reference", "closed", "--stepper", "rk4"), "add --reference gsl"),
                (("--rows",), "say with -o in which"),
                (("other.json", "-o", "x.h5"), "-o writes one run, 2 are given")):
            self.expect(BAD_INPUT, "drift", "fling.json", *arguments, says=words)
        self.expect(BAD_INPUT, "drift", says="drift")
        self.assertEqual(self.names(), ["fling.json", "other.json"])

    def test_a_trajectory_is_not_played_into_a_file(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()))
        self.expect(BAD_INPUT, "drift", "fling.h5", "-o", "x.h5", says="name the scenario")

    def test_it_stands_on_the_first_help_screen(self):
        first, _ = self.expect(AGREED, "--help").out.split("More:")
        self.assertIn("  drift ", first)


if __name__ == "__main__":
    main()
