#!/usr/bin/python3
"""Builds everything that the tests of hyrax.exe need, in the folder that HYRAX_WINE names:

    mingw/         the preset `mingw`, built: hyrax.exe and hyrax-replay.exe
    flinger.exe    the hand
    prefix/        a Windows without a screen: Wine's null graphics driver
    prefix-x11/    the same one, with X for a screen

Prefixes that exist already stay. The exit code is 77 if a program is missing, so that the tests are skipped.
"""

import os
import shutil

from hyrax_program import FLINGER, FOLDER
from process import skip_without, succeed
from program import SOURCE
from wine import Wine

COMPILER = "x86_64-w64-mingw32-g++-posix"
BUILD_S_MAX = 900


def build_programs():
    """Configured from scratch: an existing cache would ignore a changed toolchain file."""
    succeed("cmake", "--fresh", "--log-level=WARNING", "-S", SOURCE, "-B", FOLDER / "mingw", "--preset", "mingw",
            f"-DHYRAX_WERROR={os.environ['HYRAX_WERROR']}")
    succeed("ninja", "-C", FOLDER / "mingw", timeout=BUILD_S_MAX)
    succeed(COMPILER, "-std=c++20", "-O1", "-Wall", "-Wextra", "-municode", "-static", "-s",
            SOURCE / "tests/cli/hyrax/flinger.cpp", "-o", FLINGER)


def make_prefixes():
    """A prefix takes 700 MB; the second one shares the first one's disk."""
    screenless, on_screen = Wine(FOLDER / "prefix"), FOLDER / "prefix-x11"
    screenless.make()
    shutil.rmtree(on_screen, ignore_errors=True)
    on_screen.mkdir()
    for path in (*screenless.prefix.glob("*.reg"), screenless.prefix / ".update-timestamp"):
        shutil.copy2(path, on_screen)
    shutil.copytree(screenless.prefix / "dosdevices", on_screen / "dosdevices", symlinks=True)
    (on_screen / "drive_c").symlink_to(screenless.prefix / "drive_c")
    screenless.call("wine", "reg", "add", r"HKCU\Software\Wine\Drivers", "/v", "Graphics", "/d", "null", "/f")


if __name__ == "__main__":
    skip_without("wine", "wineserver", COMPILER)
    FOLDER.mkdir(parents=True, exist_ok=True)
    build_programs()
    if not (FOLDER / "prefixes-are-whole").exists():
        make_prefixes()
        (FOLDER / "prefixes-are-whole").touch()
