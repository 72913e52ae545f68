"""Edited cores, played by what their headers were traced to be: hyrax-sim need not be compiled for each.

HYRAX_CONTROLS is the folder of the programs that are wrong on purpose, HYRAX_BUILD that of the build, whose compiler
and flags trace edited headers as tools/cmake/record_core.cmake does. HYRAX_ALL_EDITS is set: they play the whole library.
"""

import functools
import os
import pathlib
import re
import shutil
import tempfile
import threading

from process import run, succeed
from program import SOURCE

TRACED = pathlib.Path(os.environ["HYRAX_CONTROLS"]) / "control_traced"
SHIPPED = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
_FOLDER = tempfile.TemporaryDirectory(prefix="hyrax-test-traced-")


def _copied_library():
    """A folder with scenarios and golden files of the project: every wall, the corners and rest; or all but runs of 1e7 steps."""
    folder = pathlib.Path(_FOLDER.name) / "library"
    parts = ("",) if "HYRAX_ALL_EDITS" in os.environ else ("flings", "paper")
    for path in [*(f"{name}/{part}" for name in ("scenarios", "golden") for part in parts), "golden/core"]:
        shutil.copytree(SOURCE / path, folder / path, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("ten-million-steps.*", "frames-past-a-float.*"))
    return folder


LIBRARY = _copied_library()


def settings():
    """The build's own: {name: list of words}."""
    text = (pathlib.Path(os.environ["HYRAX_BUILD"]) / "sim/hyrax_core_record/settings.cmake").read_text(encoding="utf-8")
    return {name: [word for word in value.split(";") if word]
            for name, value in re.findall(r"^set\((\w+) \[==\[(.*)\]==\]\)$", text, re.MULTILINE)}


class TracedCore:
    """A header, and its step or why it is not complete."""

    def __init__(self, folder):
        self.header, self.step, self.why_file = (folder / name for name in ("physics.h", "step.txt", "why.txt"))

    @property
    def why(self):
        """Why the step is not complete; empty where it is."""
        trace()
        return self.why_file.read_text(encoding="utf-8") if self.why_file.exists() else ""

    @property
    def environment(self):
        """What tells the program to play it. One without a step plays the shipped core's."""
        step, why = (SOURCE / "golden/core/step.txt", {"HYRAX_TRACED_WHY": self.why}) if self.why else (self.step, {})
        return {**why, "HYRAX_TRACED_HEADER": str(self.header), "HYRAX_TRACED_STEP": str(step)}

    def run(self, *arguments, env=None, **options):
        """The program with this core, in the folder of the library; `check` plays random flings only where --flings says so."""
        if arguments[0] == "check" and "--flings" not in arguments:
            arguments = (*arguments, "--flings", "0")
        return run(TRACED, *arguments, cwd=LIBRARY, env={**(env or os.environ), **self.environment}, **options)


_UNTRACED = []
_TRACING = threading.Lock()


@functools.cache
def traced(text):
    """The core whose header has that text. It is traced when it is used, with all others that are not yet."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=_FOLDER.name))
    (folder / "physics.h").write_text(text, encoding="utf-8")
    _UNTRACED.append(TracedCore(folder))
    return _UNTRACED[-1]


def trace():
    """Traces cores by one program: its own headers take most of the time that its compiler takes."""
    with _TRACING:
        if not _UNTRACED:
            return
        program, source = (pathlib.Path(_FOLDER.name) / name for name in ("record_steps", "record_steps.cpp"))
        headers = "".join(core.header.read_text(encoding="utf-8") for core in _UNTRACED)
        included = [*sorted(set(re.findall(r"^#include (<\w+>)", headers, re.MULTILINE))), '"sim/physics/strict_arithmetic.h"',
                    "<cstdlib>", '"sim/trace/host/explorer.h"', '"sim/trace/host/number_functions.h"']
        text = "".join(f"#include {name}\n" for name in included)  # Before the namespaces.
        for number, core in enumerate(_UNTRACED):
            text += (f'#define HYRAX_CORE_HEADER "{core.header}"\nnamespace core_{number} {{\n'
                     '#include "sim/trace/host/programs/record_step.cpp"\n}\n#undef HYRAX_CORE_HEADER\n')
        mains = ", ".join(f"core_{number}::main" for number in range(len(_UNTRACED)))
        source.write_text(f"{text}int main(int count, char** words) {{\n  int (*const mains[])(int, char**) = {{{mains}}};\n"
                          "  return mains[std::atoi(words[1])](count - 1, words + 1);\n}\n", encoding="utf-8")
        given = settings()  # Not optimised: the bits are the same.
        succeed(*given["compiler"], *given["flags"], *(f"-D{name}" for name in given.get("definitions", ())),
                f"-I{given['root'][0]}", "-w", "-O0", "-g0", "-DHYRAX_CORE_PRELUDE=<cmath>", "-DHYRAX_TRACES_BOOL", source,
                *given["libraries"], "-o", program)
        for number, core in enumerate(_UNTRACED):
            succeed(program, str(number), core.step, core.why_file)
        _UNTRACED.clear()


SHIPPED_CORE = traced(SHIPPED)
