"""Builds a mutant and runs `hyrax-sim check` on it: does it still agree with the golden files?"""

import concurrent.futures
import dataclasses
import pathlib
import shutil

from process import TimedOut, run
from workshop import CannotBuild

_JOBS = 2
# A check of all scenarios takes some hundredths of a second; with sanitizers, some tenths.
_SECONDS_MAX = 1
_SECONDS_MAX_SANITIZED = 5
_MEMORY_MAX_KIB = 4 << 20


@dataclasses.dataclass(frozen=True)
class Verdict:
    """The fate of a mutant: caught, survived, or refused by the compiler; and how it was caught.

    caught_by: the scenario, or the test.
    """

    fate: str
    caught_by: str = ""
    step: str = ""
    difference: str = ""


class Judge:
    """Checks mutants of a project against its scenarios and golden files."""

    def __init__(self, workshop, subjects, scenarios):
        self.workshop = workshop
        self.scenarios = pathlib.Path(scenarios)
        self.subject_of = {subject.path: subject for subject in subjects}
        self._units = sorted({unit for subject in subjects for unit in subject.units})
        self._original = {}

    def prepare(self):
        """Builds the unchanged units; their program must agree, or mutants would disagree for another reason."""
        place = self.workshop.folder / "unchanged"
        with concurrent.futures.ThreadPoolExecutor(_JOBS) as pool:
            self.workshop.prepare(self._units, self.subject_of, pool)
            objects = pool.map(lambda unit: self.workshop.compile(unit, place), self._units)
            self._original = dict(zip(self._units, objects, strict=True))
        self.workshop.link("hyrax-sim", self._original, place / "hyrax-sim")
        verdict = self._check(place / "hyrax-sim", [self.scenarios])
        if verdict is not None:
            raise CannotBuild(f"the unchanged program disagrees with {self.scenarios}: {verdict}")

    def try_out(self, mutant, name):
        """The verdict on a mutant; `name` is the name of its scratch folder."""
        place = self.workshop.folder / name
        subject = self.subject_of[mutant.path]
        try:
            return self._try_out(mutant, subject, place)
        except CannotBuild:
            return Verdict("refused")
        finally:
            shutil.rmtree(place, ignore_errors=True)

    def prepare_unit_tests(self, mutants):
        """Prepares the unit tests for these mutants; without a change each must pass within the time of a mutant."""
        subjects = {self.subject_of[mutant.path] for mutant in mutants}
        units = sorted({unit for subject in subjects for unit in subject.test_units})
        with concurrent.futures.ThreadPoolExecutor(_JOBS) as pool:
            self.workshop.prepare(units, self.subject_of, pool)
        for subject in subjects:
            if self._fails(subject, self.workshop.folder / f"unchanged-{subject.test}"):
                raise CannotBuild(f"{subject.test} fails, or takes too long, without any change")

    def fails_unit_test(self, mutant, name):
        """Whether the subject's unit tests fail with the mutant."""
        return self._fails(self.subject_of[mutant.path], self.workshop.folder / name, mutant)

    def _fails(self, subject, place, mutant=None):
        try:
            objects = {unit: self.workshop.compile(unit, place, mutant) for unit in subject.test_units}
            self.workshop.link(subject.test, objects, place / subject.test)
            done = self._limited([place / subject.test, "--gtest_brief=1", "--gtest_fail_fast"])
            return done is None or done.exit_code != 0
        finally:
            shutil.rmtree(place, ignore_errors=True)

    def _try_out(self, mutant, subject, place):
        objects = {unit: self.workshop.compile(unit, place, mutant) for unit in subject.units_for(mutant)}
        if all(unit in self._original and path.read_bytes() == self._original[unit].read_bytes()
               for unit, path in objects.items()):
            return Verdict("survived")  # The same code.
        program = place / "hyrax-sim"
        self.workshop.link("hyrax-sim", objects, program)
        likely = [path for path in (self.scenarios / f"{name}.json" for name in subject.likely) if path.exists()]
        found = self._check(program, likely) if likely else None
        return found or self._check(program, [self.scenarios]) or Verdict("survived")

    def _check(self, program, paths):
        """How a check of these scenarios disagrees; None if it agrees."""
        done = self._limited([program, "check", "--json", "--jobs", "1", *paths])
        if done is None or done.exit_code < 0 or done.exit_code > 128:
            return Verdict("caught", difference="hangs" if done is None or self._is_late(done) else "crashes")
        if done.exit_code == 0:
            return None
        if not done.out:
            return Verdict("caught", difference="fails")
        entries = done.json["results"]
        by_path = {entry["scenario"]: entry for entry in entries}
        order = [str(path) for path in paths if str(path) in by_path] or list(by_path)
        entry = by_path[next(path for path in order if by_path[path]["status"] != "agreed")]
        first = entry["first_divergence"] or {}
        scenario = pathlib.Path(entry["scenario"]).relative_to(self.scenarios).with_suffix("")
        kind = entry["class"] or ("failed" if entry["status"] == "failed" else "expect")
        return Verdict("caught", str(scenario), str(first.get("step", "")), kind)

    def _limited(self, command):
        """Runs a program that may not end; None if it exceeds its time."""
        memory = "" if self.workshop.is_sanitized else f"ulimit -v {_MEMORY_MAX_KIB}; "
        seconds = _SECONDS_MAX_SANITIZED if self.workshop.is_sanitized else _SECONDS_MAX
        script = f'ulimit -c 0; ulimit -t {seconds}; {memory}exec "$@"'
        try:
            return run("sh", "-c", script, "sh", *command, cwd=self.workshop.source)
        except TimedOut:
            return None

    @staticmethod
    def _is_late(done):
        return done.exit_code in (-24, -9, 128 + 24, 128 + 9)  # SIGXCPU, then SIGKILL.
