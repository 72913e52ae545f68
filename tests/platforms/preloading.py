"""Libraries and a locale that variants are run with."""

import functools

from process import Failed, preloading, succeed
from rows import HERE, PROJECT

SOURCES = {"locale": HERE / "preloaded/locale.c", "fast_math": HERE / "preloaded/fast_math.c",
           "rounding": PROJECT / "tests/cli/disturbed_arithmetic.c"}


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
