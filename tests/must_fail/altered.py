"""The altered cores: one program, the list of all cores, and the results of a study or `check` with one of them.

HYRAX_CONTROLS is the folder of the programs that are wrong on purpose.
"""

import functools
import os
import pathlib
import re
import tempfile

from process import run
from program import SOURCE

CONTROLS = pathlib.Path(os.environ["HYRAX_CONTROLS"])
ALTERED = CONTROLS / "control_altered"

# The same arithmetic in another order: no bit of any run changes.
SAME_BITS = {"none", "friction_before_restitution", "turn_before_clamp", "y_moves_before_x"}

# Constants are the parameters of the laws of hard-cases and of `fuzz`, which hold with any.
ONLY_CONSTANTS = {"gravity_by_one_ulp", "gravity_stronger", "restitution_softer", "friction_stronger", "friction_none",
                  "rest_earlier", "two_constants"}


def run_altered(core, *arguments, **options):
    """The program with that core, in the project's folder. Options: those of run."""
    return run(ALTERED, *arguments, env={**os.environ, "HYRAX_ALTERED_CORE": core}, **{"cwd": SOURCE, **options})


@functools.cache
def altered_cores():
    """All of them: {name: operation}."""
    return dict(line.split("\t") for line in run_altered("list").out.splitlines())


@functools.cache
def changed_steps():
    """Those that alter the step alone, and not what it is fed or what is made of its rows."""
    return [name for name, operation in altered_cores().items() if not re.search("clock|inputs|comparer", operation)]


@functools.cache
def studied(core, name, *options):
    """The outcome of the study with that core and --gate, with its JSON document."""
    with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
        return run_altered(core, "study", name, "--quick", "--gate", "--no-figures", "--json", "-o", folder, *options)
