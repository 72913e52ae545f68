"""Shared by the tests of `check`: a project, and a golden file with one value changed."""

from program import FLING, ProgramTest

THIRD = {**FLING["start"], "vx_px_per_s": 1180}  # The start of the third throw.


def nudge(path, dataset, row):
    """Moves one value of a file to the next double."""
    # Not every test of a project reads HDF5, and loading it takes longer than many of them.
    # pylint: disable=import-outside-toplevel
    import h5py
    import numpy
    with h5py.File(path, "r+") as file:
        file[dataset][row] = numpy.nextafter(file[dataset][row], numpy.inf)


class CheckTest(ProgramTest):
    """A project with three throws."""

    def setUp(self):
        super().setUp()
        self.project("a/first", "a/second", "third")

    def check(self, exit_code, *arguments, **options):
        """The document of `check --json`."""
        return self.expect(exit_code, "check", "--json", *arguments, **options).json

    def counts(self, document):
        return tuple(document[key] for key in ("agreed", "disagreed", "missing", "failed"))
