"""Builds the program with one changed file: only the affected units, linked before those of an existing build.

The flags are those of the build with -O1 instead of -O3: half the time, and the same bits. The linker is the
fastest one installed.
"""

import json
import pathlib
import re
import shlex
import shutil

from process import Failed, succeed

_INCLUDE = re.compile(r'^#include (<[\w/.]+>|"[\w/.]+")', re.MULTILINE)
_CORE = '"sim/physics/physics.h"'
_LEFT_OUT = re.compile(r"-O.|-O|-g\d?|-W.*|-M[MDP]*|-flto.*")


class CannotBuild(Exception):
    """The compiler refuses."""


def _run(command, folder):
    try:
        succeed(*command, cwd=folder)
    except Failed as failure:
        raise CannotBuild(str(failure)) from failure


class Workshop:
    """A build of the project, and a folder to work in."""

    def __init__(self, source, build, folder):
        self.source = pathlib.Path(source).resolve()
        self.build = pathlib.Path(build).resolve()
        self.folder = pathlib.Path(folder).resolve()
        self._commands = self._compile_commands()
        self._links = {}
        self._prepared = {}
        self._reached = {}
        quick = [name for name in ("lld", "gold") if shutil.which(f"ld.{name}")]
        self._linker = [f"-fuse-ld={name}" for name in quick[:1]]

    def prepare(self, units, changed, pool):
        """Precompiles the headers of the units, most of the work, except those that include what is changed."""
        changed = {f'"{path}"' for path in changed}
        commands = []
        for flags in {tuple(self._flags(unit)) for unit in units} - set(self._prepared):
            header = self.folder / f"prepared-{len(self._prepared)}" / "prepared.h"
            header.parent.mkdir(parents=True)
            own = {f'"{unit}"' for unit in units if tuple(self._flags(unit)) == flags}
            included = set().union(*map(self._reach, own)) - own
            names = sorted(name for name in included if changed.isdisjoint(self._reach(name)))
            header.write_text("".join(f"#include {name}\n" for name in names), encoding="utf-8")
            commands.append([*flags, "-x", "c++-header", str(header), "-o", f"{header}.gch"])
            self._prepared[flags] = header
        list(pool.map(lambda command: _run(command, self.build), commands))

    def compile(self, unit, place, mutant=None):
        """The unit's object file in the folder `place`, with the mutant's file in the original's stead."""
        place.mkdir(parents=True, exist_ok=True)
        source = self.source / unit
        flags = self._flags(unit)
        shared = ["-include", str(self._prepared[tuple(flags)])] if tuple(flags) in self._prepared else []
        changed, more_flags = [], []
        if mutant is not None:
            copy = place / mutant.path
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(mutant.text_of((self.source / mutant.path).read_text(encoding="utf-8")), encoding="utf-8")
            source = copy if mutant.path == unit else source
            changed, more_flags = ["-I", str(place)], mutant.flags
            shared = [] if more_flags else shared  # Other flags than it was prepared with.
        result = place / (unit.replace("/", "-") + ".o")
        _run([flags[0], *changed, *flags[1:], *more_flags, *shared, "-c", str(source), "-o", str(result)], self.build)
        return result

    def link(self, target, objects, result):
        """The program of a target, with these objects ({unit: path}) before those of the build."""
        command, folder = self._link_command(target)
        first = []
        for unit, path in objects.items():
            own = self._commands[unit][self._commands[unit].index("-o") + 1]
            if own in command:
                command = [str(path) if part == own else part for part in command]
            else:
                first.append(str(path))  # The linker then takes no definition from an archive.
        place = command.index("-o")
        _run([command[0], *self._linker, *first, *command[1:place], "-o", str(result), *command[place + 2:]], folder)

    @property
    def is_sanitized(self):
        """Whether the build's programs need more memory than they use."""
        return any("-fsanitize" in part for command in self._commands.values() for part in command)

    def _reach(self, name):
        """A header's name as written after #include, and the names of all project headers that it includes."""
        if name not in self._reached:
            self._reached[name] = {name}
            if name.startswith('"'):
                text = self.source.joinpath(name.strip('"')).read_text(encoding="utf-8")
                self._reached[name] = {name}.union(*map(self._reach, _INCLUDE.findall(text)))
        return self._reached[name]

    def _compile_commands(self):
        commands = {}
        for entry in json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8")):
            unit = pathlib.Path(entry["file"])
            command = shlex.split(entry["command"])
            is_control = "must_fail" in entry.get("output", command[command.index("-o") + 1])
            if unit.is_relative_to(self.source) and not is_control:
                commands.setdefault(str(unit.relative_to(self.source)), command)
        return commands

    def _flags(self, unit):
        """Compiler and flags of a unit."""
        command = list(self._commands[unit])
        while not re.search(r"(\+\+|cc|clang)[-\d.]*$", command[0]) or command[0].endswith("ccache"):
            command.pop(0)
        for option in ("-o", "-c", "-MF", "-MT"):
            if option in command:
                del command[command.index(option):command.index(option) + 2]
        command = [part for part in command if not _LEFT_OUT.fullmatch(part)] + ["-O1", "-w"]
        # The other objects of the program keep the shipped class; under its name no second one may be defined.
        return [*command, "-Dphysics=mutated_physics"] if _CORE in self._reach(f'"{unit}"') else command

    def _link_command(self, target):
        if target not in self._links:
            self._links[target] = self._ninja_link(target) if (self.build / "build.ninja").exists() else (
                self._make_link(target))
        return self._links[target]

    def _ninja_link(self, target):
        commands = succeed("ninja", "-C", self.build, "-t", "commands", target).out
        command = [part for part in shlex.split(commands.splitlines()[-1]) if part not in (":", "&&")]
        return command, self.build

    def _make_link(self, target):
        script = next(self.build.rglob(f"{target}.dir/link.txt"))
        return shlex.split(script.read_text(encoding="utf-8")), script.parents[2]
