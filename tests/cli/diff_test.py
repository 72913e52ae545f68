"""`diff`: two trajectory files, value by value."""

import contextlib
import fcntl
import re
import shutil

import h5py
import numpy

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, ProgramTest, fling


def distance_at_equal_times(*paths):
    """The largest distance of two runs at equal times, when it is, and the frames of jumps that are left out."""
    runs = []
    for path in paths:
        with h5py.File(path) as file:
            kinds = {code: kind for kind, code in h5py.check_enum_dtype(file["events/kind"].dtype).items()}
            jumps = [int(frame) for frame, kind in zip(file["events/frame"][:], file["events/kind"][:])
                     if kinds[kind].split("-")[0] in ("place", "grab", "release", "resize")]
            runs.append((*(file[f"trajectory/{name}"][:] for name in "txy"), jumps))

    def place(run, at_s):
        times_s, *axes, _ = run
        row = int(numpy.flatnonzero(times_s <= at_s)[-1])
        if times_s[row] == at_s:
            return numpy.array([axis[row] for axis in axes])
        part = (at_s - times_s[row]) / (times_s[row + 1] - times_s[row])
        return numpy.array([axis[row] + part * (axis[row + 1] - axis[row]) for axis in axes])

    largest_px, largest_s, left_out = 0.0, 0.0, set()
    for at_s in sorted({*runs[0][0], *runs[1][0]}):
        if at_s > min(run[0][-1] for run in runs):
            break
        now = {frame for times_s, _, _, jumps in runs for frame in jumps
               if times_s[frame] < at_s <= times_s[min(frame + 2, len(times_s) - 1)]}
        left_out |= now
        distance_px = 0.0 if now else numpy.hypot(*(place(runs[0], at_s) - place(runs[1], at_s)))
        if distance_px > largest_px:
            largest_px, largest_s = distance_px, at_s
    return largest_px, largest_s, left_out


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

    def test_files_of_several_batches_are_compared_to_their_ends(self):
        rows = 2 * 65_536 + 10
        self.write("fling.json", fling(steps=rows - 1, events=[{"step": rows - 300, "fling": {"vx_px_per_s": 900, "vy_px_per_s": -1500}}]))
        self.expect(AGREED, "run", "fling.json", "-o", "a.h5")
        for row in (65_535, 65_536, rows - 1):
            self.change("trajectory/x", row, lambda value: value + 0.25)
            document = self.diff(DISAGREED)
            self.assertEqual((document["max_px"], document["first_divergence"]["step"], document["worst"]["x"]["step"]), (0.25, row, row))
            self.assertIn(f"0.25 px apart at step {row} ", self.text())

    def test_a_file_agrees_with_itself(self):
        self.assertEqual(self.diff(AGREED, b="a.h5"), {"agree": True, "class": None, "max_px": 0, "contacts_moved": 0, "first_divergence": None,
                                                       "worst": {}, "contacts": {"moved": 0, "only_a": 0, "only_b": 0}})

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

    def expect_distance(self, scenario, *options):
        """The distance of a scenario's run and of one with these options, by `diff`, and by `check` of a scenario so changed."""
        path = self.write("scenarios/x.json", {**scenario, "name": "x"})
        self.bless(path)
        self.expect(AGREED, "run", path, "-o", "a.h5")
        sets = [part for option in options for part in ("--set", option)]
        self.expect(AGREED, "run", path, "-o", "b.h5", *sets)
        with h5py.File(self.folder / "b.h5") as file:
            self.write("scenarios/x.json", file.attrs["scenario"])
        wanted_px, at_s, left_out = distance_at_equal_times(*(self.folder / name for name in ("a.h5", "b.h5")))
        self.assertGreater(wanted_px, 0)
        for pair in (("a.h5", "b.h5"), ("golden/x.h5", "b.h5")):
            found_px = self.expect(DISAGREED, "diff", *pair, "--json").json["max_px"]
            self.assertAlmostEqual(found_px, wanted_px, delta=1e-12 * wanted_px)
        entry, = self.expect(DISAGREED, "check", "--json").json["results"]
        self.assertEqual(entry["max_px"], found_px)
        said = f"{found_px:.3g} px apart at {at_s:.4g} s, at equal times"
        if left_out:
            said += f" ({len(left_out)} frame{'s'[:len(left_out) > 1]} of place, grab, release or resize left out)"
        for arguments in (("diff", *pair), ("check",), ("bless", path, "--reason", "x", "--dry-run")):
            self.assertIn(said, self.expect(AGREED if arguments[0] == "bless" else DISAGREED, *arguments).out)
        return found_px

    def test_other_clocks_are_compared_at_equal_times_by_every_command(self):
        """A slow one and a fast one; zero frames; a drag, whose jumps are left out; a run that keeps no rows."""
        self.assertLess(self.expect_distance(fling(steps=30), "/clock/rate_hz=75", "/steps=37"), 3)
        self.expect_distance(fling(clock={"dt_s": [0.02, 0, 0, 0.01, 0.02] * 20}, steps=None), f"/clock/dt_s={[0.01] * 99}")
        drag = [{"step": 20, "grab": {}}, {"step": 21, "place": {"x_px": 30, "y_px": 40}},
                {"step": 40, "release": {"vx_px_per_s": 700, "vy_px_per_s": -900}},
                {"step": 90, "resize": {"window": {"width_px": 1000, "height_px": 700}}}]
        self.expect_distance(fling(events=drag), "/clock/rate_hz=59")
        jitter = {"kind": "missed_frames", "probability": 0.05, "seed": 7}
        self.expect_distance(fling(steps=9000, clock={"rate_hz": 60, "jitter": jitter}), "/clock/jitter/seed=8")

    def test_rows_that_a_file_does_not_hold_are_played(self):
        for every in (1, 100):
            for name, speed in (("a", -400), ("b", -500)):
                self.expect(AGREED, "run", "fling.json", "-o", f"{name}{every}.h5", "--set", f"/record/every={every}",
                            "--set", f"/start/vy_px_per_s={speed}")
        whole, part = (self.expect(DISAGREED, "diff", f"a{every}.h5", f"b{every}.h5", "--json").json for every in (1, 100))
        self.assertEqual(part["max_px"], whole["max_px"])
        with h5py.File(self.folder / "b100.h5", "r+") as file:
            file.attrs["state_hash"] = "0" * 32  # No core gives it again.
        document = self.expect(DISAGREED, "diff", "a100.h5", "b100.h5", "--json").json
        self.assertLess(document["max_px"], whole["max_px"])
        out = self.expect(DISAGREED, "diff", "a100.h5", "b100.h5").out
        self.assertIn(" in the rows that are known\n", out)
        self.assertIn(" -> unknown whether settled\n", out)

    def test_a_figure_shows_both_paths_and_their_distance(self):
        self.change("trajectory/x", 100, lambda value: value + 0.25)
        (self.folder / "golden").mkdir()
        outcome = self.expect(DISAGREED, "diff", "a.h5", "b.h5", "--figure", "diff.svg")
        self.assertIn("  figure     diff.svg\n", outcome.out)
        svg = (self.folder / "diff.svg").read_text()
        for part in ("0.25 px apart at step 100 (1.667 s)", "class values, no contact moved", "a.h5", "b.h5", "first difference"):
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
        self.assertIn("\n  end        comes to rest 1e-9 px away: x 345.341, y 952 px; settled since 4 s\n  contacts   no contact moved\n  class ", self.text())

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
