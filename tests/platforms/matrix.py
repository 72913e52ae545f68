"""The rows, built and played."""

import concurrent.futures
import subprocess
import sys
import time

from building import BuildFailed, build
from library import library
from playing import compiler_of, judge
from preloading import environment_for
from result import Result, hindrance_of
from wine import Wine


def tell(text):
    """On stderr, so that stdout holds nothing but the table."""
    print(text, file=sys.stderr, flush=True)


def flags_of(row):
    """All flags that the row adds to the project's."""
    return f"{row.flags} {row.last_flags}".strip()


class Matrix:
    """Plays rows in a scratch folder; holds them to golden files. Use it in a `with`: it may start a Wine."""

    def __init__(self, folder, golden):
        self.folder = folder
        self.scenarios = library(golden)
        self.wine = Wine(folder / "wine")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.wine.close()

    def play(self, rows, jobs):
        """The lines of these rows, in their order, `jobs` rows at a time."""
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            return [line for lines in pool.map(self.lines_told, rows) for line in lines]

    def lines_told(self, row):
        """The lines of a row; tells how long it took."""
        begin = time.monotonic()
        try:
            lines = list(self.lines_of(row))
        except (BuildFailed, subprocess.SubprocessError, OSError) as error:
            verdict = "FAILED to build or run"
            lines = [Result(row.name, row.compiler, flags_of(row), row.runs_on, verdict, True, str(error))]
        tell(f"{row.name:<32}{time.monotonic() - begin:6.1f} s  {lines[0].verdict}")
        return lines

    def lines_of(self, row):
        """The lines of a row that is built here."""
        if hindrance := hindrance_of(row, row.name, row.compiler, flags_of(row), row.runs_on):
            return [hindrance]
        if row.must.kind == "compiles":
            return [self.line_of_refused_build(row)]
        return self.lines_of_program(build(row, self.folder / row.folder), row)

    def lines_of_program(self, program, row):
        """The lines of a program that stands: as it is, and in all variants."""
        environment = self.wine.environment() if row.runs_on == "Wine" else {}
        told = (compiler_of(program, row, environment), flags_of(row), row.runs_on)
        yield Result(row.name, *told, *judge(program, row, self.scenarios, environment, row.must))
        for variant in row.variants:
            if hindrance := hindrance_of(variant, variant.name, *told):
                yield hindrance
                continue
            environment = environment_for(variant, self.folder / "preloaded")
            yield Result(variant.name, *told,
                         *judge(program, row, self.scenarios, environment, variant.must, variant.is_reversed))

    def line_of_refused_build(self, row):
        """The line of a row whose core must not compile."""
        told = (row.name, row.compiler, flags_of(row), "")
        try:
            build(row, self.folder / row.folder)
        except BuildFailed as failure:
            if row.must.sentence in str(failure):
                return Result(*told, f"refused by the compiler: {row.must.sentence}")
            return Result(*told, "FAILED for another reason", True, str(failure))
        return Result(*told, "NOT REFUSED by the compiler", True)
