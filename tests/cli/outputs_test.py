"""No output overwrites an input, a golden file or a scenario. Allowed names of outputs."""

import csv
import os

import h5py

from program import AGREED, BAD_INPUT, CANNOT_ACCESS, ProgramTest, fling


class Guarded(ProgramTest):
    """Protects inputs and golden files under any name and any path to them."""

    def setUp(self):
        super().setUp()
        self.project("fling")
        self.write("sub/note.txt", "a folder to go through")
        os.symlink("golden", self.folder / "to-golden")
        os.symlink("../golden/dangling", self.folder / "sub/dangling")
        self.write("elsewhere/note.txt", "golden files of somebody")

    def victims(self, suffix, of_each=1):
        """Outputs that are refused for scenarios/in.SUFFIX, and a part of the message; so many paths to each."""
        source = self.folder / self.write(f"scenarios/in{suffix}", fling(name="in"))
        self.bless(f"scenarios/in{suffix}")
        self.write(f"other{suffix}", fling(name="other"))
        os.link(source, self.folder / f"hard{suffix}")
        os.symlink(f"scenarios/in{suffix}", self.folder / f"link{suffix}")
        os.symlink(f"../link{suffix}", self.folder / f"sub/link{suffix}")
        for part in ("h5", "txt"):
            os.link(self.folder / f"golden/in.{part}", self.folder / f"hard-{part}{suffix}")
        os.symlink(f"golden/new{suffix}", self.folder / f"to-new{suffix}")
        inputs = [f"scenarios/in{suffix}", f"./scenarios//in{suffix}", f"sub/../scenarios/in{suffix}", f"hard{suffix}",
                  f"link{suffix}", f"sub/link{suffix}", str(source), f"to-golden/../scenarios/in{suffix}"]
        golden = [f"golden/new{suffix}", f"scenarios/../golden/new{suffix}", f"to-golden/new{suffix}", f"to-new{suffix}",
                  f"golden/deep/new{suffix}", f"hard-h5{suffix}", f"hard-txt{suffix}", str(self.folder / f"golden/new{suffix}"),
                  f"golden/in{suffix}"]
        return ([(path, f"would overwrite an input of this command (found {path}); name another file") for path in inputs[:of_each]] +
                [(f"other{suffix}", f"would overwrite a scenario (found other{suffix}); name another file")] +
                [(path, f"is a golden file or in a golden folder (found {path}); only `hyrax-sim bless` writes there")
                 for path in golden[:of_each]])

    def assert_refused(self, *arguments, says, **options):
        """Exit 2 with a message, and nothing is written."""
        before = (self.state_of("."), self.names())
        outcome = self.expect(BAD_INPUT, *arguments, says=says, **options)
        self.assertEqual((self.state_of("."), self.names()), before, arguments)
        self.assertEqual(outcome.out, "", arguments)

    def assert_all_refused(self, suffix, *command, of_each):
        """Each victim, as the value of the option that ends the command."""
        for victim, says in self.victims(suffix, of_each):
            arguments = [part.replace("IN", f"scenarios/in{suffix}") for part in command]
            self.assert_refused(*arguments, victim, says=(f" {command[-1]}", f": {says}"))
        self.assert_refused(*arguments[:-1], "--golden", "elsewhere", command[-1], f"elsewhere/new{suffix}", says="golden")

    def test_files_as_outputs(self):
        for suffix, of_each, *command in ((".h5", 9, "run", "IN", "-o"), (".csv", 1, "run", "IN", "-o"),
                                          (".svg", 1, "run", "IN", "--figure"), (".xml", 1, "check", "IN", "--junit")):
            self.assert_all_refused(suffix, *command, of_each=of_each)
        self.write("scenarios/broken.json", "{ not yet")
        self.assert_refused("check", "scenarios/fling.json", "--junit", "scenarios/broken.json", says="a scenario")

    def test_drift_o(self):
        self.write("fling.json", fling())
        self.assert_refused("drift", "fling.json", "-o", "golden/fling.h5", says=("-o", "golden"))
        for victim, says in self.victims(".h5"):
            self.assert_refused("drift", "scenarios/in.h5", "-o", victim, says=f"-o: {says}")

    def test_folders_as_outputs(self):
        self.write("out/fling.h5", fling())
        self.assert_refused("run", "out/fling.h5", "-o", "out/", says="an input")
        self.assert_refused("run", "scenarios/fling.json", "-o", "out/", says="a scenario")
        self.assert_refused("run", "../scenarios/fling.json", says="golden", cwd=self.folder / "golden")
        for golden in ("golden", "golden/new/", "to-golden", "sub/../golden"):
            self.assert_refused("run", "scenarios", "-o", golden, says="golden")
            self.assert_refused("drift", "scenarios/fling.json", "--figures", golden, says="golden")
            self.assert_refused("study", "needs", "scenarios", "--quick", "-o", golden, says="golden")
            self.assert_refused("fuzz", "--runs", "1", "-o", golden, says="golden")

    def test_drift_figures(self):
        path = self.write("pictures/fling-drift.svg", fling())
        self.assert_refused("drift", path, "--figures", "pictures", says="an input")
        self.assert_refused("drift", "scenarios/fling.json", "--figures", "pictures", "-o", "new.h5", says="a scenario")

    def test_study_files(self):
        for suffix in (".h5", ".csv", ".svg"):
            name = "needs-fling.svg" if suffix == ".svg" else f"needs{suffix}"
            path = self.write(f"study{suffix}/{name}", fling())
            self.assert_refused("study", "needs", path, "--quick", "-o", f"study{suffix}", says="an input")
            self.assert_refused("study", "needs", "scenarios", "--quick", "-o", f"study{suffix}", says="a scenario")

    def test_two_outputs_in_one_place(self):
        os.symlink("two.h5", self.folder / "sub/one.h5")
        self.write("one.json", fling(name="one"))
        self.write("two.json", fling(name="two"))
        self.write("again.json", fling(name="one"))
        for command in (("run", "one.json", "two.json", "-o", "sub"), ("run", "one.json", "again.json"),
                        ("drift", "one.json", "again.json", "--figures", "out")):
            self.assert_refused(*command, says=("again.json" if "again.json" in command else "sub", "another output of this command"))

    def test_a_golden_folder_that_is_a_link(self):
        os.rename(self.folder / "golden", self.folder / "kept")
        os.symlink("kept", self.folder / "golden")
        os.symlink("golden", self.folder / "again")
        os.symlink("../sub/far.h5", self.folder / "kept/far.h5")
        for output in ("golden/new.h5", "kept/new.h5", "again/new.h5", "golden/far.h5"):
            self.assert_refused("run", "scenarios/fling.json", "-o", output, says="golden")
        self.write("fling.json", fling())
        for output in ("golden/new.h5", "again/new.h5"):
            self.assert_refused("run", "fling.json", "-o", output, says="golden")

    def test_a_large_result_of_before_is_not_read(self):
        path = self.write("fling.json", fling())
        with open(self.folder / "out.h5", "wb") as file:
            file.truncate(200_000_000)
        self.expect_below(180e6, AGREED, "run", path, "-o", "out.h5")

    def test_what_is_none_of_these_is_written(self):
        self.write("golden-old/note.txt", "")
        self.write("report.xml", "<old/>")
        self.write("scenarios/notes.h5", "no scenario")
        self.write("golden/inner/golden/note.txt", "")
        os.symlink("golden-old", self.folder / "old")
        for output in ("golden-old/x.h5", "old/x.h5", "sub/golden.h5", "golden/../x.h5", "scenarios/notes.h5"):
            self.expect(AGREED, "run", "scenarios/fling.json", "-o", output)
        self.expect(AGREED, "run", "scenarios/fling.json", "-o", output)  # Over its own output.
        for report in ("report.xml", "scenarios/new.json"):
            self.expect(AGREED, "check", "scenarios/fling.json", "--junit", report)


class Names(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("fling.json", fling())

    def table(self, *arguments):
        """The rows of a CSV file, as text, and those of the HDF5 file of the same run, as numbers."""
        self.expect(AGREED, "run", "fling.json", "-o", "run.csv", *arguments)
        self.expect(AGREED, "run", "fling.json", "-o", "run.h5", *arguments)
        with open(self.folder / "run.csv", newline="", encoding="ascii") as file:
            text = file.read()
        self.assertNotIn("\r", text)
        head, *rows = csv.reader(text.splitlines())
        self.assertEqual(head, "step t_s dt_s x_px y_px vx_px_per_s vy_px_per_s contact".split())
        with h5py.File(self.folder / "run.h5") as file:
            columns = [file["trajectory"][name][()] for name in "step t dt x y vx vy contact".split()]
        return rows, list(zip(*columns))

    def test_csv_has_the_rows_of_the_trajectory(self):
        for arguments, count in (((), 301), (("--drift",), 301), (("--set", "/record/every=7"), 44), (("--set", "/steps=0"), 1)):
            rows, wanted = self.table(*arguments)
            self.assertEqual((len(rows), len(wanted)), (count, count))
            for row, numbers in zip(rows, wanted, strict=True):
                self.assertEqual([repr(float(value)) for value in row], [repr(float(number)) for number in numbers])

    def test_no_folder_is_made_for_a_bad_input(self):
        self.write("bad.json", "{")
        for exit_code, arguments in ((BAD_INPUT, ("run", "bad.json", "-o", "new/")),
                                     (CANNOT_ACCESS, ("run", "none.json", "-o", "new/deep/")),
                                     (BAD_INPUT, ("run", "fling.json", "--rows", "-o", "new/")),
                                     (BAD_INPUT, ("drift", "bad.json", "--figures", "new")),
                                     (BAD_INPUT, ("study", "needs", "bad.json", "-o", "new")),
                                     (BAD_INPUT, ("bless", "bad.json", "--golden", "new", "--reason", "x"))):
            self.expect(exit_code, *arguments)
            self.assertEqual(self.names(), ["bad.json", "fling.json"], arguments)
