"""Shared by the tests of `sweep`: a sweep of throws, and how it is run."""

import os
import random

from program import AGREED, ProgramTest
from sweep_members import base, datasets

SEED = int(os.environ.get("HYRAX_SEED", "0")) or random.SystemRandom().getrandbits(32)
NO_CLUSTER = {name: value for name, value in os.environ.items()
              if not name.startswith(("SLURM_", "OMPI_", "JOB_COMPLETION"))}


def document(**changes):
    """A sweep of 100 throws."""
    sweep = {"format": "hyrax-sweep/1", "base": base(), "members": 100, "seed": 7,
             "vary": {"/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/rate_hz": {"choice": [60, 120, 144]}},
             "keep": ["final", "contacts", "at_rest"], **changes}
    return {key: value for key, value in sweep.items() if value is not None}


class SweepTest(ProgramTest):
    """A sweep in its folder."""

    def sweep(self, *arguments, exit_code=AGREED, **options):
        """The command, outside a cluster."""
        return self.expect(exit_code, "sweep", *arguments, **{"env": NO_CLUSTER, **options})

    def computed(self, sweep, *arguments):
        """The datasets of its result."""
        self.write("sweep.json", sweep)
        self.sweep("sweep.json", *arguments)
        return datasets(self.folder / "sweep.h5")
