"""`diff`: two trajectory files, value by value."""

import contextlib
import fcntl
import re
import shutil

import h5py
import numpy

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, ProgramTest, fling


class Diff(ProgramTest):
    """A run, and a copy of it in which something is changed."""

    made = b""  # The run, made once.

    def setUp(self):
        super().setUp()
        self.write("fling.json", fling())
        if not Diff.made:
            self.expect(AGREED, "run", "fling.json", "-o", "a.h5")
            Diff.made = (self.folder / "a.h5").read_bytes()
        (self.folder / "a.h5").write_bytes(Diff.made)

    @contextlib.contextmanager
    def copied(self):
        """b.h5 becomes a copy of a.h5, open to be changed."""
        shutil.copyfile(self.folder / "a.h5", self.folder / "b.h5")
        with h5py.File(self.folder / "b.h5", "r+") as file:
            yield file

    def change(self, dataset, row, value):
        """b.h5 becomes a copy of a.h5 with one value changed, by a function or to a value."""
        with self.copied() as file:
            file[dataset][row] = value(file[dataset][row]) if callable(value) else value

    def text(self, *options, exit_code=DISAGREED):
        return self.expect(exit_code, "diff", "a.h5", "b.h5", *options).out

    def diff(self, exit_code, *options, b="b.h5"):
        document = self.expect(exit_code, "diff", "a.h5", b, "--json", *options).json
        self.assertEqual(document["agree"], exit_code == AGREED)
        return document

    def test_a_file_agrees_with_itself(self):
        self.assertEqual(self.diff(AGREED, b="a.h5"), {"agree": True, "class": None, "first_divergence": None, "worst": {},
                                                       "contacts": {"moved": 0, "only_a": 0, "only_b": 0}})

    def test_a_value_agrees_if_any_tolerance_is_met(self):
        self.change("trajectory/x", 100, lambda value: value + 0.25)
        self.assertEqual(self.diff(AGREED, "--abs", "0.25")["worst"]["x"]["abs"], 0.25)
        self.diff(AGREED, "--abs", "0.24", "--rel", "1e-3")
        self.diff(DISAGREED, "--abs", "0.24", "--rel", "1e-6")
        self.change("trajectory/vx", 300, lambda value: numpy.nextafter(value, numpy.inf))
        self.diff(AGREED, "--ulps", "1")
        document = self.diff(DISAGREED, "--ulps", "0")
        self.assertEqual((document["class"], document["worst"]["vx"]["ulps"]), ("rounding", 1))

    def test_what_is_not_finite_is_a_string(self):
        self.change("trajectory/vy", 50, -numpy.inf)
        with h5py.File(self.folder / "b.h5", "r+") as file:
            file["trajectory/x"][60] = numpy.nan
        document = self.diff(DISAGREED, "--abs", "1e300")
        self.assertEqual(document["first_divergence"]["actual"], "-Infinity")
        self.assertEqual((document["worst"]["vy"]["abs"], document["worst"]["x"]["abs"]), ("Infinity", "NaN"))

    def test_contacts_have_names(self):
        self.change("trajectory/contact", 100, 1 + 8 + 16 + 32)
        text = self.text()
        self.assertIn("field contact\n  expected   none\n  actual     left+ground+rest+0x20\n", text)
        self.assertIn("\n  worst contact none and left+ground+rest+0x20 at step 100\n", text)
        self.assertNotRegex(text, "ulp|distance")
        first = self.diff(DISAGREED)["first_divergence"]
        self.assertEqual((first["actual"], first["ulps"]), (57, None))

    def test_other_inputs_are_of_class_shape(self):
        self.write("fling.json", fling(events=[{"step": 20, "fling": {"vx_px_per_s": -900, "vy_px_per_s": -800}}]))
        self.expect(AGREED, "run", "fling.json", "-o", "a.h5")
        for dataset, value, says in (("a", -901.0, "fling in frame 20: other values"),
                                     ("frame", 21, "fling in frame 20 -> fling in frame 21")):
            self.change(f"events/{dataset}", 0, value)
            text = self.text("--abs", "1")
            self.assertIn(f"\n  shape      the inputs differ: {says}\n", text)
            self.assertIn("  class      shape\n", text)

    def test_a_file_that_contradicts_itself_is_of_class_shape(self):
        for group, attribute, value, says in (
                ("contacts", "total", 10, "the contacts agree, their numbers do not\n"
                                          "  total      the numbers of contacts differ: 9 and 10\n"),
                ("/", "state_hash", "0" * 32, "all rows agree, the state hashes do not\n")):
            with self.copied() as file:
                file[group].attrs[attribute] = value
            text = self.text()
            self.assertIn("  class      shape\n", text)
            self.assertIn(f"  shape      a file contradicts itself: {says}", text)
            self.assertNotRegex(text, "not recorded in both|the core changed")

    def test_other_clocks_are_compared_at_the_same_time(self):
        rest = {"x_px": 100, "y_px": 952, "vx_px_per_s": 60}
        self.write("slide.json", fling(name="slide", start=rest, window={"width_px": 10**6, "height_px": 10**6},
                                       clock={"dt_s": 0.5}, steps=8))
        self.expect(AGREED, "run", "slide.json", "-o", "a.h5")
        for dt_s, steps in ((0.25, 16), (0.501, 8)):
            self.expect(AGREED, "run", "slide.json", "-o", "b.h5", "--set", f"/clock/dt_s={dt_s}", "--set", f"/steps={steps}")
            largest = 0.0
            with h5py.File(self.folder / "a.h5") as a, h5py.File(self.folder / "b.h5") as b:
                rows_a, rows_b = ({name: file[f"trajectory/{name}"][:] for name in "txy"} for file in (a, b))
                for row, at_s in enumerate(rows_b["t"]):
                    shown = int(numpy.flatnonzero(rows_a["t"] <= at_s)[-1])
                    distance = numpy.hypot(rows_a["x"][shown] - rows_b["x"][row], rows_a["y"][shown] - rows_b["y"][row])
                    largest = max(largest, distance)
            text = self.text()
            self.assertRegex(text, rf"  apart      at most {largest:.3g} px, at step \d+ \(.* s\); rows of the same time\n")

    def test_a_figure_shows_both_paths_and_their_distance(self):
        self.change("trajectory/x", 100, lambda value: value + 0.25)
        (self.folder / "golden").mkdir()
        outcome = self.expect(DISAGREED, "diff", "a.h5", "b.h5", "--figure", "diff.svg")
        self.assertIn("  figure     diff.svg\n", outcome.out)
        svg = (self.folder / "diff.svg").read_text()
        for part in ("at most 0.25 px apart", "class values, no contact moved", "a.h5", "b.h5", "first difference"):
            self.assertIn(part, svg)
        (self.folder / "golden/a.h5").write_bytes((self.folder / "a.h5").read_bytes())
        self.expect(AGREED, "diff", str(self.folder / "golden/a.h5"), str(self.folder / "a.h5"), "--figure", "diff.svg")
        svg = (self.folder / "diff.svg").read_text()
        for part in ("golden/a.h5", f"{self.folder.name}/a.h5", "the same place at every time"):
            self.assertIn(part, svg)
        self.assertNotIn(str(self.folder), svg)
        self.expect(AGREED, "diff", "golden/a.h5", "a.h5", "--figure", "diff.svg")
        self.assertIn('data-series="golden/a.h5"', (self.folder / "diff.svg").read_text())

    def test_a_row_that_only_one_file_holds_is_of_class_shape(self):
        self.expect(AGREED, "run", "fling.json", "-o", "b.h5", "--set", "/record/every=2")
        with h5py.File(self.folder / "a.h5") as whole, h5py.File(self.folder / "b.h5", "r+") as decimated:
            decimated.attrs["scenario"] = whole.attrs["scenario"]
        self.assertIn("  shape      only one of the files holds row 1\n", self.text())

    def test_the_name_of_the_physics_model_sets_no_class(self):
        differ = "  physics    the physics models differ: hyrax-physics/1 and hyrax-physics/2\n"
        for offset_px, exit_code, class_ in ((0.0, AGREED, []), (0.25, DISAGREED, ["values"])):
            with self.copied() as file:
                file.attrs["physics"] = "hyrax-physics/2"
                file["trajectory/x"][100] += offset_px
            text = self.text(exit_code=exit_code)
            self.assertIn(differ, text)
            self.assertEqual(re.findall(r"^  class +(.*)", text, re.MULTILINE), class_)

    def test_constants_are_five_numbers_or_none(self):
        for wrong in (numpy.zeros(4), numpy.zeros(6), numpy.zeros(5, "f4"), "1200"):
            with self.copied() as file:
                file.attrs["constants"] = wrong
            self.expect(BAD_INPUT, "diff", "a.h5", "b.h5", says="b.h5: attribute constants: is not 5 numbers")
        with self.copied() as file:
            del file.attrs["constants"]
        self.diff(AGREED)
        with h5py.File(self.folder / "b.h5", "r+") as file:
            file.attrs["physics"] = "box/1"  # Whose constants are not known.
            file["trajectory/x"][300] += 1e-9
        self.assertIn("\n  rest       1e-9 px apart: x 345.341, y 952 px; settled since 4 s\n  contacts   no contact moved\n  class ", self.text())

    def test_other_build_settings_are_shown_with_what_they_mean(self):
        with self.copied() as file:
            file["trajectory/x"][100] += 0.25
            file["provenance"].attrs["flags"] = "-O3 -mfma"
            file["provenance"].attrs["instruction_set"] = "x86-64-v3"
        text = self.text()
        self.assertIn("build settings: differ\n", text)
        self.assertRegex(text, r"flags: '.*-ffp-contract=off' and '-O3 -mfma'\n")
        self.assertRegex(text, r"instruction_set: '.+' and 'x86-64-v3'\n")
        self.assertIn("usually one of the two fuses", text)
        self.assertNotIn("compiler", text)
        with self.copied() as file:
            file["trajectory/x"][100] += 0.25
            del file["provenance"].attrs["self_test"]
        self.assertIn("build settings: identical where recorded\n", self.text())

    def test_rows_that_are_not_recorded_differ_in_the_hash(self):
        self.expect(AGREED, "run", "fling.json", "-o", "a.h5", "--set", "/record/every=100")
        with self.copied() as file:
            file.attrs["state_hash"] = "0" * 32
        text = self.text()
        for part in ("hashes differ", "  class      rounding\n"):
            self.assertIn(part, text)
        self.assertNotIn("  first ", text)
        self.diff(AGREED, "--abs", "1e-9")

    def test_a_file_that_another_program_writes_is_reported_as_locked(self):
        says = "b.h5: cannot be read: locked by another program, which may be writing it\n"
        with self.copied():
            self.expect(CANNOT_ACCESS, "diff", "a.h5", "b.h5", says=says)
        with open(self.folder / "b.h5", "rb") as file:
            fcntl.flock(file, fcntl.LOCK_SH)  # Another reader.
            self.expect(AGREED, "diff", "a.h5", "b.h5")
            fcntl.flock(file, fcntl.LOCK_EX)
            self.expect(CANNOT_ACCESS, "drift", "b.h5", says=says)
