"""Which changes of the sources that decide verdicts are tried."""

import math

from mutators import mutants_of

FOLDERS = ("sim/compare", "sim/replay", "sim/reference", "sim/study", "tools/files", "tools/store", "tools/app",
           "tools/hyrax-sim")


def mutants_by_folder(build):
    """{folder: [Mutant]} of all sources that the build compiles.

    Other flags are left out, and constants that move by one ulp: in these folders no verdict depends on it.
    """
    found = {}
    for folder in FOLDERS:
        paths = sorted(path for path in build.objects if path.startswith(f"{folder}/"))
        texts = {path: (build.source / path).read_text(encoding="utf-8") for path in paths}
        found[folder] = [mutant for path in paths for mutant in mutants_of(path, texts[path])
                         if not mutant.flags and not _is_by_one_ulp(mutant, texts[path])]
    return found


def _is_by_one_ulp(mutant, text):
    try:
        before, after = float(text[mutant.begin:mutant.end]), float(mutant.replacement)
    except ValueError:
        return False
    return mutant.kind == "constant" and math.isclose(before, after, rel_tol=1e-12, abs_tol=1e-300)


def drawn(by_folder, count, generator):
    """So many mutants, equally many of each folder where it has enough, in random order."""
    left = {folder: generator.sample(mutants, len(mutants)) for folder, mutants in by_folder.items()}
    chosen = []
    while len(chosen) < count and any(left.values()):
        folders = [folder for folder, mutants in left.items() if mutants]
        for folder in generator.sample(folders, min(len(folders), count - len(chosen))):
            chosen.append(left[folder].pop())
    return chosen
