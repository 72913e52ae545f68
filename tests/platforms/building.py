"""Builds the program of a row, and the libraries and the locale that variants are run with."""

import functools
import os
import pathlib
import threading

from process import Failed, preloading, succeed
from rows import HERE, PROJECT

TIMEOUT_S = 1800
SOURCES = {"locale": HERE / "preloaded/locale.c", "fast_math": HERE / "preloaded/fast_math.c",
           "rounding": PROJECT / "tests/cli/disturbed_arithmetic.c"}

_RECORDING = threading.Lock()


def core_record(folder):
    """The record of the core, which every platform shares: HYRAX_CORE_RECORD, else traced once in the scratch folder."""
    if "HYRAX_CORE_RECORD" in os.environ:
        return pathlib.Path(os.environ["HYRAX_CORE_RECORD"])
    build_folder = folder / "core_record"
    with _RECORDING:
        succeed("cmake", "--log-level=WARNING", "-S", PROJECT, "-B", build_folder, "-G", "Ninja", "-DHYRAX_SIM=OFF",
                timeout=TIMEOUT_S)
        succeed("ninja", "-C", build_folder, "-j1", "hyrax_core_record", timeout=TIMEOUT_S)
    return build_folder / "sim/hyrax_core_record"


def settings_of(row, folder):
    yield "CMAKE_BUILD_TYPE=None"  # Adds no flags of its own.
    yield "HYRAX_SIM=OFF"
    yield "HYRAX_REPLAY_CHECK=OFF"  # The matrix compares what is printed.
    yield f"CMAKE_UNITY_BUILD={'OFF' if row.is_blind else 'ON'}"  # A third less to compile; no_self_test.o replaces one object.
    yield f"HYRAX_CORE_RECORD={core_record(folder.parent)}"
    yield f"CMAKE_CXX_FLAGS={row.flags}"
    yield f"CMAKE_CXX_FLAGS_NONE={row.more_flags}"
    if row.toolchain:
        yield f"CMAKE_TOOLCHAIN_FILE={PROJECT}/tools/cmake/{row.toolchain}"
    else:
        yield f"CMAKE_C_COMPILER={row.compiler.replace('clang++', 'clang').replace('g++', 'gcc')}"
        yield f"CMAKE_CXX_COMPILER={row.compiler}"
    if row.last_flags:
        yield ("CMAKE_CXX_COMPILE_OBJECT=<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> "
               f"{row.last_flags} -o <OBJECT> -c <SOURCE>")
    if row.is_blind:
        yield f"CMAKE_EXE_LINKER_FLAGS={folder}/no_self_test.o"
    yield from row.settings


def build(row, folder):
    """Configures and builds; returns the program. A row that must not compile is built up to the core."""
    folder.mkdir(parents=True, exist_ok=True)
    if row.is_blind:
        succeed(row.compiler, "-std=c++20", "-O2", f"-I{PROJECT}", "-c", PROJECT / "tests/platforms/no_self_test.cpp",
                "-o", folder / "no_self_test.o")
    succeed("cmake", "--log-level=WARNING", "-S", row.source, "-B", folder, "-G", "Ninja",
            *(f"-D{setting}" for setting in settings_of(row, folder)), timeout=TIMEOUT_S)
    target = "hyrax_physics" if row.must.kind == "compiles" else pathlib.Path(row.program).stem
    succeed("ninja", "-C", folder, "-j1", target, timeout=TIMEOUT_S)
    return folder / row.program


@functools.cache
def build_library(name, folder):
    """The library of that name. From GCC 13 on -ffast-math alone does not reach into one."""
    library = folder / f"{name}.so"
    if library.exists() and library.stat().st_mtime > SOURCES[name].stat().st_mtime:
        return library
    compile_it = ("gcc", "-shared", "-fPIC", "-O2", SOURCES[name], "-o", library, "-lm")
    if name != "fast_math":
        succeed(*compile_it)
        return library
    try:
        succeed(*compile_it, "-ffast-math", "-mdaz-ftz")
    except Failed:
        succeed(*compile_it, "-ffast-math")
    return library


@functools.cache
def build_locale(folder):
    """A folder of locales with one in it, which has a decimal comma."""
    if not (folder / "de_DE").exists():
        succeed("localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE")
    return folder


def environment_for(variant, folder):
    """What a variant adds to the environment; its libraries and its locale are built on first use."""
    folder.mkdir(parents=True, exist_ok=True)
    added = {"HYRAX_DISTURBED": "round"}
    for setting in variant.environment:
        name, value = setting.split("=", 1)
        if name == "LD_PRELOAD":
            added |= preloading(build_library(value.strip("{}"), folder))
        else:
            added[name] = str(build_locale(folder)) if value == "{locales}" else value
    return added
