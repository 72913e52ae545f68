"""Shared by the tests of `check` and `bless`: projects, and a golden file with one value changed."""

import shutil
import tempfile

from program import ProgramTest


def nudge(path, dataset, row):
    """Moves one value of a file to the next double."""
    # Not every test of a project reads HDF5, and loading it takes longer than many of them.
    # pylint: disable=import-outside-toplevel
    import h5py
    import numpy
    with h5py.File(path, "r+") as file:
        file[dataset][row] = numpy.nextafter(file[dataset][row], numpy.inf)


class ProjectTest(ProgramTest):
    """Copies a project that was made before, if the folder is empty."""

    _made = {}

    def project(self, *names):
        if self.names():
            return super().project(*names)
        if names not in self._made:
            self._made[names] = tempfile.TemporaryDirectory(prefix="hyrax-test-project-"), super().project(*names)
            shutil.copytree(self.folder, self._made[names][0].name, dirs_exist_ok=True)
        else:
            shutil.copytree(self._made[names][0].name, self.folder, dirs_exist_ok=True)
        return self._made[names][1]


class CheckTest(ProjectTest):
    """A project with three throws."""

    def setUp(self):
        super().setUp()
        self.project("a/first", "a/second", "third")

    def check(self, exit_code, *arguments, **options):
        """The document of `check --json`."""
        return self.expect(exit_code, "check", "--json", *arguments, **options).json

    def summaries(self):
        """The .txt of every golden file."""
        return [path.with_suffix(".txt") for path in self.folder.glob("golden/**/*.h5")]

    def counts(self, document):
        """agreed, disagreed, missing and failed."""
        return tuple(document[key] for key in ("agreed", "disagreed", "missing", "failed"))
