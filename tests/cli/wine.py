"""Wine in its own prefix, whose processes are ended; and a virtual screen."""

import os
import pathlib
import shutil
import signal
import subprocess
import time

from process import Outcome, Process, TimedOut, run, succeed

SETUP_S_MAX = 180


class Screen:
    """An X server that shows nothing to anybody."""

    def __init__(self, width_px, height_px):
        self._server = Process("Xvfb", "-displayfd", "1", "-screen", "0", f"{width_px}x{height_px}x24", "-noreset",
                               "-nolisten", "tcp", stderr=subprocess.DEVNULL)
        self.display = f":{self._server.line()}"

    def end(self):
        """Ends the server, which removes its lock file."""
        self._server.send(signal.SIGTERM)
        self._server.wait()
        self._server.end()


class Wine:
    """One prefix: on a display, or without a screen. Only one at a time may use a prefix."""

    def __init__(self, prefix, display=None):
        self.prefix = pathlib.Path(prefix)
        self.environment = {key: value for key, value in os.environ.items()
                            if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        self.environment.update(WINEPREFIX=str(self.prefix), WINEARCH="win64", WINEDEBUG="-all",
                                WINEDLLOVERRIDES="mscoree,mshtml=", HOME=str(self.prefix.parent / "home"))
        if display is not None:
            self.environment["DISPLAY"] = display

    def make(self):
        """Creates the prefix (700 MB), replacing an older one."""
        shutil.rmtree(self.prefix, ignore_errors=True)
        pathlib.Path(self.environment["HOME"]).mkdir(parents=True, exist_ok=True)
        self.call("wineboot", "--init")

    def call(self, *command):
        """Runs one of Wine's own commands, which must succeed, and waits until its changes are stored."""
        for arguments in (command, ("wineserver", "--wait")):
            succeed(*arguments, env=self.environment, keeps_children=True, timeout=SETUP_S_MAX)

    def start(self, program, *arguments, **options):
        """Starts a program. It shares Wine's services with others; `end` stops them."""
        return Process("wine", program, *arguments, env=self.environment, keeps_children=True, **options)

    def run(self, program, *arguments, timeout=60, **options):
        """Runs a program to its end; returns its outcome, with the line ends of this system.

        A program that hangs is started a second time: on a busy machine one did, once, which played alone did not."""
        for is_last in (False, True):
            try:
                with self.start(program, *arguments, **options) as process:
                    outcome = process.wait(timeout)
                break
            except TimedOut:
                if is_last:
                    raise
        return Outcome(outcome.exit_code, *(text.decode(errors="replace").replace("\r\n", "\n").encode()
                                            for text in (outcome.out_bytes, outcome.err_bytes)))

    def end(self):
        """Ends all that runs in the prefix, and waits until it is gone."""
        run("wineserver", "--kill", env=self.environment)
        try:
            run("wineserver", "--wait", env=self.environment, timeout=15)
        except TimedOut:
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
