"""Results of a drift: in files, in `run`, in expectations, in digests and in pictures."""

import re

import h5py
import numpy

from drift_test import DriftTest, flight
from program import AGREED, DISAGREED, SOURCE, fling

DOCUMENT = (SOURCE / "sim/reference/README.md").read_text(encoding="utf-8")


class Stored(DriftTest):
    """The groups /reference and /drift."""

    def groups(self, *arguments, **changes):
        """The file of a throw, measured during the run."""
        self.write("fling.json", fling(**changes))
        self.expect(AGREED, "run", "fling.json", "--drift", *arguments)
        return h5py.File(self.folder / "fling.h5")

    def test_what_is_nowhere_and_who_checked_are_those_of_the_document(self):
        run = self.drift_of(fling())
        with self.groups("--reference", "gsl") as file:
            self.assertEqual((sorted(file["drift"]), sorted(file["reference"])), (["arcs", "contacts", "whole"], ["arcs"]))
            none, = re.search(r"row of the first other contact \((\S+): none\)", DOCUMENT).groups()
            self.assertEqual((run["whole"]["contacts_differ_from"], file["drift/whole/contacts_differ_from"][0]), (None, int(none)))
            self.assertEqual(file["reference"].attrs["checked_by"], "GSL rk8pd, tolerance 1e-12")

    @staticmethod
    def assert_near(actual, expected):
        numpy.testing.assert_allclose(actual, expected, rtol=1e-9, atol=1e-6)

    def test_rows_are_stored_with_the_trajectory_and_are_nan_outside_of_arcs(self):
        with self.groups("--rows") as file:
            rows = len(file["trajectory/y"])
            named, = re.search(r"\| `/drift/(.*?) \| per row, with `--rows`", DOCUMENT).groups()
            self.assertEqual({"t", "step", "arcs", "contacts", "whole", *re.findall(r"\w+(?=`)", named)}, set(file["drift"]))
            flies = numpy.zeros(rows, bool)
            for arc, (first, last) in enumerate(zip(file["drift/arcs/first_step"], file["drift/arcs/last_step"], strict=True)):
                flies[first:last + 1] = True
                x, y, vx, vy = (file[f"trajectory/{name}"][first:last + 1] - file[f"reference/{name}"][first:last + 1]
                                for name in ("x", "y", "vx", "vy"))
                largest = {"truncation": numpy.hypot(x, y), "truncation_speed": numpy.hypot(vx, vy)}
                self.assert_near(file["drift/truncation"][first:last + 1], largest["truncation"])
                for name in ("implementation", "truncation", "model", "energy_drift"):
                    largest[name + "_max" * name.startswith("energy")] = abs(file[f"drift/{name}"][first:last + 1])
                for name, values in largest.items():
                    self.assert_near(file[f"drift/arcs/{name}"][arc] * 1e9, values.max() * 1e9)
            reference = {name: file[f"reference/{name}"][:] for name in ("y", "vx", "vy", "energy")}
            self.assert_near(reference["energy"][flies], (
                (reference["vx"]**2 + reference["vy"]**2) / 2 + 1200 * (952 - reference["y"]))[flies])
            speeds, heights = (file[f"trajectory/{v}"][:] for v in ("vx", "vy")), 1080 - 128 - file["trajectory/y"][:]
            energy = sum(speed**2 for speed in speeds) / 2 + 1200 * heights
            self.assert_near(file["drift/energy"][flies], energy[flies])
            self.assert_near(file["drift/energy_drift"][flies], (energy - reference["energy"])[flies])
            for name in ("reference/x", "reference/energy", "drift/implementation", "drift/energy", "drift/energy_drift"):
                self.assertEqual(file[name].shape, (rows,))
                numpy.testing.assert_array_equal(numpy.isnan(file[name][:]), ~flies, name)
            self.assertEqual(file["drift/t"][-1], file["trajectory/t"][-1])

    def test_of_a_decimated_run_its_recorded_rows_are_stored(self):
        for steps in (300, 60):  # The last row at rest, and in flight.
            with self.groups("--rows", steps=steps) as file:
                complete = {name: file[name][:] for name in ("drift/truncation", "reference/vy")}
            with self.groups("--rows", steps=steps, record={"every": 7}) as file:
                for name, values in complete.items():
                    numpy.testing.assert_array_equal(file[name][:], values[file["trajectory/step"][:]])

    def test_a_row_between_two_arcs_holds_the_errors_of_the_one_it_ends(self):
        events = [{"step": 20, "fling": {"vx_px_per_s": 0, "vy_px_per_s": -500}}]
        with self.groups("--rows", events=events) as file:
            self.assertEqual(file["drift/arcs/last_step"][0], 20)
            self.assertGreater(file["drift/truncation"][20], file["drift/truncation"][19])

    def test_the_same_run_gives_the_same_bytes_by_either_command(self):
        self.write("fling.json", fling())
        for name in ("a.h5", "b.h5"):
            run = self.expect(AGREED, "run", "fling.json", "--drift", "--rows", "--reference", "gsl", "-o", name).out
        drift = self.expect(AGREED, "drift", "fling.json", "--rows", "-o", "c.h5").out
        self.assertNotIn("errors of every row", run + drift)
        self.assertEqual(len({(self.folder / f"{name}.h5").read_bytes() for name in "abc"}), 1)
        self.expect(AGREED, "run", "fling.json", "-o", "plain.h5")
        self.expect(AGREED, "diff", "plain.h5", "a.h5")


class Run(DriftTest):
    """`run --drift`."""

    def test_its_document_holds_what_drift_measures_by_the_closed_form(self):
        self.write("fling.json", fling())
        run = self.expect(AGREED, "run", "fling.json", "--drift", "--json", "-v").json["runs"][0]
        self.assertEqual(self.errors(run["drift"]), self.errors(self.drift("fling.json", "--reference", "closed")[0]))
        self.assertNotIn("reference and energy (hyrax-sim drift)", run["not_computed"])


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

    def test_one_of_what_is_undefined_does_not_hold(self):
        still = fling(steps=1, expect={"energy_drift_rel_max": 1})
        self.assertEqual(self.verdicts(DISAGREED, still)["energy_drift_rel_max"],
                         {"rule": "energy_drift_rel_max", "holds": False, "measured": None})

    def test_check_and_bless_judge_them_too(self):
        path = self.write("scenarios/flight.json", flight(60, expect=self.BOUNDS))
        says = "truncation_px_max: wanted at most 9.8, measured 9.8"
        self.bless("scenarios")
        self.expect(AGREED, "check")
        self.write(path, flight(60, expect={"truncation_px_max": 9.8}))
        self.assertIn(says, self.expect(DISAGREED, "check").out)
        self.expect(DISAGREED, "bless", path, "--reason", "x", says=("its expectations do not hold; ", says))

    def test_with_pictures_it_is_one_document_all_the_same(self):
        document = self.expect(AGREED, "drift", self.write("fling.json", fling()), "--figures", "out", "--json").json
        self.assertEqual((list(document), self.names("out")), (["runs"], ["fling-drift.svg"]))
