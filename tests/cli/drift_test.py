"""`drift`: its measurements and its output."""

import math
import re

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, SOURCE, ProgramTest, fling

WIDTH_MAX = 100


def flight(rate_hz, steps=None, **changes):
    """A second of flight from vy = -900 px/s that meets nothing."""
    return fling(window={"width_px": 100000, "height_px": 100000},
                 start={"x_px": 4000, "y_px": 50000, "vx_px_per_s": 0, "vy_px_per_s": -900},
                 clock={"rate_hz": rate_hz}, steps=steps or rate_hz, **changes)


class DriftTest(ProgramTest):
    """The commands that the tests share."""

    def drift(self, *arguments):
        return self.expect(AGREED, "drift", *arguments, "--json").json["runs"]

    def drift_of(self, document, *arguments):
        return self.drift(self.write("scenario.json", document), *arguments)[0]

    def errors(self, run):
        """The part that does not depend on the machine's speed."""
        return {key: run[key] for key in ("whole", "arcs", "contacts", "skipped_arcs", "worst", "effective_restitution",
                                          "margin", "differing_steps", "reference_energy", "unlisted_energy")}


class Errors(DriftTest):

    def test_a_stepper_that_does_not_reach_the_closed_form_is_bad_input_and_without_gsl_its_distance_is_null(self):
        path = self.write("scenario.json", fling())
        for options, fault in ((("--stepper", "msbdf", "--tolerance", 1e-3), "position differs"), (("--stepper", "rk1imp"), "the second solver failed")):
            for command in (("drift", path), ("run", path, "--drift", "--reference", "gsl")):
                self.assertRegex(self.expect(BAD_INPUT, *command, *options).err,
                                 f"^fling: GSL {options[1]}, tolerance \\S+: this stepper does not reach the closed form, in 9 arcs, the first from row "
                                 f"0: {fault}; to check it, leave out --stepper and --tolerance\n$")
        self.assertGreater(self.expect(BAD_INPUT, "drift", path, "--stepper", "msbdf", "--tolerance", 1e-3, "--json").json["runs"][0]["worst"]["gsl_vs_closed_px"], 1e-9)
        self.drift_of(fling(), "--tolerance", 1e-13)
        run = self.drift_of(fling(), "--reference", "closed")
        self.assertEqual({arc["gsl_vs_closed_px"] for arc in run["arcs"]}, {None})
        self.assertIsNone(run["worst"]["gsl_vs_closed_px"])

    def test_the_exact_fling_turns_at_both_walls_of_an_exact_corner(self):
        start = dict(zip(("x_px", "y_px", "vx_px_per_s", "vy_px_per_s"), (1410.6908317886625, 52.740711403584875, 261.36156012427085, -313.6990866151649)))
        self.assertAlmostEqual(self.drift_of(fling(start=start))["whole"]["end_px"], 3.66, delta=0.01)

    def test_without_an_exact_fling_the_document_says_why(self):
        run = self.drift_of(fling(window={"width_px": 40, "height_px": 40}), "-o", "drift.h5")
        self.assertIsNone(run["whole"])
        self.assertEqual(run["whole_why"], "the sprite is larger than its window in row 0")
        with h5py.File(self.folder / "drift.h5") as file:
            self.assertEqual((file["drift"].attrs["whole_why"], "whole" in file["drift"]), (run["whole_why"], False))

    def test_a_long_rest_is_counted_without_being_played(self):
        steps = 60_000
        self.expect(AGREED, "run", self.write("long.json", fling(name="long", steps=steps)))
        (self.folder / "long.h5").rename(self.folder / "of any name")
        live, stored = self.drift("long.json", "of any name", "--reference", "closed")
        self.assertEqual(self.errors(live), self.errors(stored))
        endless = self.drift_of(fling(name="endless", steps=1e12), "--reference", "closed")
        self.assertGreater(endless["skipped_arcs"], 999_999_000_000)
        self.assertEqual(endless["arcs"], live["arcs"])


class Files(DriftTest):
    """Trajectories instead of scenarios."""

    def test_a_decimated_file_is_replayed_from_its_scenario(self):
        self.expect(AGREED, "run", self.write("fling.json", fling(record={"every": 7})))
        live, stored = self.drift("fling.json", "fling.h5")
        self.assertEqual(self.errors(live), self.errors(stored))
        text = self.expect(AGREED, "drift", "fling.h5").out
        self.assertIn("replayed from its scenario: the file holds 44 of 301 rows", text)
        self.assertNotIn("STATE HASH DIFFERS", text)
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file.attrs["state_hash"] = 32 * "0"
        self.assertIn("THE REPLAY'S STATE HASH DIFFERS", self.hyrax_sim("drift", "fling.h5").out)

    def test_golden_files_are_measured_short_or_long(self):
        for name in ("flings/first-fling", "clocks/hour-at-60-hz"):
            live, stored = self.drift(SOURCE / f"scenarios/{name}.json", SOURCE / f"golden/{name}.h5")
            self.assertEqual(self.errors(live), self.errors(stored))

    def test_a_row_that_is_not_finite_ends_the_measuring_and_one_out_of_order_is_refused(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()))
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file["trajectory/y"][50] = math.nan
        outcome = self.expect(DISAGREED, "drift", "fling.h5")
        self.assertIn("does not hold: NOT FINITE from row 50", outcome.out)
        self.assertEqual(self.expect(DISAGREED, "drift", "fling.h5", "--json").json["runs"][0]["non_finite_step"], 50)
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file["trajectory/step"][40] = 7
        self.expect(BAD_INPUT, "drift", "fling.h5", says="/trajectory/step: must be 40 (found 7)")
        self.expect(BAD_INPUT, "drift", "fling.h5", "-o", "x.h5", says="fling.h5: is a trajectory; -o needs a scenario")

    def test_a_file_is_measured_by_its_own_constants_and_not_without(self):
        self.expect(AGREED, "run", self.write("fling.json", fling()))
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            file.attrs["physics"] = "box/1"
            file.attrs["constants"] = [1250, *file.attrs["constants"][1:]]
        first = self.expect(DISAGREED, "drift", "fling.h5", "--reference", "closed", "--json").json["runs"][0]["arcs"][0]
        fallen_px = sum(50 / 60 ** 2 * 0.999 ** (1 + frame) * (35 - frame) for frame in range(35))
        self.assertEqual(first["last_step"], 35)
        self.assertAlmostEqual(first["implementation_px"], fallen_px, delta=1e-9)
        with h5py.File(self.folder / "fling.h5", "r+") as file:
            del file.attrs["constants"]
        self.expect(BAD_INPUT, "drift", "fling.h5",
                    says="fling.h5: needs the paper's step, with any constants (found the core box/1, whose step is another)\n")

    def test_a_failure_does_not_end_the_other_runs(self):
        self.write("good.json", fling())
        outcome = self.expect(CANNOT_ACCESS, "drift", "none.json", "good.json", "none.h5", "--json",
                              says=("none.json", "none.h5"))
        none, good, _ = outcome.json["runs"]
        self.assertEqual(none["status"], "failed")
        self.assertIn("arcs", good)

    def test_its_page_has_of_each_run_the_answer_the_picture_the_bounds_and_a_row_for_each_arc_and_contact(self):
        paths = self.write("one.json", fling(name="one")), self.write("two.json", fling(name="two", steps=90))
        self.expect(AGREED, "drift", *paths, "--report", "page.html")
        page = (self.folder / "page.html").read_text(encoding="utf-8")
        self.assertIn("hyrax-sim drift one.json two.json --report page.html", page)
        self.assertNotRegex(page, r"<script[^>]* src|<link")  # One file, which loads nothing.
        for name, run, text in zip(("one", "two"), self.drift(*paths), page.split("<article")[1:], strict=True):
            self.assertRegex(text, f"<h[12][^>]*>{name} (loses|gains) ")
            self.assertIn("<svg", text)
            self.assertNotIn("<summary></summary>", text)
            self.assertIn("<p>whole run", text)
            self.assertIn("end_low", text.replace(" ", "_"))
            rows = len(run["arcs"]) + len(run["contacts"])
            self.assertEqual(sum(int(count) for count in re.findall("(?:arcs|contacts): [^<]*, ([0-9]+) rows?<", text)), rows)

    def test_the_text_fits_a_terminal(self):
        for line in self.expect(AGREED, "drift", *(SOURCE / f"scenarios/{folder}" for folder in ("flings", "hard"))).out.splitlines():
            self.assertLessEqual(len(line), WIDTH_MAX, line)
