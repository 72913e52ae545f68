"""Runs programs for all tests: without input, for a limited time, and without processes left running."""

import contextlib
import dataclasses
import json
import os
import select
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True  # A test leaves nothing behind in the source tree.

TIMEOUT_S = 300  # Enough for a build with sanitizers on a busy machine.
_CHUNK_BYTES = 1 << 16
_SKIPPED = 77  # To ctest, by SKIP_RETURN_CODE.
_IS_CI = os.environ.get("CI") == "true"


class TimedOut(Exception):
    """A program did not end in time; it was killed."""


class Failed(Exception):
    """A program ended with another exit code than it had to."""


@dataclasses.dataclass(frozen=True)
class Outcome:
    """The result of a program. The exit code is negative if a signal ended it."""

    exit_code: int
    out_bytes: bytes
    err_bytes: bytes

    @property
    def out(self):
        """Standard output, which must be UTF-8."""
        return self.out_bytes.decode()

    @property
    def err(self):
        """Standard error, which must be UTF-8."""
        return self.err_bytes.decode()

    @property
    def json(self):
        """The one document on standard output. `-0` keeps its sign, which json would take for the integer 0."""
        return json.loads(self.out_bytes, parse_int=lambda text: -0.0 if text == "-0" else int(text))

    def __str__(self):
        out, err = (stream.decode(errors="replace") for stream in (self.out_bytes, self.err_bytes))
        return f"exit code {self.exit_code}\n--- stdout\n{out}\n--- stderr\n{err}"


class Process:
    """A program that was started, in its own session. The rest of the session is killed when the program has ended.

    keeps_children: only the program itself is killed, never the processes that it started.
    Options: those of subprocess.Popen. By default there is no input, and both outputs are captured.
    """

    def __init__(self, *command, keeps_children=False, **options):
        self.command = [str(argument) for argument in command]
        self._keeps_children = keeps_children
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        # pylint: disable-next=consider-using-with
        self._popen = subprocess.Popen(self.command, bufsize=0, start_new_session=True, **options)
        self._printed = {stream: bytearray() for stream in (self._popen.stdout, self._popen.stderr) if stream}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    @property
    def id(self):
        """The id of the process and of its session."""
        return self._popen.pid

    @property
    def is_running(self):
        """Whether the program has not ended yet."""
        return self._popen.returncode is None and os.waitid(
            os.P_PID, self.id, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None

    def line(self):
        """The next line on standard output, without its end; waits for it."""
        return self._popen.stdout.readline().decode().rstrip("\n")

    def send(self, number):
        """Sends a signal to the program, if it is running."""
        self._popen.send_signal(number)

    def wait(self, timeout=TIMEOUT_S):
        """Waits for the end of the program; returns its outcome. Raises TimedOut."""
        if self._popen.returncode is None:
            has_ended = self._read_until_end(time.monotonic() + timeout)
            self._kill()
            self._read_rest()
            if not has_ended:
                raise TimedOut(f"{shlex.join(self.command)}: still running after {timeout} s\n{self._outcome()}")
        return self._outcome()

    def end(self):
        """Kills the program and what it started, if they are running."""
        if self._popen.returncode is None:
            self._kill()
        for stream in self._printed:
            stream.close()

    def _kill(self):
        # Until the program is waited for, the id of its session is not reused.
        with contextlib.suppress(ProcessLookupError):
            (os.kill if self._keeps_children else os.killpg)(self.id, signal.SIGKILL)
        self._popen.wait()
        if not self._keeps_children:
            self._wait_for_the_rest()

    def _wait_for_the_rest(self):
        # A killed process holds its locks until it has ended; one that nobody reaps stays in the session.
        give_up_s = time.monotonic() + 1
        with contextlib.suppress(ProcessLookupError):
            while time.monotonic() < give_up_s:
                os.killpg(self.id, 0)
                time.sleep(0.001)

    def _read_until_end(self, give_up_s):
        """Reads what is printed until the program has ended, even if another process keeps its outputs open."""
        ended = os.pidfd_open(self.id)
        try:
            watched = [ended, *self._printed]
            while ready := select.select(watched, [], [], max(0, give_up_s - time.monotonic()))[0]:
                if ended in ready:
                    return True
                for stream in ready:
                    chunk = os.read(stream.fileno(), _CHUNK_BYTES)
                    self._printed[stream] += chunk
                    if not chunk:
                        watched.remove(stream)
            return False
        finally:
            os.close(ended)

    def _read_rest(self):
        for stream, printed in self._printed.items():
            os.set_blocking(stream.fileno(), False)
            with contextlib.suppress(BlockingIOError):
                while chunk := os.read(stream.fileno(), _CHUNK_BYTES):
                    printed += chunk

    def _outcome(self):
        out, err = (bytes(self._printed.get(stream, b"")) for stream in (self._popen.stdout, self._popen.stderr))
        return Outcome(self._popen.returncode, out, err)


def is_alive(process_id):
    """Whether a process exists and is not a zombie."""
    with contextlib.suppress(OSError), open(f"/proc/{process_id}/stat", encoding="utf-8") as file:
        return file.read().rpartition(")")[2].split()[0] != "Z"
    return False


def preloading(library):
    """The variables with which a program loads a library before all others. Their folder may have a space in its name."""
    folder, name = os.path.split(library)
    return {"LD_PRELOAD": name, "LD_LIBRARY_PATH": folder,
            "ASAN_OPTIONS": "verify_asan_link_order=0:" + os.environ.get("ASAN_OPTIONS", "")}


def run(*command, timeout=TIMEOUT_S, exit_code=None, **options):
    """Runs a program to its end; returns its outcome. Options: those of Process. Raises TimedOut, and Failed if it ends with
    another exit code than the given one."""
    with Process(*command, **options) as process:
        outcome = process.wait(timeout)
    if exit_code not in (None, outcome.exit_code):
        raise Failed(f"{shlex.join(process.command)}: {outcome}")
    return outcome


def succeed(*command, **options):
    """As `run`, of a program that must end with 0."""
    return run(*command, exit_code=0, **options)


def skip_without(*programs):
    """Ends the test file as skipped if a program is missing; if CI is set, that is a failure."""
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        print(f"{', '.join(missing)}: missing; tools/test --all installs it", file=sys.stderr)
        sys.exit(1 if _IS_CI else _SKIPPED)


def skip_for_lack_of(what):
    """Skips a test that this machine cannot run; if CI is set, that is a failure."""
    raise AssertionError(f"CI needs {what}") if _IS_CI else unittest.SkipTest(f"no {what} here")


def skip_unless_installed(program):
    """Skips a test if a program is missing; if CI is set, that is a failure."""
    if shutil.which(program) is None:
        skip_for_lack_of(program)


# A process counts as held what the one that started it holds: a small one has to start what is measured.
_MEASURE = """import resource, subprocess, sys
exit_code = subprocess.call(sys.argv[2:])
with open(sys.argv[1], "w") as file:
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    file.write(f"{usage.ru_maxrss} {usage.ru_minflt}")
sys.exit(exit_code)"""


def run_measured(*command, **options):
    """As `run`; returns the outcome, the most bytes that the program or one that it started held, and the page faults of all."""
    with tempfile.NamedTemporaryFile() as file:
        outcome = run("/usr/bin/python3", "-S", "-E", "-c", _MEASURE, file.name, *command, **options)
        peak_kB, faults = map(int, file.read().split())
        return outcome, peak_kB * 1024, faults
