"""What a document says of the program in words, its source says too."""

import functools
import json
import math
import pathlib
import re
import shutil
import tempfile
import unittest

import h5py

from documentation_test import text_of
from process import run
from program import PROGRAM

SCHEMA, CMAKE, WALLS = "tools/files/scenario.schema.json", "tools/own_core/hyrax_add_scenarios.cmake", "sim/core/contact_stepper.h"
RUNS, HEADER = "tools/report/page/runs.js", "sim/physics/physics.h"
SPEED, COMPARISON = "sim/study/speed_error/speed_error_tables.cpp", "sim/compare/comparison.h"
NEEDS, OPENED, BLESS = "sim/study/needs/needs_study.cpp", "tests/unit/tools/report/runs_test.mjs", "tools/app/library/blessing.cpp"
# By document: a source, the document's words, and the source's. Their groups have the same text. Where the source's words are
# left out, each group stands somewhere in the source.
WORDS = {
    "README.md": (
        (HEADER, r"origin is (top left), y points (down)\.", r"Origin (top left), \+x right, \+y (down);"),
        ("tools/run", r"tools/run # replays (\S+);", r"tools/run replay (\S+);"),
        ("tools/test", r"tools/test # builds and runs all (\w+) tests", r"tools/test build in release mode, run the (\w+) tests"),
        ("tools/setup.sh", r"cmake --build build # builds (\S+) and the tests", r"builds (\S+); ctest"),
        ("tools/check", "after each edit `tools/check (--watch)`", r"tools/check (--watch) \.\.\. repeat it after each change"),
        ("tests/README.md", "identical results under `(-O3 -march=native)` too", r"\| g\+\+ 12 \| .*?`(-O3 -march=native)`.*? agree \|"),
        ("scenarios/README.md", "Every (key) carries its (unit);", r"A (key) of a quantity ends with its (unit)\."),
        ("sim/reference/README.md", "path depends on the frame rate, and shorter frames do not (converge)")),
    "sim/reference/README.md": (
        ("sim/reference/arc_meter.cpp", "arc's (largest) energy, or that of 1 px of height if that is more", r"std::max\(arc_\.energy_(largest)_px2_per_s2, of_one_px\)"),),
    "scenarios/README.md": (
        (HEADER, r"origin is the (top left) corner of the window, x points (right), y points (down)\. `x, y` is the (top left) corner of the "
         r"sprite; it is kept within `(0 \.\.) window - sprite`",
         r"Origin (top left), \+x (right), \+y (down);.*The (top left) corner is kept within (0 \.\.) screen - obj"),
        ("sim/scenario/apply.h", r"`fling` \| sets the velocity: [^|]*\(`(\w+)`\) \| \| `place` \| sets the position: [^|]*\(`(\w+)`\) \| \| "
         r"`stop` \| sets the velocity to 0 \(`(\w+)`\)",
         r"const Fling& [^}]*?on\.(\w+)\(.*const Place& [^}]*?on\.(\w+)\(.*const Stop&[^}]*?on\.(\w+)\("),
        ("sim/scenario/apply.h", r"`release` \| sets the velocity and lets go, (before) the step of this frame",
         "Applies an action (before) the frame it falls on"), (SCHEMA, r"`hitch` \| gives (this frame another dt):"),
        ("tests/oracle/replay.py", r"apply the events of this frame (in file order); \(3\) unless the sprite is held, call"),
        (SCHEMA, r"`jitter` may be added to (the first two)\."), ("sim/scenario/schedule.h", r"an error\. (With jitter), a time beyond"),
        (SCHEMA, "`seed` is (required): an integer", r'"title": "Jitter",.*?"(required)": \["kind", "seed"\]'),
        (SCHEMA, "(frames pass), (without) step and with contact 0, (until) `release`", "(Frames pass) (without) update (until) it is released"),
        (SCHEMA, r"`state_hash` \| 32 hex digits \| the hash of all rows is this one", r'"state_hash": \{ [^}]*"Hash over every row"'),
        ("tools/files/json.h", r"Numbers are read exactly \((correctly rounded), (in) every (locale)\)",
         "Numbers are read (correctly rounded) and written shortest-round-trip (in) any (locale)"),
        (SCHEMA, r"`in_bounds` \| boolean \| (every row) is (inside the bounds of its frame) \(or, with `false`, one is not\)",
         "Whether (every row) lies (inside the bounds of its frame)"), (SCHEMA, r"`finite` \| boolean \| the (state stays finite)"),
        (SCHEMA, "`steps` may be left out; if given, it must equal the length", "With an array of dt: its length, and may be left out"),
        (SCHEMA, r"`name` \| no \|[^|]*If left out, the (file) name without `\.json`", "The (file)'s stem if left out"),
        (SCHEMA, r"`sprite` \|[^|]*\|[^|]*; (may be larger than the window) \|"),
        (SCHEMA, r"; needs dt > 0; not with an array of dt \|", r'"then": \{ "properties": \{ "duration_s": false \} \}'),
        (SCHEMA, r"(Contacts) are stored for every (K) \|", "(Contacts) are recorded whatever (K) is"),
        (SCHEMA, r"the last row is within; a single number is refused \|", r'"final_x_px": \{ "\$ref": "#/\$defs/interval",')),
    "tools/files/scenario.schema.json": (
        ("scenarios/README.md", r"Only while held\.", "`release` while not held are errors"),
        ("scenarios/README.md", "missed_frames: now and then dt is doubled", r"`missed_frames` \| `probability`, 0 \.\. 1 \| `dt \* 2\.0`"),
        ("sim/reference/drift.h", '"implementation_px_max": [^}]* distance from the (discrete closed form), px.*"truncation_px_max": [^}]* '
         "from the (matched ODE), px",
         r"double implementation_px = 0\.0; Against the (discrete closed form): .*double truncation_px = 0\.0; Against the (matched ODE)\."),
        (HEADER, r"played frame by frame\. Origin top left, (\+x right, \+y down); px, px/s, s\."),
        ("tools/files/scenario_head.cpp", r'"time": \{ "description": "\[low, high\], both inclusive(, or a number as upper bound)\."')),
    "golden/README.md": (
        ("tools/app/runs/scenario_run.cpp", "`run` compares as well, unless `--(set)` was given", '"values were (set)"'),
        ("sim/compare/equal_times.h", "at the (row times of either), each run on the (straight line between) its rows"),
        ("tools/store/golden_summary.h", "with the lines of the summary itself, (all but the reason's) text"),
        ("tools/app/causes/core_check.h", r"Runs that become (non-finite) come (first)\.", "Runs that become (non-finite) (first);"),
        ("tools/app/core/accepted_core.h", r"and `(accepted\.txt)`, (written last), with its constants, the reason and (checksums of all)"),
        ("tools/store/trajectory_parts.cpp", "(clamps in the step that made the row): ([^|]*) vy set to 0 by the rest rule",
         "(clamps in the step that made the row): (.*?) put to rest"), (COMPARISON, r"`contacts` \| (a contact moved, appeared or vanished) \|"),
        ("sim/trajectory/stored_run.h", r"the hash and the state at its beginning\.", "keyframe; At the first row of the first of them"),
        ("golden/flings/first-fling.txt", r"how far each coordinate of the start may move \(in px and px/s\) before any contact changes\. The "
         "last line has the two checksums", r"margin: any start within \S+ px and px/s keeps all contacts; .*checksums: \S+ \S+$"),
        ("sim/compare/run_distance.h", r"`rounding` \| every row has (the same contact byte); (positions)",
         "within rounding: (the same contact byte), (positions)"),
        (COMPARISON, r"`values` \| (the same walls at the same steps, first and last, but more than)"),
        (COMPARISON, r"`shape` \| another length, another scenario, or missing data", r"shape, Other length, missing data, another scenario\."),
        (BLESS, r"allows \(default: `(\w+)`\); (new scenarios) and scenarios (whose own text changed) need no",
         r"default: (\w+)\); (new scenarios) and those (whose own text changed) need none"),
        (BLESS, r"for these folders \(default: `(\w+)`\); needs no reason", r"of the folders given \(default: (\w+)\)"),
        (BLESS, r": a (range keeps its width) and its decimals, with the new value in its middle .*?\. A (boolean), an error bound or a (one-sided limit) that "
         "does not hold is never changed", r"a (range keeps its width)\. (Boolean)s, .* and (one-sided limit)s never change"),
        ("tools/hyrax-sim/bless.cpp", "A boolean, an (error bound) or a one-sided limit that does not hold")),
    "tools/own_core/README.md": (
        (CMAKE, r"letters, digits, `(.)`, `(.)`, `(.)`\)", r"must be of letters, digits, (.), (.) and (.) \(found"),
        (CMAKE, r"have the label `CORE`, which is `(\w+)` for the shipped core", r"LABELS \${prefix}.*set\(prefix (\w+)\)"),
        ("tools/cmake/room.cmake", "compiled with `(-ffp-contract=off)`, like the shipped core"),
        (WALLS, "(on or past the wall's bound, or if its velocity turn)s from (towards the wall to away from it within reach: the bound is "
         r"no farther from the position before the step than the faster of both velocities goes in dt)\."),
        (WALLS, r"(`before` is the velocity before the step), `overshoot` is (NaN)\."),
        (CMAKE, r"\(`(bless --prune)` removes it\)", r"(bless --prune) --dry-run"),
        ("sim/trajectory/stored_run.h", "`constants` is there for a core of the same shape only",
         "Of the core that played it; nothing where it is not the paper's model. std::optional<Constants> constants"),
        ("sim/ensemble/ensemble.h", r"repeatable, in pieces; .*; `sweep` (step by step) \|",
         "Plays one scenario by the replay, (step by step)"), (CMAKE, "else the header's, without suffix", "STEM LAST_ONLY arg_NAME"),
        ("tests/cli/own_shapes_test.py", r"`study`, `sweep` \(by the fast (kernels)\), `fuzz`", "The (kernels) leave steps at rest out"),
        ("golden/README.md", "else where `check` looks: the `(golden)` (beside) the nearest folder `(scenarios)`",
         "or in the `(golden)` (beside) that `(scenarios)`"),
        ("tools/hyrax-sim/check.cpp", "your step changed in a way (that no scenario notices)"),
        ("tests/cli/own_shapes_test.py", "names (the first expression that is not the paper's):"),
        ("tools/hyrax-replay/help.txt", "compares the state (hash) of every row with (the one in the) golden file's (summary)",
         "compares the (hash) of each scenario with (the one in the) (summary) of its golden file"), ("sim/core/traced_stepper.h", "`diff` hold (x, y, vx, vy) only"),
        (WALLS, r"the velocity before the step \((after) its (inputs)\)", "before the state (after) the (inputs) of the frame"),
        ("tests/unit/tools/app/own_core.txt", r"`run` say `left, right (from the rows)`"),
        (WALLS, r"in a contact with the (ground) with (vy) = 0\.", r"set where the (ground) was met and (vy) is 0\."),
        (BLESS, r"and `bless` replaces it with `(--accept \w+)` only\.", r"(--accept \w+) replaces it")),
    "tools/report/page/README.md": (
        (RUNS, r"`data-replay` \(`running`, then `agrees`, `differs` or `none`\)",
         r"worst = \{ agrees: 0, none: 1, differs: 2 \}.*replay = 'running'"), ("tools/report/page/verdict.js", r"golden file \(`(--against)`, or"),
        (RUNS, "the (golden) run is translucent and dashed", "label: '(golden)', name: 'golden file'"),
        ("tools/report/page/charts.js", "Each is saved as (CSV) by a click", " as (CSV)`"),
        (OPENED, "it (opens on the second around) the (largest distance)"), ("sim/replay/fingerprint.h", "a (digest of some hundred steps)"),
        (OPENED, "its distance is the first chart", r"children\[0\]\.id === 'chart-distance'"),
        (RUNS, r"`data-state-hash` \(as the browser computed it\)", r"dataset\.stateHash = worstResult\.check\.stateHash;"),
        ("tools/report/page/core.js", "`data-core` is `(differs)` where", r"dataset\.core = '(differs)'"),
        (OPENED, "opens on the (first) that differs", "it opens the (first) of the worst"),
        ("tools/report/page/core.js", r"energy drift by cause \(in (px of height), summed up over the run\)"),
        (RUNS, r"fall on a pixel, (the smallest and the largest value are drawn)\."),
        ("tools/report/page/members.js", r"\((cells) where both are grids, (points elsewhere)\)",
         r": (cells) that tile where both are grids, (points elsewhere)\."),
        ("tools/report/page/record.js", r"writes, with its state hash as `expect`\.", r"\['expect', object\(\[\['state_hash'")),
    "tests/README.md": (
        ("tools/test", "`--all` tests two builds: the everyday one, and (clang)'s with sanitizers", r"presets=\(asan-(clang)\)"),
        ("tools/test", r"`long` \| with `(--all)` and `--nightly`.*`nightly` \| with `(--nightly)` only.* in the everyday build only, and "
         "with `--nightly` in all builds", "tools/test (--all) also run the long tests.*tools/test (--nightly) also run the nightly "
         r"tests.*run all everyday tests in all builds \(--all leaves"),
        ("tests/must_fail/mutation/table.py", r"95 % interval \((Wilson)\)", r"\((Wilson) 1927\)"),
        ("tools/test", "draws ten, with the (date) as the seed", r'--seed "\$\((date) '),
        ("tests/must_fail/mutation/mutators.py", "constants (by one ulp, by 1 %) and (by sign);"),
        ("tests/unit/sim/result/described.h", "(HYRAX_APPROVE)=1 tools/test -R unit", r'getenv\("(HYRAX_APPROVE)"\)'),
        ("tests/cli/documentation_test.py", r"tests/cli/documentation_test\.py (--update)", r"documentation_test\.py (--update) rewrites"),
        ("tests/cli/process.py", "What a machine lacks [^.]* (skips a test), and fails it if `(CI)=true`",
         "(Skips a test) that this machine cannot run; if (CI) is set, that is a failure"),
        ("tools/test", "fuzzes for an hour instead of half a minute", r"=\(asan-clang\) fuzzing_s=30 .*debug\) fuzzing_s=3600 ")),
    "tests/benchmarks/README.md": (
        ("tests/benchmarks/CMakeLists.txt", "build/release/bin/(hyrax-figures)", r"add_executable\((hyrax-figures) "),
        ("CMakePresets.json", "cmake --preset (release) &&", '"name": "(release)", "displayName": "[^"]*, with the benchmarks"'),
        ("tools/hyrax-sim/run.cpp", r"From there on nothing is computed, .*`(--no-skip)` (compute)s it\.",
         '"(--no-skip)", "", "(compute) also the steps that repeat')),
    "CHANGELOG.md": (
        (COMPARISON, r"the classes `(\w+)`, `(\w+)`, `(\w+)`, `(\w+)` \(`bits` is gone\)", r'kNames = \{"(\w+)", "(\w+)", "(\w+)", "(\w+)"\}'),
        ("tools/report/drift_figure.cpp", r"`drift` draws one picture, `(-\w+)\.svg`", r'name \+ "(-\w+)\.svg"'),
        ("tools/app/drift/drift_result.cpp", r"`steps_astray` is called `(\w+)`", r'column_of_one\("(differing\w+)"'),
        ("tools/app/library/run_flow.cpp", r"; `run -o (FILE\.csv)`\.")),
    "sim/study/README.md": (
        ("sim/study/methods/cost.h", r"a is \*cheaper\* only if it is (in every process)\."),
        ("sim/study/methods/cost.cpp", r"in some process is `(not measured: clock unsteady)`\."),
        (SPEED, r"\| least squares of (log error against log dt), with walls"), (SPEED, r"each work once a round and (in random order) \(`order_seed`\);"),
        (SPEED, r"For each, the study measures the (largest distance from the exact fling), and the (time per simulated second)\. The exact fling has"),
        (SPEED, r"\(`set_up` in the files: (time of a run before its first frame)\)"),
        (SPEED, "An energy error is the (largest difference of energy) over the rows at which (both have met each wall equally often / largest kinetic energy of the exact fling),"),
        (NEEDS, "`path moves` is the (largest distance at equal times), `contacts moved` counts (contacts that moved, appeared or vanished), "
         r"`end moves` is the (distance at the end)\."),
        ("sim/study/study_table.h", "shorter a step is without the part, where its (95 % interval) is above 0"),
        ("sim/study/hard_cases/hard_cases_study.cpp", r"verdicts (held, finding \(an expected failure\), broken, or finding gone \(it holds\))\."),
        ("sim/study/frame_rate/frame_rate_study.cpp", "Other contacts: (flings that meet a side wall or the top another number of times) "
         r"than at 60 Hz\."), ("sim/study/frame_rate/frame_rate_study.cpp", r"The score is (100 \(1 - mean spread / mean horizontal path\)):")),
    "tools/hyrax/README.md": (
        ("tools/recorder/recording.h", r"written about twice a second, .* at most the last second is lost, .*\((four and a half minutes of "
         r"motion at 60 Hz)\)", r"kSavesPerSecond = 2;.*kPartFrames = 16'384; (four and a half minutes of motion at 60 Hz)\."),),
    "tools/hyrax/help.txt": (("tools/recorder/recording.h", "At most the last second is lost", "kSavesPerSecond = 2;"),),
}


@functools.cache
def words_of(path):
    """The text in one line, without the marks of comments and between the parts of a string."""
    return " ".join(re.sub(r'"\s*\n\s*"|^\s*///?|///<|\*\*', "", text_of(path), flags=re.MULTILINE).split()).lower()


class Words(unittest.TestCase):
    """What a reader relies on."""

    def test_what_is_said_in_words_is_what_the_source_says(self):
        for document, source, said, *its in ((document, *row) for document, rows in WORDS.items() for row in rows):
            with self.subTest(document=document, said=said):
                found = re.search(said, words_of(document), re.IGNORECASE)
                self.assertTrue(found and (its or found.groups()), "not in the document, or nothing to look for in the source")
                of_source = its[0] if its else r"\A" + "".join(f"(?=.*({re.escape(group)}))" for group in found.groups())
                again = re.search(of_source, words_of(source), re.IGNORECASE)
                self.assertEqual(found.groups(), again and again.groups(), source)

    def test_what_runs_and_differences_do_by_the_documents(self):
        """Words of the documents choose what is given to the program, or what must come of it."""
        def words(document, pattern):
            return re.search(pattern, " ".join(text_of(document).split())).groups()
        same_time, same_frames, remedy, also = words(
            "scenarios/README.md", r"frame rate\. With `(\w+)` it covers the same time; with `(\w+)` it plays the same number.*?write `(\w+)`, or set `/(\w+)`")
        first, second, last, bounds, limit = words("scenarios/README.md", r"Rows (\d), K, (\d)K, \.\.\. and the (last|first) one are stored\..*All bounds are (in|ex)clusive\..* at the number at the (latest|earliest), or")
        zeros, nan, count, contacts = words("golden/README.md", r"\+0 and -0 (differ|agree), and NaN (always|never) fails\..* a value agrees if (any|all) of them .{2,3} met\. Contacts must (always|never) agree\.")
        self.assertEqual([remedy, also], [same_time, same_frames])
        start = {key: each for key, each in json.loads(text_of("scenarios/flings/first-fling.json")).items() if key in ("format", "window", "sprite", "start")}
        expect = {"contacts": {"ground": [8, 8], "left": [0, 1]}, "at_rest_since_s": 9}
        with tempfile.TemporaryDirectory(prefix="hyrax-") as folder:
            def write(name, **more):
                path = pathlib.Path(folder, f"{name}.json")
                path.write_text(json.dumps({**start, "clock": {"rate_hz": 60}, **more}), encoding="utf-8")
                return path

            def agrees(dataset, row, altered, *tolerances):
                shutil.copy(f"{folder}/held.h5", f"{folder}/altered.h5")
                with h5py.File(f"{folder}/altered.h5", "r+") as file:
                    file[dataset][row] = altered
                shutil.copy(f"{folder}/altered.h5", f"{folder}/same.h5")
                return run(PROGRAM, "diff", f"{'same' if math.isnan(altered) else 'held'}.h5", "altered.h5", "-q", *tolerances, cwd=folder).exit_code == 0
            paths = [write(name, **{key: 2}) for name, key in (("time", same_time), ("frames", same_frames))]
            kept = run(PROGRAM, "run", *paths, "--set", "/clock/rate_hz=144", "--set", "/record/every=7", "--json", cwd=folder)
            self.assertEqual([each["steps"] for each in kept.json["runs"]], [288, 2])
            with h5py.File(f"{folder}/time.h5") as file:
                steps = [int(first), *range(7, 289, 7 * (int(second) - 1))]
                self.assertEqual(list(file["trajectory/step"]), steps + [288] * (last == "last"))
            held, = run(PROGRAM, "run", write("held", steps=600, start={**start["start"], "vx_px_per_s": 0}, expect=expect), "--json", cwd=folder).json["runs"]
            self.assertEqual([each["holds"] for each in held["expect"]], [limit == "latest", bounds == "in", bounds == "in"])
            self.assertEqual([agrees("trajectory/vx", 5, -0.0), agrees("trajectory/x", 5, 60.001, "--abs", "0.1", "--ulps", "1"), agrees("contacts/step", 0, 9, "--abs", "1e9"),
                              agrees("trajectory/vx", 5, math.nan)], [zeros == "agree", count == "any", contacts == "never", nan == "never"])
