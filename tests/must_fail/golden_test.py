#!/usr/bin/python3
"""Changed golden files of the project's own scenarios turn `check` red."""

import shutil

import h5py
import numpy

from program import DISAGREED, SOURCE, ProgramTest, main


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


if __name__ == "__main__":
    main()
