"""A Windows of its own for the rows that run under Wine."""

import os
import subprocess
import threading

SETUP_S_MAX = 180
END_S_MAX = 60


class Wine:
    """Made when first wanted, ended with `close`; needs no screen."""

    def __init__(self, folder):
        self.folder = folder
        self.lock = threading.Lock()
        self.is_up = False

    def environment(self):
        """What a program is run with under Wine."""
        with self.lock:
            if not self.is_up:
                self.folder.mkdir(parents=True, exist_ok=True)
                self.call("wineboot", "-i", timeout=SETUP_S_MAX)
                self.is_up = True
        return self.settings()

    def close(self):
        """Ends what Wine keeps running."""
        if self.is_up:
            self.call("wineserver", "-k", timeout=END_S_MAX)
            self.call("wineserver", "-w", timeout=END_S_MAX)

    def settings(self):
        """Where it lives, and that it neither draws nor talks."""
        return {"WINEPREFIX": str(self.folder), "WINEARCH": "win64", "WINEDEBUG": "-all", "DISPLAY": "",
                "WINEDLLOVERRIDES": "mscoree,mshtml="}

    def call(self, *command, timeout):
        """Runs a command of Wine's."""
        subprocess.run(command, env={**os.environ, **self.settings()}, stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=timeout, check=False)
