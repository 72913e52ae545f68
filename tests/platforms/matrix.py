"""The rows, built and played."""

import concurrent.futures
import functools
import os
import sys
import threading
import time

from building import build, environment_for
from playing import compiler_of, judge, library
from process import Failed, TimedOut, run
from result import Result, hindrance_of
from rows import PROJECT
from wine import Wine

TIMEOUT_S = 600


def log(text):
    """Prints to stderr; stdout has the table only."""
    print(text, file=sys.stderr, flush=True)


def flags_of(row):
    """All flags that the row adds to the project's."""
    return f"{row.flags} {row.last_flags}".strip()


def again_after_signal(start, *arguments):
    """The outcome of a program in node; of a second start where a signal ended the first, which is a fault of node's own."""
    outcome = start(*arguments)
    return start(*arguments) if outcome.exit_code < 0 else outcome


class Matrix:
    """Plays rows in a scratch folder and compares them with golden files. Use it in a `with`: it may start Wine."""

    def __init__(self, folder, golden):
        self.folder = folder
        self.scenarios = library(golden)
        self._wine = None
        self._wine_lock = threading.Lock()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._wine is not None:
            self._wine.end()

    def wine(self):
        """A prefix that all rows share, created on first use."""
        with self._wine_lock:
            if self._wine is None:
                self._wine = Wine(self.folder / "wine")
                self._wine.make()
            return self._wine

    def starter(self, program, row, environment):
        """A function that runs a program of the row with arguments, and returns its outcome."""
        options = {"cwd": PROJECT, "timeout": TIMEOUT_S}
        if row.runs_on == "Wine":
            return functools.partial(self.wine().run, program, **options)
        start = functools.partial(run, *row.runner, program, env={**os.environ, **environment}, **options)
        return functools.partial(again_after_signal, start) if row.runs_on == "node" else start

    def play(self, rows, jobs):
        """The lines of these rows, in their order, `jobs` rows at a time."""
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            return [line for lines in pool.map(self.timed_lines, rows) for line in lines]

    def timed_lines(self, row):
        """The lines of a row; logs how long it took."""
        begin = time.monotonic()
        try:
            lines = list(self.lines_of(row))
        except (Failed, TimedOut, OSError) as error:
            verdict = "FAILED to build or run"
            lines = [Result(row.name, row.compiler, flags_of(row), row.runs_on, verdict, True, str(error))]
        log(f"{row.name:<32}{time.monotonic() - begin:6.1f} s  {lines[0].verdict}")
        return lines

    def lines_of(self, row):
        """The lines of a row that is built here."""
        if hindrance := hindrance_of(row, row.name, row.compiler, flags_of(row), row.runs_on):
            return [hindrance]
        if row.must.kind == "compiles":
            return [self.line_of_refused_build(row)]
        return self.lines_of_program(build(row, self.folder / row.folder), row)

    def lines_of_program(self, program, row):
        """The lines of a built program: as it is, and in all variants."""
        start = self.starter(program, row, {})
        columns = (compiler_of(start, row), flags_of(row), row.runs_on)
        yield Result(row.name, *columns, *judge(start, row, self.scenarios, row.must))
        for variant in row.variants:
            if hindrance := hindrance_of(variant, variant.name, *columns):
                yield hindrance
                continue
            start = self.starter(program, row, environment_for(variant, self.folder / "preloaded"))
            yield Result(variant.name, *columns, *judge(start, row, self.scenarios, variant.must, variant.is_reversed))

    def line_of_refused_build(self, row):
        """The line of a row whose core must not compile."""
        columns = (row.name, row.compiler, flags_of(row), "")
        try:
            build(row, self.folder / row.folder)
        except Failed as failure:
            if row.must.sentence in str(failure):
                return Result(*columns, f"refused by the compiler: {row.must.sentence}")
            return Result(*columns, "FAILED for another reason", True, str(failure))
        return Result(*columns, "NOT REFUSED by the compiler", True)
