"""Edited cores, played by what their headers were traced to be: hyrax-sim need not be compiled for each.

HYRAX_CONTROLS is the folder of the programs that are wrong on purpose, HYRAX_BUILD that of the build, whose compiler
and flags trace an edited header as tools/cmake/record_core.cmake does.
"""

import dataclasses
import functools
import os
import pathlib
import re
import shutil
import tempfile

from process import run, succeed
from program import SOURCE

TRACED = pathlib.Path(os.environ["HYRAX_CONTROLS"]) / "control_traced"
SHIPPED = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
_INCLUDED = (SOURCE / "sim/physics/strict_arithmetic.h").read_text(encoding="utf-8")
_FOLDER = tempfile.TemporaryDirectory(prefix="hyrax-test-traced-")

# Of 1e7 steps and more, left out of the library that edited cores play.
_LONG = ("hard/ten-million-steps", "edges/frames-past-a-float")


def _copied_library():
    """A folder with the project's scenarios and golden files."""
    folder = pathlib.Path(_FOLDER.name) / "library"
    for name in ("scenarios", "golden"):
        shutil.copytree(SOURCE / name, folder / name)
    for name in _LONG:
        for path in (f"scenarios/{name}.json", f"golden/{name}.h5", f"golden/{name}.txt"):
            (folder / path).unlink()
    return folder


LIBRARY = _copied_library()


@functools.cache
def settings():
    """The build's own: {name: list of words}."""
    text = (pathlib.Path(os.environ["HYRAX_BUILD"]) / "sim/hyrax_core_record/settings.cmake").read_text(encoding="utf-8")
    return {name: [word for word in value.split(";") if word]
            for name, value in re.findall(r"^set\((\w+) \[==\[(.*)\]==\]\)$", text, re.MULTILINE)}


@dataclasses.dataclass(frozen=True)
class TracedCore:
    """A header, and its step or why it is not complete."""

    header: pathlib.Path
    step: pathlib.Path
    why: str

    def run(self, *arguments, env=None, **options):
        """The program with this core, in the folder of the library. One without a step plays the shipped core's."""
        step, why = (self.step, {}) if not self.why else (SOURCE / "golden/core/step.txt", {"HYRAX_TRACED_WHY": self.why})
        environment = {**(env or os.environ), **why, "HYRAX_TRACED_HEADER": str(self.header), "HYRAX_TRACED_STEP": str(step)}
        return run(TRACED, *arguments, cwd=LIBRARY, env=environment, **options)


@functools.cache
def traced(text):
    """The core whose header has that text. Takes a second."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=_FOLDER.name))
    header, step, why, program = (folder / name for name in ("physics.h", "step.txt", "why.txt", "record_step"))
    header.write_text(text, encoding="utf-8")
    prelude = folder / "prelude.h"
    prelude.write_text("".join(f"#include {name}\n" for name in re.findall(r"^#include (<\w+>)", text + _INCLUDED, re.MULTILINE)))
    given = settings()
    root = given["root"][0]
    succeed(*given["compiler"], *given["flags"], *(f"-D{name}" for name in given.get("definitions", ())), f"-I{root}", "-w",
            f'-DHYRAX_CORE_HEADER="{header}"', f'-DHYRAX_CORE_PRELUDE="{prelude}"', "-DHYRAX_TRACES_BOOL", "-O0", "-g0",
            f"{root}/sim/trace/host/programs/record_step.cpp", *given["libraries"], "-o", program)
    succeed(program, step, why)
    return TracedCore(header, step, why.read_text() if why.exists() else "")
