"""Facts about a ninja build of the project: which programs each test runs, and which objects contain a source."""

import collections
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys

PROGRAM = "bin/hyrax-sim"


class CannotBuild(Exception):
    """The build, or its tests, cannot be used."""


@dataclasses.dataclass(frozen=True)
class Test:
    """A test of the everyday set.

    folder: that of the CMakeLists.txt which registers it, in the project.
    programs: what it runs of the build; all of a folder if it is given that.
    """

    name: str
    folder: pathlib.PurePath
    programs: frozenset

    def is_of_folder(self, path):
        """Whether it is the unit test of this source's folder."""
        above = pathlib.PurePath("tests/unit")
        return self.folder.is_relative_to(above) and path.is_relative_to(self.folder.relative_to(above))


def printed(*command):
    """What a command writes to its standard output. Raises an error if it fails."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


class Build:
    """Facts about a build of the project, which is brought up to date and then only read.

    of_units_only: of its tests only the unit tests are wanted.
    """

    def __init__(self, source, build, of_units_only=False):
        self.source, self.folder = source.resolve(), build.resolve()
        self.tests = [test for test in self._tests() if not of_units_only or test.name.startswith("unit.")]
        self.programs = programs = {PROGRAM}.union(*(test.programs for test in self.tests))
        command = ["ninja", "-C", self.folder, "--quiet", *programs]
        if not self.tests or subprocess.run(command, check=False, stdout=sys.stderr).returncode != 0:
            raise CannotBuild(f"{build}: its tests cannot be built")
        self.objects = self._objects()
        self._inputs = {program: set(printed("ninja", "-C", self.folder, "-t", "inputs", program).splitlines())
                        for program in programs}

    def tests_of(self, path):
        """The tests that run a program with code of this source."""
        programs = {program for program, inputs in self._inputs.items() if not inputs.isdisjoint(self.objects[path])}
        return [test for test in self.tests if not test.programs.isdisjoint(programs)]

    def _objects(self):
        """{source of the project: the objects that are compiled from it}"""
        objects = collections.defaultdict(set)
        for line in printed("ninja", "-C", self.folder, "-t", "deps").splitlines():
            if line.startswith(" "):
                path = pathlib.Path(os.path.normpath(self.folder / line.strip()))
                if path.is_relative_to(self.source):
                    objects[str(path.relative_to(self.source))].add(current)
            else:
                current = line.partition(": #deps")[0]
        return objects

    def _tests(self):
        lines = printed("ninja", "-C", self.folder, "-t", "targets", "all").splitlines()
        targets = dict(line.rpartition(": ")[::2] for line in lines if not line.startswith("/"))  # What is built.
        known = json.loads(printed("ctest", "--test-dir", self.folder, "--show-only=json-v1", "-L", "everyday"))
        return [self._test(entry, known["backtraceGraph"], targets) for entry in known["tests"]]

    def _test(self, entry, graph, targets):
        properties = {each["name"]: each["value"] for each in entry["properties"]}
        node = graph["nodes"][entry["backtrace"]]
        while "command" in graph["nodes"][node["parent"]]:
            node = graph["nodes"][node["parent"]]
        folder = pathlib.Path(graph["files"][node["file"]]).parent
        parts = re.split(r"[=;]", ";".join([*entry["command"], *properties.get("ENVIRONMENT", [])]))
        paths = {part.removeprefix(f"{self.folder}/") for part in parts}
        programs = frozenset(target for target, rule in targets.items() if target in paths
                             or "_EXECUTABLE_LINKER" in rule and target.rpartition("/")[0] in paths)
        return Test(entry["name"], folder.relative_to(self.source), programs)
