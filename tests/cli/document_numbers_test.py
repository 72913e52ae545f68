"""Numbers and totals that a document states are those of the source that decides them."""

import json
import math
import pathlib
import re
import sys
import tempfile
import types
import unittest

import h5py

from documentation_test import DOCUMENTS, text_of
from process import run
from program import PROGRAM, SOURCE

sys.path.insert(0, str(SOURCE / "tests/must_fail/mutation"))
import subjects  # noqa: E402 pylint: disable=wrong-import-position

FORMAT, FILES, CORE, DRIFT = "scenarios/README.md", "golden/README.md", "sim/physics/README.md", "sim/reference/README.md"
HEADER, SCENARIO, STATE = "sim/physics/physics.h", "sim/scenario/scenario.h", "sim/motion/state.h"
HASH, ROUNDING, REST = "sim/trajectory/state_hash.h", "sim/compare/run_distance.cpp", "sim/trajectory/run_summary.h"
STUDIES, PAGE, HYRAX = "sim/study/README.md", "tools/report/page/README.md", "tools/hyrax/README.md"
PHYSICS_CONSTANTS = "GRAVITY, AIR_DRAG, RESTITUTION, GROUND_FRICTION, REST_THRESHOLD"
TESTS, BENCHMARKS, SWEEPS, OWN = "tests/README.md", "tests/benchmarks/README.md", "sim/ensemble/README.md", "tools/own_core/README.md"
FLINGS, SCHEMA, MODEL = "sim/search/random_scenario.cpp", "tools/files/scenario.schema.json", "sim/reference/model.h"

# Document and its words, with `{}` for each number; source, and the names that have these numbers there (with commas, or
# a tuple, where a name has one).
STATED = (
    *(("README.md", "\n| {} | " + words, "tools/files/failure.h", name) for words, name in (
        ("done;", "agreed"), ("results differ", "disagreed"), ("bad usage or bad input", "bad_input"),
        ("cannot read or write", "cannot_access"), ("a golden file is missing", "golden_missing"),
        ("arithmetic is not strict", "not_strict_ieee"), ("internal error", "program_fault"))),
    *((document, words, "tools/files/failure.h", names) for document, words, names in (
        (FILES, "missing (exit code {})", "golden_missing"), (FILES, "`unreferenced` (exit code {})", "disagreed"),
        (FILES, "comparison fails (exit code {})", "disagreed"), (FILES, "is a scenario (exit code {}, nothing", "bad_input"),
        (FILES, "it ends with exit code {}. If none", "disagreed"), (FILES, "describe it`; exit code {} until", "disagreed"), (FILES, "; exit code {} is bad", "disagreed"),
        (SWEEPS, "that are missing (exit {})", "golden_missing"),
        (TESTS, "refused at start, exit code {} |", "not_strict_ieee"), (FORMAT, "may not hold (exit code {})", "disagreed"),
        (CORE, "at every start: exit code {}", "not_strict_ieee"), (DRIFT, "at fault: exit code {}", "program_fault"),
        (DRIFT, "reach this is exit code {}", "bad_input"),
        ("CHANGELOG.md", "the other way round, is missing ({}); an unreferenced golden file is {};", "golden_missing, disagreed"),
        ("CHANGELOG.md", "in a golden folder is refused ({}); an unwritable stdout is {}.", "bad_input, cannot_access"),
        ("tools/hyrax/help.txt", "exit code {} if its state hash agrees, {} if it differs", "agreed, disagreed"),
        ("tools/hyrax/help.txt", "Exit codes: {} done, {} the hash differs or was not compared, {} bad usage or input, {} a file or the screen\n"
         "cannot be used, {} arithmetic is not strict IEEE-754, {} internal", "agreed, disagreed, bad_input, cannot_access, not_strict_ieee, program_fault"),
        ("tools/hyrax-replay/help.txt", "Exit codes: {} agreed or done, {} disagreed or a state is not finite, {} bad usage or input, {} cannot\n"
         "read, {} golden file missing, {} arithmetic is not strict IEEE-754, {} internal",
         "agreed, disagreed, bad_input, cannot_access, golden_missing, not_strict_ieee, program_fault"),
        ("tools/app/command_line/command_program.cpp", "Exit codes: {} agreed or done, {} disagreed, {} bad usage or input, {} cannot read or write,",
         "agreed, disagreed, bad_input, cannot_access"),
        ("tools/app/command_line/command_program.cpp", '"{} golden file missing (or a part of a sweep), {} arithmetic is not strict IEEE-754, {} internal',
         "golden_missing, not_strict_ieee, program_fault"), ("tools/app/study/study_command.cpp", "exit {} if one of the study's rules", "disagreed"),
        ("tools/app/library/check_flow.cpp", "unreferenced (exit code {})", "disagreed"),
        *((f"tools/{script}", f"; {{}} if {words}", "cannot_access") for script, words in (
            ("run", "it could not be installed or built."), ("check", "hyrax-sim could not be built."))),
        ("tools/files/scenario.schema.json", "exit {} where it does not hold", "disagreed"),
        ("tools/hyrax-sim/check.cpp", "notices; exit code {} if there is one", "disagreed"),
        (PAGE, "ends with exit code {}. After an edit", "cannot_access"),
        (OWN, "ends with exit code {} for any other", "bad_input"), (OWN, "refuse\n(exit code {}) and say", "bad_input"),
        (OWN, "What is found ends with exit code {}", "disagreed"),
        (OWN, "while it runs ends with exit code {}, one that throws with {}.", "not_strict_ieee, disagreed"), ("CHANGELOG.md", "rounds ends with exit code {}", "not_strict_ieee"),
        (OWN, "`check` ends with exit code {}, even", "bad_input"))),
    *((CORE, f"| `{name}` | {{}}", HEADER, name) for name in PHYSICS_CONSTANTS.split(", ")),
    (CORE, "; and if `|vy| < {}` then", HEADER, "REST_THRESHOLD"),  # The formulas: tests/oracle/witness_test.py.
    (DRIFT, "G = {} px/s², a = {} (paper", HEADER, "GRAVITY, AIR_DRAG"), (DRIFT, "leaves |vy| below {} px/s", HEADER, "REST_THRESHOLD"),
    (FORMAT, "`window` | yes | `width_px`, `height_px`: integers, 0 .. {} |", SCENARIO, "kWindowSideMax_px"),
    (FORMAT, "`sprite` | yes | `width_px`, `height_px`: integers, {} .. {};", SCENARIO, "kSpriteSideMin_px, kSpriteSideMax_px"),
    (OWN, "up to row {}, `fuzz`", "sim/described/described_run.h", "kCheckedRowsMax"),
    (FORMAT, "Finite, magnitude at most {};", SCENARIO, "kCoordinateMax_px"), (FORMAT, "1 to {} characters", SCENARIO, "kNameLengthMax"),
    (FORMAT, "Finite, magnitude at most {};", SCENARIO, "kSpeedMax_px_per_s"), (FORMAT, "number of frames, 0 .. {} |", SCENARIO, "kStepsMax"),
    (FORMAT, "magnitude at most {}. The run", SCENARIO, "kParameterMax"),
    (FORMAT, "`vx_px_per_s`, `vy_px_per_s` ({} if left out)", "tools/files/scenario.schema.json", '"default":'),
    (FORMAT, "`rate_hz` | > 0, at most {}; dt = 1 / rate_hz, at most {} s", SCENARIO, "kRateMax_hz, kFrameMax_s"),
    (FORMAT, "`dt_s` (number) | 0 .. {} s", SCENARIO, "kFrameMax_s"), (FORMAT, "each 0 .. {} s. `steps`", SCENARIO, "kFrameMax_s"),
    (FORMAT, "a result above {} s\nbecomes {} s", SCENARIO, "kFrameMax_s, kFrameMax_s"), (FORMAT, "is at least {} s later", REST, "kLeastRest_s"),
    (FORMAT, "another dt: `dt_s`, 0 .. {}. A", SCENARIO, "kFrameMax_s"), (FORMAT, "at_s - {} dt", "sim/scenario/schedule.cpp", "kTolerance"),
    (FORMAT, "a time beyond frame {} is an error", "sim/scenario/schedule.h", "kWalkedFrameMax"),
    (FORMAT, "more than {} px from the anchor becomes", REST, "kStill_px"),
    (SWEEPS, "`members` | 1 .. {},", "sim/scenario/sweep.h", "kMembersMax"),
    (FILES, "positions differ by at most {} px, velocities by {} px/s + {} of their size, t and dt by {} s", ROUNDING,
     "kRounding_px, kRounding_px_per_s, kRoundingOfSpeed, kRounding_s"), (FILES, "for each block of {} rows", HASH, "kBlockRows"),
    (FILES, "Golden files of more than {} rows", "sim/trajectory/stored_run.h", "kStoredRowsMax"),
    (FILES, "A row is {} bytes", HASH, "kPackedRowBytes"), (FILES, "Each block of {} rows (row 0 first", HASH, "kBlockRows"),
    (FILES, "every block of {} rows, with the golden", HASH, "kBlockRows"),
    (FILES, "at most {} are stored |", "sim/trajectory/row.h", "kContactsRecordedMax"),
    (FILES, "{} left, {} right, {} top, {} ground, {} vy set to 0", STATE, "left, right, top, ground, kRestBit"),
    (FILES, "`/contacts/wall` | uint8 [M] | {}, {}, {} or {} |", STATE, "left, right, top, ground"),
    (FILES, "it has more than {} paths", "sim/trace/traced_step.h", "kStepPathsMax"),
    (DRIFT, "At most {} arcs and contacts are stored", "tools/app/drift/drift.h", "kArcsListedMax"),
    (DRIFT, "drag of {} Hz, k", MODEL, "model_rate_hz"), ("sim/README.md", "y stays within {} px of the floor", "sim/trajectory/resting_contact.h", "kNear_px"),
    (DRIFT, "at the rates of {} Hz, restitution", MODEL, "model_rate_hz"),
    (DRIFT, "GSL's `rk8pd` at {} integrates", "sim/reference/gsl_flight.h", "tolerance"),
    (DRIFT, "more than {} px +\n{} times the arc's", "sim/reference/drift.h", "kSolversApart_px, kSolversApart_rel"),
    (DRIFT, "an impact also {} of the way", "sim/reference/drift.h", "kSolversApart_rel"), (DRIFT, "At {} Hz the last two", MODEL, "model_rate_hz"),
    (DRIFT, "up to {} frames of equal dt", "sim/reference/arc_solution.h", "kFramesMax"),
    ("tools/app/drift/drift_run.cpp", "tolerance of GSL (default: {})", "sim/reference/gsl_flight.h", "tolerance"),
    ("tools/app/library/run_flow.cpp", "of more than {}, a line each", "tools/app/library/run_flow.cpp", "kPrintedInFullMax"),
    ("tools/hyrax-sim/check.cpp", "scenario of each of the first {} ", "tools/app/check/check_documents.cpp", "kPicturesMax"),
    (FILES, "complete, {} random flings", "tools/hyrax-sim/check.cpp", "kFlings"), (FILES, "random flings of {} s", FLINGS, "kFling_s"),
    (FILES, "more than {} px away) and how far", REST, "kStill_px"), (FILES, "displays of {} to {} Hz", FLINGS, ("kFlingRates_hz[] = {", "200.0, 240.0, ")),
    ("tools/app/library/fuzz_flow.cpp", "5m or 2h (default: {}s)", "tools/app/library/fuzz_flow.h", "kTime_s"),
    ("tools/app/library/fuzz_flow.cpp", "are drawn (default: {})", "tools/app/library/fuzz_flow.h", "kSeed"),
    ("tools/app/library/shrink_flow.cpp", "5m or 2h (default: {}s)", "tools/app/library/shrink_flow.h", "search_s"),
    ("tools/app/library/shrink_flow.cpp", "does not end (default: {}s)", "tools/app/library/shrink_flow.h", "run_s"),
    (STUDIES, "plays the same flights at rates from {} Hz upward", "sim/study/speed_error/speed_error_study.cpp", "options.rates_hz = "),
    (STUDIES, "In each process come {} rounds", "sim/study/methods/cost.h", "rounds ="),
    (STUDIES, "with `--quick`, never fewer than {}.", "sim/study/methods/cost.cpp", "kLeast"),
    (STUDIES, "the study plays {} flings like it", "sim/study/speed_error/speed_error.h", "kBandFlings"),
    *((document, words, "sim/study/speed_error/speed_error.h", "kOrderFlings") for document, words in (
        ("CHANGELOG.md", "medians of {} flings"), (STUDIES, "with walls of each of {} flings"), (STUDIES, "in the median of {} flings"))),
    (STUDIES, "flings ({} with `--quick`)", "sim/study/speed_error/speed_error_study.cpp", "options.order_flings"),
    (CORE, "(median of {} flings", "sim/study/speed_error/speed_error.h", "kBandFlings"),
    (STUDIES, "in each of the {} flings, too", "sim/study/speed_error/speed_error.h", "kBandFlings"),
    (STUDIES, "With more than {}\nscenarios", "sim/study/needs/needs_study.cpp", "kScenariosWithMethodsMax"),
    (STUDIES, "`hyrax-study/{}`: one group per table, one dataset per column", "tools/store/table_file.h", '"hyrax-study/'),
    (STUDIES, "px at {} Hz (without `--quick`)", "sim/study/speed_error/speed_error_study.cpp", "3840.0,"),
    (STUDIES, "The fling and {} random ones", "sim/study/frame_rate/frame_rate_study.cpp", "kFlings"),
    (STUDIES, "those with jitter have {} seeds", "sim/study/methods/many_flings.h", "kJitterSeeds"),
    (PAGE, "Up to\n  {} rows are in the page", "tools/app/report/report_page.h", "kPageRowsMax"),
    (PAGE, "the hash of each block of {} rows", HASH, "kBlockRows"),
    (PAGE, "Runs of more than {} steps are not measured", "tools/report/wasm/shown_run.h", "kStepsMeasuredMax"),
    (PAGE, "of more than {} members are those of a sample", "sim/ensemble/member_numbers.h", "kSamplesMax"),
    (PAGE, "the same in all members, within {}, are named", "sim/ensemble/member_numbers.cpp", "kRounding"),
    (PAGE, "same throw at {}, {}, {} and {} Hz", "tools/report/page/fling.js", "['24 Hz',, ['60 Hz',, ['144 Hz',, ['240 Hz',"),
    (PAGE, "with shift {} steps", "tools/report/page/player.js", "event.shiftKey ?"),
    (FILES, "and the {} worst scenarios", "tools/app/library/difference_group.cpp", "kWorstListed"),
    (OWN, "AIR_DRAG {} .. {}, REST", "sim/study/reference_model.cpp", "constants.air_drag,, 0.5,"),
    (HYRAX, "not moved for {} frames it sleeps", "tools/hyrax/pet.h", "kStillFrames"),
    (HYRAX, "After {} frames (four and a half minutes", "tools/recorder/recording.h", "kPartFrames"),
    ("tools/recorder/README.md", "After {} frames it continues", "tools/recorder/recording.h", "kPartFrames"),
    (HYRAX, "ends after 2^{} frames", "tools/recorder/recording.h", "kFramesMax = std::int64_t{1} <<"),
    (FILES, "compiled core's bits in {} states", "sim/trace/host/compiled_core.h", "kCheckedSteps"),
    (FILES, "apart the two cores are after {} s of it", "tools/app/causes/unnoticed.cpp", "kConsequence_s"),
    (FILES, "stays below {} MB (a test)", "tests/cli/goldens_test.py", "BYTES_MAX"),
    (HYRAX, "one file of less than {} MB", "tests/cli/hyrax/executable_test.py", "SIZE_MAX_BYTES"),
    (TESTS, "({} damaged golden files; `--all` tries {})", "tests/must_fail/mutation/golden_damage_test.py", "_H5_FLIPS, if _IS_ALL else"),
    ("tools/test", "{} damaged golden files", "tests/must_fail/mutation/golden_damage_test.py", "_H5_FLIPS"),
    *((document, words, "tools/test", "\n      mutants") for document, words in (
        ("tools/test", "change {} places of the sources"), (TESTS, "and tries {} mutants\nof the harness"),
        (TESTS, "`tools/test --nightly`\ndraws {}, with"))),
    (SCHEMA, "no frame longer than {} s", SCENARIO, "kFrameMax_s"), (SCHEMA, "frames, at most {}; dt", SCENARIO, "kStepsMax"), (SCHEMA, "stays within {} px, s", REST, "kStill_px"),
    (SCHEMA, "ceil(duration / dt - {})", "sim/scenario/frame_clock.cpp", "base_dt_s(scenario.clock) -"),
    ("README.md", "CMake {} and", "CMakeLists.txt", "cmake_minimum_required(VERSION"),
    ("README.md", "find_package(hyrax {} REQUIRED)", "CMakeLists.txt", "project(hyrax-sim VERSION"),
    (OWN, "find_package(hyrax {} REQUIRED)", "CMakeLists.txt", "project(hyrax-sim VERSION"),
    ("CHANGELOG.md", "\n## {}", "CMakeLists.txt", "project(hyrax-sim VERSION"),
    ("CHANGELOG.md", "beyond frame {} is refused with jitter", "sim/scenario/schedule.h", "kWalkedFrameMax"),
    ("CHANGELOG.md", "play at least {} flings", "sim/study/frame_rate/frame_rate_study.cpp", "kQuickFlings"),
    ("CHANGELOG.md", "`drift` ended with {} on", "tools/files/failure.h", "program_fault"),
    ("CHANGELOG.md", "larger than {} MiB", "tools/files/text_file.cpp", "kTextMax"),
    ("README.md", "Debian {} or Ubuntu {},", ".github/workflows/ci.yml", 'image: "debian:, runs-on: ubuntu-'),
    (FORMAT, "exit with {} if one of these", "tools/files/failure.h", "disagreed"),
    (FORMAT, "ceil(duration_s / dt - {})", "sim/scenario/frame_clock.cpp", "base_dt_s(scenario.clock) -"),
    (FORMAT, "`every`: K >= {} ({} if left out)", SCHEMA, ('"type": "integer",\n          "minimum":', '"minimum": 1,\n          "default":')),
    *((FORMAT, f"`{key}`, {{}} .. {{}} |", SCHEMA, (f'"{title}", "minimum":', f'"{title}", "minimum": 0, "maximum":')) for key, title in (
        ("fraction", "dt * (1 - fraction) .. dt * (1 + fraction)"), ("sigma_s", "Standard deviation, s"),
        ("probability", "Of a frame that takes twice the time"))),
    (FORMAT, "`state_hash` | {} hex digits", SCHEMA, ('"^[0-9a-f]{32}$", "maxLength":',)),
    (OWN, "GRAVITY {} .. {} px/s², AIR", "sim/study/reference_model.cpp", ("constants.gravity_px_per_s2,", "constants.gravity_px_per_s2, 0.0,")),
    (OWN, "GROUND_FRICTION {} .. {}, REST_THRESHOLD\n{} .. {} px/s", "sim/study/reference_model.cpp",
     ("constants.ground_friction,", "constants.ground_friction, 0.0,", "constants.rest_threshold_px_per_s,", "constants.rest_threshold_px_per_s, 0.0,")),
)
# Numbers of documents that no table has, in their order: of the literature, of examples, of conventions (95 % intervals), of
# what was measured once, and of formulas, which tests/oracle/witness_test.py evaluates. A new one belongs into a table, or, if
# nothing decides it, here.
NO_SOURCE = {
    "CHANGELOG.md": "95", "README.md": "1000 1.0", FILES: "0 1 2 3 0.1 600 700 492 592 90 95 0 0 0 1 2 3 4 5 6 7 1 0 16 32 1.10", "sim/README.md": "1 0 0 0",
    FORMAT: ("320 240 5120 1440 60 165 110 400 0 1 2 3 4 120 1,500 0 0 0 980 0 2K 144 60.0 1e9 0 1 1 1.0 2.0 1.0 6.0 "
        "11 0.0 0 0.0 2.0 0 2 64 1 1 0x9E3779B97F4A7C15 2 64 30 27 31 0xBF58476D1CE4E5B9 0x94D049BB133111EB 11 2 0 0 0 0 0 1 2 "
        "3 4 1 0 0 0 0 1 0"), SWEEPS: "0 1 1 4 64 2 12.2 96",
    CORE: "6 1 1200 2 0.999 0.999 3 4 0 0 5 0 0 6 0.8 0 3 0 6.2 3.2.2 0 5 5 0 1 0.6 60 240 779 0.0885 137 60 227", "tests/browser/README.md": "1,000,001",
    DRIFT: "1e-11 1 44 60 200 10 90 2 0 1 1 1 100 1 1 0 19:209 2010 2.10 2.11 0 2 0 1 2 60 2nd 2006", BENCHMARKS: "2 12.2.0 10 600", HYRAX: "10 11 60 8", "tools/platform/README.md": "64 10 11 16 260 8",
    STUDIES: ("95 22:209 1927 95 7:122 1936 10 90 21 2 1 46,812 17 5 60 8 60 8 60 15 0 60 4 60 "
        "0.5 1.5 95 0 52 2e7 24 60 144 240 60 100 1 100 50 16 60 0 0 0 3 75 8 960 60"),
    "tests/must_fail/README.md": "0", OWN: "2,000 980 0 2.0 2.0 0 20 320.0 4096.0 0 1 20.0 600 120 120 1000 60 300 0 100 120 0 64 1e-9 1 1e-5 16 32 4,096 100,000 1 2 4 8 256 301 8 0 1e9 100,000 3",
    TESTS: ("1e9 40 16 0.1.0 12 107 107 14 22 107 107 12 107 107 12 107 107 12 106 106 12 106 106 12 106 106 12 106 "
        "106 19 106 106 12 12 78 107 24.04 13 106 16.8 1 200 165 12 23 44 44 0 0 102 97 0 5 163 128 24 11 196 105 62 29 55 48 0 "
        "7 29 26 0 3 4 4 0 0 12 10 1 1 805 627 99 79 95 30 68 57 7 3 1 0.1.0 17 42,600"), "tests/oracle/README.md": "3.11", PAGE: "0 120 120", "tools/own_core/ci.md": "4 12",
}
# Document and its words; the output, of a command or a benchmark, that these numbers are from, line by line.
SAID_AGAIN = (
    ("README.md", "Needs g++ {} or clang {},", (TESTS, "| x86-64 | g++ {} |"), (TESTS, "| x86-64 | clang {},")),
    ("README.md", "the GPL, version {} or later", (OWN, "the GPL, version {} or later")), (FILES, "is skipped ({}):", (FILES, "|| code={}; exit")),
    (FILES, "physics.h from {} to {}. `tools/check`", (FILES, "constant: GRAVITY {} -> {}; alone")),
    (FILES, "`{} .. {} ground` is", (FILES, "  {} .. {} ground at")), (FILES, "from row {} to row {}. *Margin*", (FILES, "  {} .. {} ground at")),
    (STUDIES, "ends nearer to the exact place in {} of {} flings ({} .. {} %)", (STUDIES, "than the paper's step in {} of {} flings ({} .. {} %): not")),
    (CORE, "a fling is up to {} px ({} .. {}) away", (STUDIES, "  the paper's step                {} ({} .. {})  ")),
    (CORE, "does not help: {} px ({} .. {}), because", (STUDIES, "  exact flight step               {} ({} .. {})  ")),
    (CORE, "60 Hz | {} px | {} px ({} .. {}), nearer at the end in {} of {} flings |", (STUDIES, "  the paper's step                {} ("),
     (STUDIES, "  exact flight, swept clamp       {} ({} .. {})  "), (STUDIES, " .. 0.0405)  {} of {}")),
    (STUDIES, "spreads less in {} of {} flings.", (STUDIES, "every frame the same: drag and friction by time spread less in {} of {} flings")),
    (STUDIES, "frame move the typical fling from {} to {} px off, and\n  {} of {} meet", (STUDIES, "\n  the paper's step                {} ("),
     (STUDIES, "\n  the paper's step, 4 to a frame  {} ("), (STUDIES, "{} of {}\n  the paper's step, drag by time")),
    (BENCHMARKS, "either ({}, at least {}); those of 100 s ({}) and of jitter seeds ({}) do", (SWEEPS, "sweep of 10 s at 60 Hz, keep final                          {} ("),
     (BENCHMARKS, "sweep of 10 s at 60 Hz, times faster than naive                      13.05    (12.69 .. 13.31)  at least {}"),
     (SWEEPS, "sweep of 100 s at 60 Hz, keep final                          {} ("), (SWEEPS, "keep final (naive: mt19937_64)       {} (")),
)
SCENARIOS = len([path for path in (SOURCE / "scenarios").rglob("*.json") if not path.name.endswith(".schema.json")])
WORDS = "zero one two three four five six seven eight nine ten".split()
NUMBER = r"(-?\d[\d,']*(?:\.\d+)?(?:e[+-]?\d+)?|" + "|".join(WORDS) + ")"


def value(text):
    """The number, whatever marks its thousands, or in letters."""
    return float(WORDS.index(text) if text in WORDS else re.sub("[,']", "", text))


def places_of(path, words):
    """The places with these words."""
    return list(re.finditer(NUMBER.join(map(re.escape, words.split("{}"))), text_of(path)))


def stated(path, words):
    """The numbers of that place; none if there is no such place."""
    found = next(iter(places_of(path, words)), None)
    return [value(text) for text in found.groups()] if found else []


def decided(path, names):
    """The number that each name has: after a sign, or at once where the name ends in punctuation."""
    names = names.split(", ") if isinstance(names, str) else names
    found = [re.search(re.escape(name) + ("(?: = |=| |\\(|\\{)" + ("" if re.search(r"\w$", name) else "?")) + NUMBER, text_of(path)) for name in names]
    return [value(each[1]) if each else None for each in found]


def computed():
    """Document, its words, and their numbers, which follow from the constants of sources."""
    gravity, drag, restitution, friction, threshold = decided(HEADER, PHYSICS_CONSTANTS)
    kept, rate, dt = drag * restitution, -math.log(drag), 1 / 60
    kappa = drag * rate / (1 - drag)
    phi2 = ((1 - drag) / rate - 1) / -rate
    gains = [round(threshold / restitution * factor, 2) for factor in (1, 1 + kept, 1 / (1 - kept))]
    rates = [round(drag * gravity * restitution / threshold / factor, 2) for factor in (1, 1 + kept, 1 / (1 - kept))]
    band = re.search(r"return Band\{.*?values, (\S+)\), quantile\(values, (\S+)\),\s+quantile\(values, (\S+)\)\}", text_of("sim/result/estimate.h"))
    frames = [(n, (1 - drag**n) * drag / (1 - drag)) for n in (60, 7680)]
    way_s, fallen_px = -math.expm1(-60 * rate) / (60 * rate), gravity * (1 + math.expm1(-60 * rate) / (60 * rate)) / (60 * rate)
    ends_px = [math.hypot(900 * (s / n - way_s), -900 * (s / n - way_s) + gravity * drag / (1 - drag) * (n - s) / n**2 - fallen_px)
               for n, s in frames]
    speeds = [1000.0]
    while len(speeds) == 1 or speeds[-1] != speeds[-2]:
        speeds.append(speeds[-1] * drag * friction)
    exponent, = decided("tools/recorder/recording.h", "kFramesMax = std::int64_t{1} <<")
    normal = sum(speed >= sys.float_info.min for speed in speeds)
    unsteady, *parts = decided("sim/study/methods/cost.h", "kDriftMax_rel") + [
        float(each) for each in re.findall(r"quantile\(probes_ns, (0\.\d5)\)", text_of("sim/study/methods/cost.cpp"))]
    chance, least = decided("sim/study/methods/cost.cpp", "kChanceMax, kLeast")
    processes = max(least, math.ceil(1 + math.log2(stated(STUDIES, "for the {} pairs of its own")[0] / chance)))
    rates_hz = re.search(r"\{(20\.0, 24\.0, 25\.0[^}]*)\}", text_of("sim/study/hard_cases/hard_families.cpp"))[1].split(",")
    return (
        (STUDIES, "It is {} px off after one second at {} Hz, and {} px at {} Hz", [round(ends_px[0], 2), 60, round(ends_px[1]), 7680]),
        (STUDIES, "so that after some {}\nsteps it is below {} px/s", [round(normal, -2), float(f"{sys.float_info.min:.1e}")]),
        (STUDIES, "and {} steps later stuck at two units of the last place ({}\npx/s)", [round(len(speeds) - normal, -1), speeds[-1]]),
        (STUDIES, "more than {} %\n({}th minus {}th percentile)", [100 * unsteady, *(100 * part for part in parts)]),
        (STUDIES, "If that takes {} % longer", [100 * unsteady]), (STUDIES, "keep that below {} % for all its comparisons", [100 * chance]),
        (STUDIES, "are equal): {} for the", [processes]), (DRIFT, "in every one of {} processes", [processes]),
        (STUDIES, "is also dropped at {}\ndisplay rates", [len(rates_hz)]),
        ("README.md", "Below {} Hz a sprite on the floor", rates[:1]), (FILES, "the {} scenarios here", [SCENARIOS]),
        *((STUDIES, words, [100 * part for part in decided(f"sim/study/{source}.cpp", name)]) for words, source, name in (
            ("spread less in more than {} % of the flings, beyond", "frame_rate/frame_rate_study", "steadier_by_time[clock].low() >"),)),
        (DRIFT, "per frame: {} px of height per second at {} Hz, whatever", [round((drag - kappa**2 * phi2) * gravity * dt), 60]),
        (STUDIES, "| median ({} .. {} %) | quantiles", [100 * float(band[2]), 100 * float(band[3])]), (STUDIES, "one step adds a = {} G dt", [drag]),
        (FILES, "`constants` float64 [{}]", [len(PHYSICS_CONSTANTS.split(", "))]), (DRIFT, "takes {} % of the speed", [round(100 * (1 - drag), 9)]),
        (STUDIES, "| < {} px/s | above {} Hz | zero speed |", [gains[0], rates[0]]), (CORE, "; {} of the energy remains", [restitution**2]),
        (STUDIES, "| {} .. {} px/s | {} .. {} Hz | two-cycle:", [*gains[:2], rates[1], rates[0]]), (DRIFT, "a L / (1 - a) = {}", [round(kappa, 8)]),
        (STUDIES, "| {} .. {} px/s | {} .. {} Hz | two-cycle or", [gains[1], round(gains[2], 1), rates[2], rates[1]]),
        (STUDIES, "| > {} px/s | below {} Hz | residual speed, constant: -{} a / (1 + {} * {})",
         [round(gains[2], 1), rates[2], restitution, restitution, drag]), (SWEEPS, '"few bounces, far right:", ((file["members/contacts"][:, {}] <',
         [re.search(r'"contacts with ([a-z, ]+)"', text_of("tools/store/ensemble_file.cpp"))[1].split(", ").index("ground")]),
        ("sim/README.md", "vy constant ({} px/s at {} Hz)", [round(-restitution * drag * gravity * dt / (1 + kept), 3), 60]),
        (SWEEPS, "leaves at most {} |vx| dt", [round(1 / (1 - drag * friction), 2)]), (DRIFT, "k = -ln({}) / dt", [drag]),
        (DRIFT, "k = {} 1/s", [round(60 * rate, 7)]), (DRIFT, "It differs from {}, because", [restitution]),
        (DRIFT, "(G² h / 2) t: {} px²/s² per second at {} Hz", [round(gravity**2 * dt / 2, 6), 60]),
        (DRIFT, "phi2) G h = {} px/s", [round((drag - kappa**2 * phi2) * gravity * dt, 4)]), (DRIFT, "not at the wall: - {} / 2 of", [round(1 - restitution**2, 9)]),
        (DRIFT, "So a bounce takes {} of what", [round(1 - restitution**2, 9)]),
        ("README.md", "changed from {} to {}, by one ulp", [gravity, math.nextafter(gravity, math.inf)]),
        (FILES, "rounded to {} decimals", [len(re.search(r"x ([\d.]+) px, y", text_of("golden/flings/first-fling.txt"))[1].split(".")[1])]),
        *((document, words, [round(2**exponent / 60 / 3600)]) for document, words in (
            (HYRAX, "frames, about {} hours of motion"), ("tools/hyrax/help.txt", "after about {} hours of motion"))))


class Numbers(unittest.TestCase):
    """What a reader relies on."""

    def test_what_is_stated_is_what_decides_it(self):
        """A source, constants from which it follows, or what was printed."""
        rows = [*((document, words, decided(source, names)) for document, words, source, names in STATED), *computed(),
                *((document, words, [number for place in printed for number in stated(*place)] or None)
                  for document, words, *printed in SAID_AGAIN)]
        for document, words, numbers in rows:
            with self.subTest(document=document, words=words):
                self.assertEqual(stated(document, words), numbers)

    def test_every_number_has_a_source_or_is_in_the_list(self):
        """But for the paper's claims: tests/oracle/claims_test.py measures theirs."""
        rows = [row[:2] for row in (*STATED, *SAID_AGAIN, *computed())]
        for document in (*(each for each in DOCUMENTS if each.name != "claims.md"), SOURCE / "tools/hyrax/help.txt", SOURCE / "tools/hyrax-replay/help.txt"):
            path = str(document.relative_to(SOURCE))
            text = re.sub(r"^```.*?^```$", lambda block: re.sub(r"\d", "-", block[0]), text_of(path), flags=re.DOTALL | re.MULTILINE)
            for words in (row[1] for row in rows if row[0] == path):
                for place in places_of(path, words):
                    text = text[:place.start()] + re.sub(r"\d", "-", place[0]) + text[place.end():]
            numbers = re.findall(r"(?<![\w./-])\d[\w.:,']*\b(?:(?<=e)-\d+)?", text)
            self.assertEqual(" ".join(numbers), NO_SOURCE.get(path, ""), path)

    def test_every_exit_code_in_a_document_is_one_of_these(self):
        helps = [each for folder in ("app", "files", "hyrax-sim") for each in (SOURCE / "tools" / folder).rglob("*") if each.suffix in (".cpp", ".json")]
        for document in {row[0] for row in STATED if row[0].endswith((".md", ".txt"))} | {
                str(each.relative_to(SOURCE)) for each in (*helps, *DOCUMENTS) if each in helps or each.name == "README.md"}:
            prose = re.sub(r"```.*?```", lambda block: " " * len(block[0]), text_of(document), flags=re.DOTALL)
            spans = [places_of(document, row[1])[0].span() for row in STATED if row[0] == document]
            for code in re.finditer(r"[Ee]xit(?: codes?:?)? (\d+)", prose):
                self.assertTrue(any(first <= code.start(1) < last for first, last in spans), (document, code[0]))

    def test_figures_of_speed_reach_their_goal_or_are_marked(self):
        sources = re.sub(r'"\s*\n\s*"', "", "".join(text_of(path) for path in (SOURCE / "tests/benchmarks").glob("*_figures.cpp")))
        rows = re.findall(r"^(\S.*?) {2,}([\d.e-]+) .*\((\S+) \.\. (\S+)\)  at (least|most) (\S+)(  NOT REACHED)?$", text_of(BENCHMARKS), re.MULTILINE)
        self.assertGreater(len(rows), 25)
        for name, *numbers, kind, goal, mark in rows:
            with self.subTest(name=name):
                measured, low, high = map(float, numbers)
                self.assertTrue(low <= measured <= high)
                self.assertEqual(bool(mark), measured < float(goal) if kind == "least" else measured > float(goal))
        of_sweeps = re.findall(r"^\S.*? {2,}([\d.]+) \(([\d.]+) \.\. ([\d.]+)\)$", text_of(SWEEPS), re.MULTILINE)
        self.assertEqual([float(low) <= float(median) <= float(high) for median, low, high in of_sweeps], 11 * [True])
        with_source = 0
        goals = re.findall(r'ratio\("([^"]*)"(?: \+ \w+ \+ "([^"]*)")?,[^;]*?Goal::at_(least|most), (\d[\d.]*)', sources)
        self.assertEqual(len(goals), len(re.findall(r"Goal::at_\w+, \d", sources)))
        for first, last, kind, goal in goals:
            found = [row[4:6] for row in rows if re.fullmatch(re.escape(first) + (f".+{re.escape(last)}" if last else ""), row[0])]
            with self.subTest(source=first + last):
                self.assertEqual({(each, float(stated_goal)) for each, stated_goal in found}, {(kind, float(goal))})
            with_source += len(found)
        self.assertGreaterEqual(with_source, 10)

    def test_every_total_is_that_of_its_table(self):
        text = text_of(TESTS)
        rows = [[int(cell) for cell in re.findall(r"\d+", cells)] for cells in re.findall(r"^\| `sim/\S+` ((?:\| \d+ )+)\|$", text, re.MULTILINE)]
        total = re.search(r"^\| all ((?:\| \d+ )+)\|$", text, re.MULTILINE)[1]
        self.assertGreater(len(rows), 5)
        self.assertEqual([sum(column) for column in zip(*rows)], [int(cell) for cell in re.findall(r"\d+", total)])
        self.assertEqual([row[0] for row in rows], [sum(row[1:]) for row in rows])
        cores = re.search(r"each of the (\d+) \[altered cores\].*?\n\n((?:\|.*\n)+)", text, re.DOTALL)
        self.assertEqual(sum(int(count) for count in re.findall(r"\| (\d+) \|", cores[2])), int(cores[1]))

    def test_mutants_of_the_core_are_those_of_the_sources_and_the_reasons(self):
        core = [subject for subject in subjects.SUBJECTS if subject.is_core]
        build = types.SimpleNamespace(source=SOURCE, objects=[subject.path for subject in core])
        reasons = [(reason.get("caught_by", "equivalent"), path, name) for reason in json.loads(text_of("tests/must_fail/mutation/reasons.json"))
                   for path, names in reason["mutants"].items() for name in names]
        for (subject, _), mutants in subjects.mutants_by_subject(build).items():
            if subject.is_core:
                names = {mutant.name for mutant in mutants}
                by = [sum(name in names for how, path, name in reasons if (how, path) == (each, subject.path)) for each in ("unit test", "equivalent")]
                self.assertEqual(stated(TESTS, f"| `{subject.path}` | {{}} | {{}} | {{}} | {{}} |"), [len(mutants), len(mutants) - sum(by), *by])

    def test_a_member_of_a_sweep_has_the_bytes_that_are_stated(self):
        sweep = re.search(r"```json rest-places.json\n(.*?)```", text_of(SWEEPS), re.DOTALL)[1].replace("3000", "50").replace(
            '"scenarios', f'"{SOURCE}/scenarios')
        with tempfile.TemporaryDirectory(prefix="hyrax-") as folder:
            pathlib.Path(folder, "sweep.json").write_text(sweep, encoding="utf-8")
            run(PROGRAM, "sweep", "sweep.json", "-q", cwd=folder)
            with h5py.File(f"{folder}/sweep.h5") as file:
                columns = [column for group in ("members", "inputs") for column in file[group].values() if column.shape[:1] == (50,)]
                self.assertEqual([sum(column.dtype.itemsize * math.prod(column.shape[1:]) for column in columns)],
                                 stated(SWEEPS, "default columns and three inputs are {} bytes a member"))

    def test_every_count_of_scenarios_is_that_of_the_folder(self):
        self.assertEqual(set(re.findall(r"of (\d{3}) (?:agree|differ)", text_of(TESTS))), {str(SCENARIOS), str(SCENARIOS - 1)})

    def test_what_is_said_of_displays_is_what_is_printed(self):
        off = re.findall(r"^ +(\d+)  \d+ \(.*?\) +\d+ \(.*?\) +(\d+) \(.*?\) +(\d+) \(.*?\) +\d+ of 121 +\d+ of 121$", text_of(STUDIES), re.MULTILINE)
        self.assertEqual(len(off), 7)
        by_time = [int(row[2]) for row in off]
        self.assertEqual(by_time, sorted(by_time, reverse=True))
        self.assertIn("by time\nflings settle nearer to it the shorter the frames are", text_of(STUDIES))
        self.assertRegex(text_of(STUDIES), r"\n  the paper's step +-  [^`]*```\n\n[^`]*`order`[^`]*The paper's step\n  has none: its error grows")
        self.assertEqual([float(min(off, key=lambda row: int(row[1]))[0])], stated(STUDIES, "by the paper's step they do so near {} Hz"))

    def test_displays_are_those_of_the_scenarios(self):
        scenarios = [json.loads(text_of(path)) for path in (SOURCE / "scenarios/displays").glob("*.json")]
        sizes = [tuple(each["window"].values()) for each in scenarios if each["window"]["width_px"] > 200]
        rates = [each["clock"]["rate_hz"] for each in scenarios if "rate_hz" in each["clock"]]
        same = len(list((SOURCE / "scenarios/clocks").glob("fling-*-hz.json")))
        long_s = [dt_s for each in scenarios if each["clock"].get("dt_s")
                  for dt_s in (each["clock"]["dt_s"], *(event["hitch"]["dt_s"] for event in each["events"] if "hitch" in event))]
        self.assertEqual(stated(FORMAT, "{} frame rates of the same fling"), [same])
        self.assertEqual(stated(FORMAT, "frames of {} to {} ms"), [1000 * min(long_s), 1000 * max(long_s)])
        self.assertEqual(stated(FORMAT, "real displays from {} x {} to {} x {} px at {} to {} Hz"),
                         [*min(sizes), *max(sizes), min(rates), max(rates)])
