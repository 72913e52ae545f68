#!/usr/bin/python3
"""Changed, missing and exchanged golden files of the project's own scenarios turn `check` red."""

import shutil

import h5py
import numpy

from program import BAD_INPUT, DISAGREED, GOLDEN_MISSING, SOURCE, ProgramTest, main


class ProjectsGolden(ProgramTest):
    """A copy of the project's scenarios and golden files."""

    def setUp(self):
        super().setUp()
        for name in ("scenarios", "golden"):
            shutil.copytree(SOURCE / name, self.folder / name)

    def check(self, exit_code):
        """The entries of all scenarios, by path."""
        results = self.expect(exit_code, "check", "--json").json["results"]
        return {entry["scenario"]: entry for entry in results}

    def golden_files(self):
        """Paths of scenarios and their golden files."""
        for path in sorted((self.folder / "golden").rglob("*.h5")):
            name = path.relative_to(self.folder / "golden").with_suffix("")
            yield f"scenarios/{name}.json", path

    def test_one_ulp_in_the_last_row_is_found_there(self):
        short = {}
        for number, (scenario, path) in enumerate(self.golden_files()):
            with h5py.File(path, "r+") as file:
                field = ("x", "y", "vx", "vy")[number % 4]
                column = file[f"trajectory/{field}"]
                column[-1] = numpy.nextafter(column[-1], numpy.inf)
                if "blocks" not in file:
                    short[scenario] = (len(column) - 1, field)
        entries = self.check(DISAGREED)
        self.assertEqual({entry["status"] for entry in entries.values()}, {"disagreed"})
        self.assertGreater(len(short), 30)
        for scenario, (step, field) in short.items():
            first = entries[scenario]["first_divergence"]
            self.assertEqual((entries[scenario]["class"], first["step"], first["field"], first["ulps"]),
                             ("rounding", step, field, 1), scenario)

    def test_a_missing_golden_file_does_not_pass(self):
        for suffix in (".h5", ".txt"):
            (self.folder / "golden/flings/first-fling").with_suffix(suffix).unlink()
        self.assertEqual(self.check(GOLDEN_MISSING)["scenarios/flings/first-fling.json"]["status"], "missing")

    def test_half_a_golden_file_does_not_pass(self):
        (self.folder / "golden/flings/first-fling.txt").unlink()
        (self.folder / "golden/flings/wall-to-wall.h5").unlink()
        entries = self.check(GOLDEN_MISSING)
        self.assertEqual([path for path, entry in entries.items() if entry["status"] != "agreed"],
                         ["scenarios/flings/first-fling.json", "scenarios/flings/wall-to-wall.json"])

    def test_a_deleted_scenario_does_not_pass(self):
        (self.folder / "scenarios/flings/first-fling.json").unlink()
        entries = self.check(DISAGREED)
        self.assertEqual([path for path, entry in entries.items() if entry["status"] != "agreed"],
                         ["golden/flings/first-fling"])

    def test_another_margin_does_not_pass(self):
        for path in (self.folder / "golden").rglob("*.txt"):
            text = path.read_text(encoding="utf-8")
            path.write_text(text.replace("\nmargin: ", "\nmargin: about "), encoding="utf-8")
        self.assertEqual({entry["status"] for entry in self.check(DISAGREED).values()}, {"disagreed"})

    def test_the_golden_file_of_another_scenario_does_not_pass(self):
        for suffix in (".h5", ".txt"):
            golden = self.folder / "golden/flings"
            (golden / "wall-to-wall").with_suffix(suffix).replace((golden / "first-fling").with_suffix(suffix))
        entry = self.check(GOLDEN_MISSING)["scenarios/flings/first-fling.json"]
        self.assertEqual((entry["status"], entry["class"]), ("disagreed", "shape"))

    def test_an_empty_folder_does_not_pass(self):
        shutil.rmtree(self.folder / "scenarios")
        (self.folder / "scenarios/flings").mkdir(parents=True)
        self.expect(BAD_INPUT, "check", says="scenarios: no scenario found")


if __name__ == "__main__":
    main()
