"""A Windows of its own for a test: Wine in a folder that nothing else uses, and of which nothing stays alive.

HYRAX_WINE names the folder that `prepare` made.
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple

SKIPPED = 77
FOLDER = pathlib.Path(os.environ.get("HYRAX_WINE", "no-such-folder")).resolve()
FLINGER = FOLDER / "flinger.exe"
HYRAX = FOLDER / "mingw/bin/hyrax.exe"
HYRAX_REPLAY = FOLDER / "mingw/bin/hyrax-replay.exe"


def skip_without(*programs):
    """Ends the test file as skipped where a program is missing; where CI is set, that is a failure."""
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        print(f"{', '.join(missing)}: missing; tools/test --all installs it", file=sys.stderr)
        sys.exit(1 if os.environ.get("CI") == "true" else SKIPPED)


class Said(NamedTuple):
    """What a program came to."""

    exit_code: int
    out: str
    err: str


class Wine:
    """One prefix. Screenless, if no display is given. Only one at a time may use a prefix."""

    def __init__(self, display=None, **environment):
        self.prefix = FOLDER / ("prefix" if display is None else "prefix-x11")
        self.environment = {key: value for key, value in os.environ.items()
                            if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        self.environment.update(WINEPREFIX=str(self.prefix), WINEARCH="win64", WINEDEBUG="-all",
                                WINEDLLOVERRIDES="mscoree,mshtml=", HOME=str(FOLDER / "home"), **environment)
        if display is not None:
            self.environment["DISPLAY"] = display
        self.end()

    def start(self, program, *arguments, **options):
        """Starts a program and does not wait for it."""
        return subprocess.Popen(["wine", str(program), *map(str, arguments)], env=self.environment,
                                stdin=subprocess.DEVNULL, **options)

    def run(self, program, *arguments, timeout=60, **options):
        """Runs a program to its end. What it says goes through files: Wine's services may keep a pipe open."""
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            process = self.start(program, *arguments, stdout=out, stderr=err, **options)
            try:
                exit_code = process.wait(timeout)
            finally:
                process.kill()
                process.wait()
            said = []
            for file in (out, err):
                file.seek(0)
                said.append(file.read().decode(errors="replace").replace("\r\n", "\n"))
        return Said(exit_code, *said)

    def end(self):
        """Ends all that runs in the prefix, and waits until it is gone."""
        subprocess.run(["wineserver", "--kill"], env=self.environment, check=False, capture_output=True, timeout=30)
        try:
            subprocess.run(["wineserver", "--wait"], env=self.environment, check=False, capture_output=True, timeout=15)
        except subprocess.TimeoutExpired:
            pass
        # Now and then a service is left over, without a server and without a parent.
        for attempt in range(100):
            left = self.processes()
            if not left:
                return
            for process in left:
                try:
                    os.kill(process, signal.SIGTERM if attempt < 20 else signal.SIGKILL)
                except ProcessLookupError:
                    pass
            time.sleep(0.05)
        raise RuntimeError(f"processes {self.processes()} of {self.prefix} do not end")

    def processes(self):
        """Ids of the processes whose environment names this prefix."""
        mine = f"WINEPREFIX={self.prefix}".encode()
        found = []
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                variables = (entry / "environ").read_bytes().split(b"\0")
                is_dead = (entry / "stat").read_text().rpartition(")")[2].split()[0] == "Z"
            except OSError:
                continue
            if mine in variables and not is_dead:
                found.append(int(entry.name))
        return found
