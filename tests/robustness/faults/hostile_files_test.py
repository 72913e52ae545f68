"""Files made to harm their reader: every command reports damage, quickly and with little memory.

Fuzzers found the first of them, which the HDF5 library crashes on or never comes back from.
"""

import os
import shutil

import h5py

from program import AGREED, BAD_INPUT, SOURCE, ProgramTest, fling

FOUND = SOURCE / "tests/robustness/fuzz/found"
CRASHES = (FOUND / "golden/crash-in-heap-header.h5", FOUND / "trajectory/crash-in-heap-object.h5")


class HostileFile(ProgramTest):
    """A project whose golden file is replaced."""

    def setUp(self):
        super().setUp()
        self.project("fling", "other")
        self.golden = self.folder / "golden/fling.h5"

    def assert_refused(self, sentence, *commands):
        """Every command is exit 2 with the sentence; `check` still judges the other scenario."""
        # A sanitizer notices some harm before it is done.
        wanted = f"golden/fling.h5: is damaged: {'' if self.is_sanitized() else sentence}"
        for command in commands:
            outcome = self.expect(BAD_INPUT, *command)
            self.assertIn(wanted, outcome.out if command[0] == "check" else outcome.err)
            if command[0] == "check":
                self.assertIn("2 checked: 1 agreed, 0 disagreed, 0 without golden file, 1 failed", outcome.out)

    def test_that_crashes_hdf5(self):
        for found in CRASHES:
            shutil.copyfile(found, self.golden)
            self.assert_refused("the HDF5 library crashes on it; copy it again, or write it again", ("check",),
                                ("check", "--jobs", "1"), ("diff", "golden/fling.h5", "golden/other.h5"),
                                ("drift", "golden/fling.h5"))

    def test_it_does_not_keep_a_blessing_from_replacing_it(self):
        shutil.copyfile(CRASHES[0], self.golden)
        outcome = self.expect(AGREED, "bless", "scenarios/fling.json", "--reason", "it was damaged")
        self.assertIn("replaces a golden file that cannot be read", outcome.out)
        self.expect(AGREED, "check")

    def grow(self, group, length):
        """Makes a group's columns claim so many elements, of which none is stored."""
        with h5py.File(self.golden, "r+") as file:
            for name in list(file[group]):
                dtype = file[group][name].dtype
                del file[group][name]
                file[group].create_dataset(name, shape=(length,), maxshape=(None,), chunks=(1024,), dtype=dtype)

    def test_that_says_it_has_more_rows_than_time(self):
        self.grow("trajectory", 1 << 40)
        self.assertLess(self.golden.stat().st_size, 200_000)
        with h5py.File(self.golden, "r+") as file:
            file["trajectory/step"][-1] = 300
        self.assert_refused("reading it does not end", ("diff", "golden/fling.h5", "golden/other.h5"))

    def test_that_says_it_has_more_contacts_than_memory_which_stays_in_proportion(self):
        for length in (1 << 28, 1 << 40):
            self.grow("contacts", length)
            self.assert_refused("reading it takes too much memory for its size", ("check",),
                                ("diff", "golden/fling.h5", "golden/other.h5"))
            self.expect_below(300e6, BAD_INPUT, "check")

    def test_that_has_no_end_or_is_a_pipe(self):
        self.expect(BAD_INPUT, "validate", "/dev/zero", says="/dev/zero: is too large; a text file has at most 256 MiB")
        self.golden.unlink()
        os.mkfifo(self.golden)
        for path in ("/dev/zero", "golden/fling.h5"):
            self.expect(BAD_INPUT, "diff", path, "golden/other.h5", says=f"{path}: is not a regular file\n")
        self.expect(BAD_INPUT, "drift", "golden/fling.h5", says="golden/fling.h5: is not a regular file\n")

    def test_complete_files_in_other_encodings_are_accepted(self):
        with h5py.File(self.golden) as whole, h5py.File(self.folder / "compressed.h5", "w") as copy:
            def add(name, item):
                if isinstance(item, h5py.Group):
                    copy.require_group(name).attrs.update(item.attrs)
                else:
                    copy.create_dataset(name, data=item[...], dtype=item.dtype, maxshape=(None,), compression="gzip")

            copy.attrs.update(whole.attrs)
            whole.visititems(add)
        self.expect(AGREED, "diff", "golden/fling.h5", "compressed.h5")


class CostlyScenario(ProgramTest):
    """Small files of scenarios that are costly to parse, or to play: what is written of them is read again. Of each run, the
    first and the last row are recorded."""

    def run_and_compare(self, **changes):
        """The file of a run agrees with itself."""
        self.write("scenarios/fling.json", fling(record={"every": 1_000_000_000}, **changes))
        self.expect(AGREED, "run", "scenarios/fling.json", timeout=300)
        self.assertLess((self.folder / "fling.h5").stat().st_size, 20e6)
        self.expect(AGREED, "diff", "fling.h5", "fling.h5", timeout=300)

    def test_a_recorded_trace_of_two_million_frames(self):
        self.run_and_compare(steps=None, clock={"dt_s": [0.0625] * 2_000_000})
        self.expect(AGREED, "drift", "fling.h5", timeout=300)
        self.expect(AGREED, "bless", "scenarios", "--reason", "for the test", timeout=300)
        (self.folder / "golden/fling.txt").write_text("physics: none\n", encoding="utf-8")  # So that the rows are read.
        self.assertNotIn("damaged", str(self.hyrax_sim("check", timeout=300)))

    def test_a_moment_after_sixty_million_jittered_frames(self):
        """None of which is skipped: memory that a frame kept would show."""
        self.run_and_compare(steps=60_000_000, events=[{"at_s": 59_000_000, "stop": {}}],
                             clock={"dt_s": 1, "jitter": {"kind": "normal", "sigma_s": 0.1, "seed": 1}})
        self.expect_below(30e6, AGREED, "run", "scenarios/fling.json")
