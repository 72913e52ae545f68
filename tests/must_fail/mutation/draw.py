"""Which changes of the sources that decide verdicts are tried."""

import math

from mutators import mutants_of
from slips import names_in, slips_of

FOLDERS = ("sim/card", "sim/cause", "sim/compare", "sim/ensemble", "sim/reference", "sim/replay", "sim/result", "sim/scenario",
           "sim/search", "sim/study", "sim/trace", "sim/trajectory", "tools/app", "tools/files", "tools/hyrax",
           "tools/hyrax-compare", "tools/hyrax-replay", "tools/hyrax-sim", "tools/report", "tools/store")


def mutants_by_folder(build):
    """{(folder, whether of a person): [Mutant]} of all sources that the build compiles.

    Other flags are left out, and constants that move by one ulp: in these folders no verdict depends on it.
    """
    paths = sorted(path for path in build.objects if path.startswith(("sim/", "tools/")))
    texts = {path: (build.source / path).read_text(encoding="utf-8") for path in paths}
    names = names_in(texts.values())
    found = {}
    for folder in FOLDERS:
        own = [path for path in paths if path.startswith(f"{folder}/")]
        found[folder, False] = [mutant for path in own for mutant in mutants_of(path, texts[path])
                                if not mutant.flags and not _is_by_one_ulp(mutant, texts[path])]
        found[folder, True] = [mutant for path in own for mutant in slips_of(path, texts[path], names)]
    return found


def _is_by_one_ulp(mutant, text):
    try:
        before, after = float(text[mutant.begin:mutant.end]), float(mutant.replacement)
    except ValueError:
        return False
    return mutant.kind == "constant" and math.isclose(before, after, rel_tol=1e-12, abs_tol=1e-300)


def drawn(by_folder, count, generator):
    """So many mutants, equally many of each key where it has enough, in random order."""
    left = {folder: generator.sample(mutants, len(mutants)) for folder, mutants in by_folder.items()}
    chosen = []
    while len(chosen) < count and any(left.values()):
        folders = [folder for folder, mutants in left.items() if mutants]
        for folder in generator.sample(folders, min(len(folders), count - len(chosen))):
            chosen.append(left[folder].pop())
    return chosen
