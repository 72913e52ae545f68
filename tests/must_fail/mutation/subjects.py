"""What is mutated, and what must then be built and run."""

import dataclasses

from mutators import mutants_of


@dataclasses.dataclass(frozen=True)
class Subject:
    """A source file, and all that a change of it concerns.

    functions: only these are mutated; all of the file where none is named. "declarations" is the code outside of functions.
    units: what is compiled again, since it contains code of the file.
    units_of_layout: and these, where the change is one of a member's type.
    likely: the scenarios that are checked first.
    test, test_units: the unit test program for what no scenario reaches, and its units that are compiled again.
    """

    path: str
    units: tuple
    functions: tuple = ()
    units_of_layout: tuple = ()
    likely: tuple = ()
    test: str = ""
    test_units: tuple = ()

    def mutants(self, source):
        """All mutants of the file."""
        return mutants_of(self.path, (source / self.path).read_text(encoding="utf-8"), self.functions)

    def units_for(self, mutant):
        """The units that are compiled again for this mutant."""
        is_of_layout = mutant.kind == "float for double" and mutant.name.startswith("declarations: ")
        return self.units + (self.units_of_layout if is_of_layout else ())


_SHIPPED = "sim/core/shipped_core.cpp"
_CORE_OF = "sim/core/core_of.h"
_KERNEL_OF = "sim/core/kernel_of.h"
_PLAYER = "sim/replay/player.cpp"
_REPETITION = "sim/replay/repetition.cpp"
_FRAME_CLOCK = "sim/scenario/frame_clock.cpp"
_SCHEDULE = "sim/scenario/schedule.cpp"

_FLINGS = ("paper/exact-bounds", "flings/grab-and-throw", "flings/corner-upper-left")
_JITTER = ("clocks/jitter-uniform", "clocks/jitter-normal", "clocks/missed-frames")
_EVENTS = ("flings/grab-and-throw", "flings/corner-fling", "clocks/trace-144-hz", "clocks/missed-frames")

SUBJECTS = (
    Subject("sim/physics/physics.h", (_SHIPPED,), likely=_FLINGS, test="physics_test",
            test_units=("tests/unit/sim/physics/interface_test.cpp",)),
    Subject("sim/scenario/split_mix64.h", (_FRAME_CLOCK,), likely=_JITTER),
    Subject("sim/scenario/frame_clock.h", (_FRAME_CLOCK, _SCHEDULE, _PLAYER, _REPETITION), likely=_JITTER + _EVENTS,
            units_of_layout=("sim/trajectory/stored_run.cpp", "tools/store/golden_file.cpp",
                             "tools/store/golden_summary.cpp")),
    Subject(_FRAME_CLOCK, (_FRAME_CLOCK,), likely=_JITTER, test="scenario_test", test_units=(_FRAME_CLOCK,)),
    # The other functions compute the latest allowed time of an event, to refuse one after the end.
    Subject(_SCHEDULE, (_SCHEDULE,), likely=_EVENTS, test="scenario_test", test_units=(_SCHEDULE,),
            functions=("declarations", "is_due", "play_to", "jump_to", "play_to_time", "hitch", "is_even", "play",
                       "even_frames_to", "go_to", "timed_end", "schedule_events")),
    Subject(_PLAYER, (_PLAYER,), likely=_EVENTS,
            functions=("play_to", "apply_events", "play_hitch", "play_uneven_stretch")),
    Subject("sim/scenario/apply.h", (_SHIPPED,), likely=_EVENTS),
    Subject(_CORE_OF, (_SHIPPED,), likely=_EVENTS, functions=("make",)),
    Subject(_KERNEL_OF, (_SHIPPED,), likely=_EVENTS, functions=("apply", "state_of"), test="core_test",
            test_units=("tests/unit/sim/core/further_members_test.cpp",)),
)
