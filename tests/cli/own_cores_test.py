"""Cores that describe themselves, each held to a loop of its own, in a project that uses the package."""

import csv
import json
import math
import os
import shutil

import numpy as np

from installed_package import InstalledPackage
from process import run, succeed
from program import AGREED, DISAGREED, SOURCE

PROJECT = SOURCE / "tests/cli/own_cores"
DT = 1.0 / 60.0
CTEST_FAILED = 8


def scenario(steps=300, **changes):
    return {"format": "hyrax-scenario/1", "name": "one", "clock": {"rate_hz": 60}, "steps": steps, **changes}


BALLS = scenario(600, start={"a.vx_px_per_s": 420.5}, inputs={"width_px": 700}, parameters={"restitution": 0.75}, events=[
    {"step": 200, "strike": {"vx_px_per_s": -90, "vy_px_per_s": 600}}, {"step": 300, "hold": {}}, {"step": 310, "set": {"height_px": 500}},
    {"step": 320, "go": {}}, {"step": 400, "hitch": {"dt_s": 0.05}}, {"step": 500, "stop": {}}])


def balls():
    """State, contacts and output of each row."""
    a, b = [100.0, 100.0, 420.5, 40.0], [300.0, 110.0, 0.0, 0.0]
    width, height, radius, restitution = 700.0, 600.0, 20.0, 0.75
    rail = meet = 0
    for frame in range(601):
        distance = math.sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]))
        yield (*a, *b, rail, meet, distance)
        dt, rail, meet = 0.05 if frame == 400 else DT, 0, 0
        if frame == 200:
            a[2:] = -90.0, 600.0
        if frame == 310:
            height = 500.0
        if frame == 500:
            a[2:] = b[2:] = 0.0, 0.0
        if 300 <= frame < 320:
            continue
        for p in (a, b):
            p[0] += p[2] * dt
            p[1] += p[3] * dt
            for axis, size in ((0, width), (1, height)):
                if (p[axis] < radius and p[axis + 2] < 0) or (p[axis] > size - radius and p[axis + 2] > 0):
                    p[axis + 2], rail = -p[axis + 2], 1
        dx, dy = b[0] - a[0], b[1] - a[1]
        d = math.sqrt(dx * dx + dy * dy)
        if 0 < d < 2 * radius:
            nx, ny = dx / d, dy / d
            closing = (a[2] - b[2]) * nx + (a[3] - b[3]) * ny
            if closing > 0:
                j, meet = 0.5 * (1 + restitution) * closing, 1
                a[2], a[3], b[2], b[3] = a[2] - j * nx, a[3] - j * ny, b[2] + j * nx, b[3] + j * ny


PET = scenario(parameters={"gravity_px_per_s2": 1000}, start={"pose": "fly", "bounces": 7}, events=[
    {"at_s": 2.0, "fling": {"vx_px_per_s": -300, "vy_px_per_s": -700}}])


def pet():
    x, y, vx, vy, spin, bounces, pose, floor = 200.0, 100.0, 150.0, 0.0, 3.0, 7, 1, 0
    for frame in range(301):
        yield x, y, vx, vy, spin, bounces, pose, floor
        if frame == 120:
            vx, vy = -300.0, -700.0
        vy += 1000.0 * DT
        x += vx * DT
        y += vy * DT
        vx += spin * DT
        spin *= 0.99
        floor = int(y > 500.0)
        pose = 2 if floor else 1
        if floor:
            y, vy, spin, bounces = 500.0, -vy * 0.6, -spin, bounces + 1


MOVES = [math.sin(frame / 20) > 0 and 1 or -0.25 for frame in range(120)]
PLATFORM = scenario(120, inputs={"move": MOVES}, events=[{"step": frame, "set": {"jump": True}} for frame in (10, 20, 90)])


def platform():
    f = np.float32
    x, y, vy, px, ground, jump, dt = f(40), f(0), f(0), f(50), 1, False, f(DT)
    for frame in range(121):
        yield float(x), float(y), float(vy), float(px), ground, ground if frame else 0
        if frame == 120:
            return
        move = f(MOVES[frame])
        jump |= frame in (10, 20, 90)
        px = px + move * f(200) * dt
        if jump and ground:
            vy = f(-700)
        jump = False
        vy = vy + f(1800) * dt
        y = y + vy * dt
        ground = int(y >= 0)
        if ground:
            y, vy, x = f(0), f(0), x + move * f(200) * dt


FIXED = scenario(start={"big": 2**64 - 3, "low": -2**62 - 1, "ticks": 254})


def fixed():
    x, v, ticks, s, big, low, up = 10 << 16, 3 << 16, 254, -3, 2**64 - 3, -2**62 - 1, 1
    for _ in range(301):
        yield x, v, ticks, s, big, low, up
        x += (v * int(DT * 65536.0)) >> 16
        if not 8 << 16 <= x <= 12 << 16:
            v, up = -v, 1 - up
        ticks, big, s = (ticks + 1) % 256, (big + 1) % 2**64, s + 1
        low += ticks
        if s == 5:
            s = -5


SAND = scenario(start={"grains.1.y_px": 20.5, "grains.2.x_px": 31}, steps=120)


def sand():
    grains, seen = [[10.0, 0.0, 0.0, 0], [20.0, 20.5, 0.0, 0], [31.0, 9.0, -20.0, 0]], [0, 0, 0]
    for row in range(121):
        yield (*(number for grain in grains for number in grain), *seen, grains[0][3] if row else 0)
        for i, grain in enumerate(grains):
            if not grain[3]:
                grain[2] += 100.0 * DT
                grain[1] += grain[2] * DT
                if grain[1] > 50:
                    grain[1], grain[3], seen[i] = 50.0, 1, 1


LINKED = scenario()


def linked():
    x, speed = 1.0, 2.0
    for _ in range(301):
        yield x, speed
        speed -= x * DT
        x += speed * DT


WIDE = scenario(50)


def wide():
    cells = [0.0] * 500
    for _ in range(51):
        yield tuple(cells)
        cells = [value + DT * float(i // 2) for i, value in enumerate(cells)]


LOOPS = {"balls": (BALLS, balls), "pet": (PET, pet), "platform": (PLATFORM, platform), "fixed": (FIXED, fixed),
         "sand": (SAND, sand), "linked": (LINKED, linked), "wide": (WIDE, wide)}

# What is known of the step of each, traced.
NO_NUMBER = "is no double, float, int or bool, and has no limits or names of at most 16 values"
STEPS = {
    "platform": "complete, 6 paths",
    "balls": "not complete: more than 4,096 paths",
    "pet": f"not complete: bounces {NO_NUMBER}",
    "fixed": f"not complete: x {NO_NUMBER}",
    "sand": "not complete: memory outside the body: struct hyrax_core is not trivially copyable",
    "linked": "not complete: the step calls engine::game::tick",
    "wide": "not complete: more than 32 values",
}

# Members of struct hyrax_core, and the sentence of what does not compile in it.
STEP = "void step(double) {}"
STATE = "template <class See> void state(See&& see) { see(\"x\", x); }"
REFUSED = {
    STATE: "hyrax_core: has no public void step(double dt_s)",
    STEP: "hyrax_core: has no template <class See> void state(See&& see)",
    STEP + STATE + "std::unique_ptr<int> p;": "hyrax_core: is not copyable",
    STEP + STATE + "template <class See> void input(See&& see) { see(\"y\", x); }": "hyrax_core: the list input(see) is named inputs",
    STEP + STATE + "template <class See> void property(See&&) {}": "hyrax_core: the list property(see) is named properties",
    STEP + STATE + "template <class See> void collisions(See&&) const {}": "hyrax_core: the list collisions(see) is named contacts",
    STEP + STATE + "template <class See> void inputs(See see) { see(\"y\", x); }": "hyrax_core: the list inputs is public template <class See> void",
    STEP + STATE + "private: template <class See> void parameters(See&& see) { see(\"y\", x); }":
        "hyrax_core: the list parameters is public template <class See> void",
    STEP + STATE + "private: template <class See> void contacts(See&& see) const { see(\"y\", x > 0); }":
        "hyrax_core: the list contacts is public template <class See> void",
    STEP + "private: " + STATE: "hyrax_core: the list state is public template <class See> void",
    STEP + "template <class See> void state(const See& see) { see(\"x\", x, {0.0, 1.0}); }": "hyrax_core: the list state is public template <class See> void",
    STEP + "template <class See> void state(See&& see) { see(\"x\", k); }": "hyrax: what is const cannot be set",
    STEP + "template <class See> void state(See&& see) const { see(\"x\", x); }": "hyrax: what is const cannot be set",
    STEP + "template <class See> void state(See&& see) { see(\"x\", set); }": "hyrax: the elements of a range are temporaries or const",
    STEP + "template <class See> void state(See&& see) { see(x); }": "hyrax: a value is see(NAME, VALUE)",
    STEP + STATE + "template <class See> void actions(See&& see) { see([&] { x = 1; }); }": "hyrax: an action is see(NAME, FUNCTION)",
    STEP + STATE + "template <class See> void contacts(See&& see) const { see(x > 0); }": "hyrax: a contact is see(NAME, CONDITION)",
    STEP + STATE + "template <class See> void properties(See&& see) const { see(\"a\", x > 0); }":
        "hyrax: a property is see.always(NAME, CONDITION) or see.sometimes(NAME, CONDITION)",
    STEP + STATE + "template <class See> void properties(See&& see) const { see.always(x > 0); }":
        "hyrax: a property is see.always(NAME, CONDITION) or see.sometimes(NAME, CONDITION)",
    STEP + "template <class See> void state(See&& see) { see(\"x\", x + 1); }": "hyrax: a temporary cannot be set",
    STEP + "template <class See> void state(See&& see) { see(\"x\", s); }": "hyrax: a string is no value",
    STEP + "template <class See> void state(See&& see) { see(\"x\", o); }": "hyrax: a value is a double, float, bool, integer or enum",
    STEP + "template <class See> void state(See&& see) { see(\"x\", u); }": "hyrax: a value is a double, float, bool, integer or enum",
    STEP + "template <class See> void state(See&& see) { see(\"x\", [&] { return x; }); }": "hyrax: a getter needs a setter",
    STEP + STATE + "template <class See> void actions(See&& see) { see(\"a\", [&](double b) { x = b; }); }":
        "hyrax: an action has a name for each argument",
    STEP + STATE + "template <class See> void actions(See&& see) { see(\"a\", [&](double b) { x = b; }, {\"b\", \"c\"}); }":
        "hyrax: an action has a name for each argument",
    STEP + STATE + "template <class See> void actions(See&& see) { see(\"a\", [&](double& b) { b = x; }, {\"b\"}); }":
        "hyrax: an argument of an action is a double, float, bool, integer or enum, by value",
    STEP + "struct ball { double y = 0; " + STATE.replace("x", "y") + " } b; template <class See> void state(See&& see) { see(\"b\", b, {0.0, 1.0}); }":
        "hyrax: limits and names are of values, not of a struct",
    STEP + "template <class See> void state(See&& see) { see(\"x\", x, {1.0}); }": "hyrax: limits are two, {LOW, HIGH}",
    STEP + "template <class See> void state(See&& see) { see(\"x\", x, {}); }": "hyrax: limits are two, {LOW, HIGH}",
    STEP + "template <class See> void state(See&& see) { see(\"x\", x, {1.0, 2.0, 3.0}); }": "hyrax: limits are two, {LOW, HIGH}",
    STEP + "template <class See> void state(See&& see) { see(\"x\", [&] { return x; }, [&](double y) { x = y; }, {1.0, 2.0, 3.0}); }":
        "hyrax: limits are two, {LOW, HIGH}",
    STEP + "template <class See> void state(See&& see) { see(\"x\", [&] { return x; }, [&](double y) { x = y; }, {1.0}); }":
        "hyrax: limits are two, {LOW, HIGH}",
    STEP + "bool b; template <class See> void state(See&& see) { see(\"b\", b, {\"no\", \"yes\"}); }": "hyrax: names are of the values of an enum or integer",
}
HEADER = """#include <memory>
#include <optional>
#include <set>
#include <string>
struct unknown { double x = 0; };
struct hyrax_core { double x = 0; const double k = 1; std::string s; std::set<int> set; std::optional<double> o; unknown u;
%s };
"""


class OwnCoresProject(InstalledPackage):
    """The project of own_cores/, built once for all tests of a process."""

    project = None

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if not OwnCoresProject.project:
            OwnCoresProject.project = cls.root / "cores"
            OwnCoresProject.warning = cls.built()

    @classmethod
    def built(cls):
        """Builds it; returns the warnings of CMake."""
        shutil.copytree(PROJECT, cls.project)
        for core, (document, _) in LOOPS.items():
            path = cls.project / core / "scenarios/one.json"
            path.parent.mkdir(parents=True)
            path.write_text(json.dumps(document), encoding="utf-8")
        outcome = cls.configure(cls.project, "-DCMAKE_BUILD_TYPE=Quick", "-DCMAKE_CXX_FLAGS_QUICK=-O0")
        assert outcome.exit_code == 0, outcome
        succeed("cmake", "--build", cls.project / "build")
        return " ".join(outcome.err.split())

    def use(self, core):
        self.program = self.project / f"build/{core}-sim"


class OwnCores(OwnCoresProject):
    def rows(self, document):
        """Of a run as CSV: the columns, and the numbers of each row after step, t_s, dt_s."""
        self.write("one.json", document)
        self.expect(AGREED, "run", "one.json", "-o", "one.csv")
        with open(self.folder / "one.csv", encoding="utf-8") as file:
            columns, *rows = csv.reader(file)
        return columns[3:], [tuple(float(text) if "." in text or "e" in text else int(text) for text in row[3:]) for row in rows]

    def test_each_core_is_its_plain_loop(self):
        for core, (document, loop) in LOOPS.items():
            with self.subTest(core):
                self.use(core)
                _, rows = self.rows(document)
                expected = list(loop())
                self.assertEqual(len(rows), len(expected))
                for step, (row, wanted) in enumerate(zip(rows, expected)):
                    # A float is written as short as it is one.
                    self.assertEqual([np.float32(number) if core == "platform" else number for number in row], list(wanted), step)

    def test_the_table_has_every_way_to_move(self):
        """The control of the loops: what they are about happens in them."""
        self.assertGreater(sum(row[-3] for row in balls()), 2)
        self.assertGreater(sum(row[-2] for row in balls()), 1)
        self.assertGreater(list(pet())[-1][5], 9)
        self.assertEqual({row[4] for row in platform()}, {0, 1})
        self.assertEqual({row[-1] for row in sand()}, {0, 1})

    def test_what_a_program_records_replays(self):
        self.use("pet")
        document = self.expect_recording_replays(self.project / "build/game")
        self.assertEqual([event[key] for event in document["events"] for key in event if key != "step"],
                         [{"vx_px_per_s": 1200.5, "pose": "sit"}, {"spin_rad_per_s": -7.25}, {}, {}])

    def test_a_run_is_held_to_its_own_repetition(self):
        """What else a description can get wrong: tests/unit/sim/described."""
        self.use("faulty")
        self.write("one.json", scenario(400))
        self.expect(AGREED, "run", "one.json", "-o", "one.h5")
        self.write("one.json", scenario(400, parameters={"fault": "first_run"}))
        self.assertIn("a second run is not the same: its state hash differs", self.expect(DISAGREED, "run", "one.json", "-o", "one.h5").out)

    def test_info_says_which_steps_are_complete_and_why_others_are_not(self):
        for core, step in STEPS.items():
            self.use(core)
            info = self.expect(AGREED, "info", "--json").json
            self.assertEqual(info["step"][:len(step)], step)
            self.assertEqual(info["beyond_library"], "not for cores that describe themselves yet")

    def test_an_empty_library_warns_with_the_command_to_write_one(self):
        self.assertIn("no scenario file, *.json, in", self.warning)
        self.assertIn("faulty-sim new NAME", self.warning)
        self.assertNotIn("pet-sim new NAME", self.warning)
        listed = run("ctest", "--test-dir", self.project / "build", "-N").out
        self.assertIn(" pet.one\n", listed)
        self.assertIn(" linked.accepted_core\n", listed)
        self.assertNotIn(" faulty.", listed)

    def test_a_library_that_is_blessed_passes_until_its_core_changes(self):
        for core in LOOPS:
            self.use(core)
            self.expect(AGREED, "bless", self.project / core / "scenarios", "--reason", "the first results")
        tests = self.ctest(self.project, 0)
        self.assertEqual(tests, {f"{core}.{name}": True for core in LOOPS for name in ("one", "unreferenced_golden")})
        header = self.project / "engine.h"
        text = header.read_text(encoding="utf-8")
        for start, exit_code in (("m_x = 1.5", CTEST_FAILED), ("m_x = 1", 0)):
            header.write_text(text.replace("m_x = 1", start), encoding="utf-8")
            succeed("cmake", "--build", self.project / "build", "--target", "linked-sim")
            self.assertEqual(self.ctest(self.project, exit_code), {**tests, "linked.one": exit_code == 0})

    def test_wrong_arguments_are_refused(self):
        self.write("refused/a.h", "")
        for arguments, says in (("scenarios CORE a.h PHYSICS a.h", "PHYSICS and CORE: a core is one of the two"),
                                ("scenarios LINK engine", "LINK needs CORE"), ("scenarios CORE none.h", "CORE: no such file")):
            self.expect_refused(arguments, says, language="CXX")

    def test_what_does_not_compile_says_why_in_its_first_error(self):
        compilers = {os.path.realpath(shutil.which(name)) for name in (os.environ["HYRAX_CXX"], "g++", "clang++") if shutil.which(name)}
        source = self.package / "share/hyrax/source"
        for number, compiler in enumerate(sorted(compilers)):
            compiles = compiler, "-std=c++20", f"-I{source}"
            see = self.folder / self.write(f"{number}/see.h", '#include "sim/described/see.h"\n')
            succeed(*compiles, "-x", "c++-header", see, "-o", f"{see}.gch")  # It takes most of the time.
            for members, sentence in {**REFUSED, None: "hyrax_core: the header has no global struct hyrax_core"}.items():
                with self.subTest(compiler=compiler, sentence=sentence):
                    path = self.write("bad.h", HEADER % members if members else "struct another_core {};\n")
                    outcome = run(*compiles, "-fsyntax-only", "-include", see, f'-DHYRAX_DESCRIBED_HEADER="{self.folder / "bad.h"}"',
                                  '-DHYRAX_DESCRIBED_NAME="bad"', source / "sim/described/built_described_core.cpp")
                    self.assertNotEqual(outcome.exit_code, 0)
                    first = next(line for line in outcome.err.splitlines() if "error" in line)
                    self.assertIn(sentence, first.replace('\\"', '"'), path)
