"""A golden pair that is damaged in many ways, and the verdict of `check` on each."""

import json
import pathlib
import tempfile

from process import run, succeed
from program import PROGRAM

# The allowed exit codes for a damaged golden file; a signal is not allowed.
EXIT_CODES = {0, 1, 2, 3, 4}
_BATCH = 250


class GoldenPair:
    """A blessed scenario: its golden file's bytes, and its digest."""

    def __init__(self, document):
        self.document = json.dumps(document)
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as folder:
            scenario = pathlib.Path(folder, "scenarios/whole.json")
            scenario.parent.mkdir()
            scenario.write_text(self.document, encoding="utf-8")
            succeed(PROGRAM, "bless", "scenarios", "--reason", "for the test", cwd=folder)
            self.h5 = pathlib.Path(folder, "golden/whole.h5").read_bytes()
            self.txt = pathlib.Path(folder, "golden/whole.txt").read_bytes()

    def verdicts(self, damaged):
        """The verdict of `check` on each (.h5 file or None, summary or None): "agreed", "noted" (it agrees, with a note
        that its bytes differ from the blessed ones), a class, "missing" or "failed"."""
        found = []
        for first in range(0, len(damaged), _BATCH):
            found += self._verdicts(damaged[first:first + _BATCH])
        return found

    def _verdicts(self, damaged):
        """By one process, which must end by itself."""
        with tempfile.TemporaryDirectory(prefix="hyrax-test-") as place:
            folder = pathlib.Path(place)
            for name in ("scenarios", "golden"):
                (folder / name).mkdir()
            for number, (h5, txt) in enumerate(damaged):
                (folder / f"scenarios/{number:04}.json").write_text(self.document, encoding="utf-8")
                for suffix, content in (("h5", h5), ("txt", txt)):
                    if content is not None:
                        (folder / f"golden/{number:04}.{suffix}").write_bytes(content)
            outcome = run(PROGRAM, "check", "--json", cwd=folder)
        if outcome.exit_code not in EXIT_CODES or not outcome.out:  # A sanitizer's exit code is 1.
            raise AssertionError(f"check of {len(damaged)} damaged files: {outcome}")
        noted = {line.partition(": agrees, but ")[0] for line in outcome.err.splitlines()}
        return ["noted" if f"golden/{number:04}.h5" in noted else entry["class"] or entry["status"]
                for number, entry in enumerate(outcome.json["results"])]
