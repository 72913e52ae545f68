"""What is changed: the files and folders, and which changes of each are tried."""

import dataclasses
import math

from mutators import mutants_of
from slips import names_in, slips_of


@dataclasses.dataclass(frozen=True)
class Subject:
    """A file, or a folder with all that the build compiles of it.

    functions: only these are changed; all where none is named. "declarations" is the code outside of functions.
    units: only these sources are compiled again with a change of the file; all that include it where none is named.
    units_of_layout: and these, where the change is one of a member's type.
    """

    path: str
    functions: tuple = ()
    units: tuple = ()
    units_of_layout: tuple = ()

    def units_for(self, mutant):
        """The sources that are compiled again for this mutant."""
        is_of_layout = mutant.kind == "float for double" and mutant.name.startswith("declarations: ")
        return (self.units or (self.path,)) + (self.units_of_layout if is_of_layout else ())

    @property
    def is_core(self):
        """Whether it decides the bits of a run: `check` must notice every change of it, by one ulp or of the flags, too."""
        return "." in self.path


_FRAME_CLOCK = "sim/scenario/frame_clock.cpp"
_SCHEDULE = "sim/scenario/schedule.cpp"
_PLAYER = "sim/replay/player.cpp"

SUBJECTS = (
    Subject("sim/physics/physics.h"),
    Subject("sim/scenario/split_mix64.h", units=(_FRAME_CLOCK,)),
    Subject("sim/scenario/frame_clock.h", units=(_FRAME_CLOCK, _SCHEDULE, _PLAYER, "sim/replay/repetition.cpp"),
            units_of_layout=("sim/trajectory/stored_run.cpp", "tools/store/golden_file.cpp", "tools/store/golden_summary.cpp")),
    Subject(_FRAME_CLOCK),
    # The other functions compute the latest allowed time of an event, to refuse one after the end.
    Subject(_SCHEDULE, ("declarations", "is_due", "play_to", "jump_to", "play_to_time", "hitch", "is_even", "play",
                        "even_frames_to", "go_to", "timed_end", "schedule_events")),
    Subject(_PLAYER, ("play_to", "apply_events", "play_hitch", "play_uneven_stretch")),
    Subject("sim/scenario/apply.h", units=("sim/core/shipped_core.cpp",)),
    Subject("sim/core/core_of.h", ("make",)),
    Subject("sim/core/stepper_of.h", ("apply", "state_of")),
    *map(Subject, ("sim/cause", "sim/compare", "sim/core", "sim/ensemble", "sim/motion", "sim/reference",
                   "sim/replay", "sim/result", "sim/scenario", "sim/search", "sim/study", "sim/trace", "sim/trajectory",
                   "tools/app", "tools/files", "tools/hyrax", "tools/hyrax-replay",
                   "tools/hyrax-sim", "tools/recorder", "tools/report", "tools/store")),
)


def mutants_by_subject(build):
    """{(subject, whether of a person): [Mutant]} of all sources that the build compiles; each mutant once.

    Of folders, other flags are left out, and constants that move by one ulp: no verdict depends on it.
    """
    paths = sorted(path for path in build.objects if path.startswith(("sim/", "tools/")))
    texts = {path: (build.source / path).read_text(encoding="utf-8") for path in paths}
    names = names_in(texts.values())
    found, of_core = {}, set()
    for subject in SUBJECTS:
        if subject.is_core and subject.path in texts:
            found[subject, False] = mutants_of(subject.path, texts[subject.path], subject.functions)
            of_core.update((mutant.path, mutant.name) for mutant in found[subject, False])
        elif not subject.is_core:
            own = [path for path in paths if path.startswith(f"{subject.path}/")]
            found[subject, False] = [mutant for path in own for mutant in mutants_of(path, texts[path])
                                     if (mutant.path, mutant.name) not in of_core
                                     and not mutant.flags and not _is_by_one_ulp(mutant, texts[path])]
            found[subject, True] = [mutant for path in own for mutant in slips_of(path, texts[path], names)]
    return found


def _is_by_one_ulp(mutant, text):
    try:
        before, after = float(text[mutant.begin:mutant.end]), float(mutant.replacement)
    except ValueError:
        return False
    return mutant.kind == "constant" and math.isclose(before, after, rel_tol=1e-12, abs_tol=1e-300)


def drawn(count, groups, generator):
    """So many mutants, equally many of each group where it has enough, in random order."""
    left = [generator.sample(mutants, len(mutants)) for mutants in groups]
    chosen = []
    while len(chosen) < count and any(left):
        left = [mutants for mutants in left if mutants]
        for mutants in generator.sample(left, min(len(left), count - len(chosen))):
            chosen.append(mutants.pop())
    return chosen
