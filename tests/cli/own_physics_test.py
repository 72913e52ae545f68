#!/usr/bin/python3
"""A project with a class physics of its own, and one without, which use hyrax as an installed package only."""

import json
import os
import pathlib
import re
import shutil
import tempfile
import time
import unittest

import h5py
import numpy as np

import program
from process import run, succeed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, SOURCE, ProgramTest, main

EXAMPLE = SOURCE / "tests/cli/own_physics"
HYRAX_SIM = program.PROGRAM
CTEST_FAILED = 8

FLING = "scenarios/flings/first-fling.json"
PLAIN = """cmake_minimum_required(VERSION 3.25)
project(plain LANGUAGES {language})
find_package(hyrax 0.2 REQUIRED)
hyrax_add_scenarios({arguments})
"""


def elastic_rows(steps, rate_hz, state, bounds):
    """The example's world in Python: x, y, vx, vy of each row."""
    x, y, vx, vy = state
    rows = [(x, y, vx, vy)]
    for _ in range(steps):
        x, y = x + vx * (1.0 / rate_hz), y + vy * (1.0 / rate_hz)
        if not 0.0 <= x <= bounds[0]:
            x, vx = (0.0 if x < 0.0 else 2.0 * bounds[0]) - x, -vx
        if not 0.0 <= y <= bounds[1]:
            y, vy = (0.0 if y < 0.0 else 2.0 * bounds[1]) - y, -vy
        rows.append((x, y, vx, vy))
    return np.array(rows)


class OutsideProject(ProgramTest):
    """The package, installed and moved: it must not remember where it was made."""

    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-test-"))
        cls.addClassCleanup(shutil.rmtree, cls.root)
        environment = {key: value for key, value in os.environ.items() if key != "DESTDIR"}
        succeed("cmake", "--install", os.environ["HYRAX_BUILD"], "--prefix", cls.root / "first", env=environment)
        cls.package = (cls.root / "first").rename(cls.root / "package")

    @classmethod
    def configure(cls, source, *options):
        """Runs cmake in SOURCE/build."""
        return run("cmake", "-S", source, "-B", source / "build", "-G", os.environ["HYRAX_GENERATOR"],
                   f"-DCMAKE_PREFIX_PATH={cls.package}", f"-DCMAKE_CXX_COMPILER={os.environ['HYRAX_CXX']}",
                   f"-DCMAKE_CXX_FLAGS={os.environ['HYRAX_CXX_FLAGS']}", *options)

    def ctest(self, source, exit_code):
        """Runs the project's tests, which must end with this exit code; returns {name: is passed} of the scenarios'."""
        tests = self.all_tests(source, exit_code)
        return {name: is_passed for name, is_passed in tests.items() if not name.endswith(".accepted_core")}

    def all_tests(self, source, exit_code):
        """Those of ctest and the one of the accepted core."""
        outcome = run("ctest", "--test-dir", source / "build", "--output-on-failure")
        self.assertEqual(outcome.exit_code, exit_code, outcome)
        lines = [line.split() for line in outcome.out.splitlines() if " Test " in line and "#" in line]
        return {line[3]: "Passed" in line for line in lines}

    def expect_refused(self, arguments, says, language="NONE"):
        """A project that cannot be configured."""
        source = self.folder / "refused"
        shutil.rmtree(source, ignore_errors=True)
        self.write("refused/scenarios/fling.json", program.fling())
        self.write("refused/CMakeLists.txt", PLAIN.format(arguments=arguments, language=language))
        outcome = self.configure(source)
        self.assertNotEqual(outcome.exit_code, 0, outcome)
        self.assertIn(says, " ".join(outcome.err.split()))


class WithoutPhysics(OutsideProject):
    """Scenarios of the shipped core."""

    def setUp(self):
        super().setUp()
        for name in ("flings/first-fling", "flings/corner-fling"):
            for path in (f"scenarios/{name}.json", f"golden/{name}.h5", f"golden/{name}.txt"):
                target = self.folder / path.replace("golden/", "accepted/")
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(SOURCE / path, target)
        self.write("CMakeLists.txt", PLAIN.format(arguments="scenarios/flings GOLDEN accepted", language="NONE"))

    def test_each_file_is_a_test_and_a_new_file_a_new_one(self):
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        self.assertEqual(self.ctest(self.folder, 0), {"hyrax.first-fling": True, "hyrax.corner-fling": True})
        scenario = (self.folder / FLING).read_text(encoding="utf-8")
        self.write("scenarios/flings/new/other-file.json", scenario.replace('"name": "first-fling"', '"name": "renamed"'))
        succeed("cmake", "--build", self.folder / "build")
        self.assertEqual(self.ctest(self.folder, CTEST_FAILED),  # It has no golden file yet.
                         {"hyrax.first-fling": True, "hyrax.corner-fling": True, "hyrax.new/renamed": False})

    def test_control_an_edited_scenario_turns_red(self):
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        scenario = self.folder / FLING
        scenario.write_text(scenario.read_text(encoding="utf-8").replace('"x_px": 60', '"x_px": 61'), encoding="utf-8")
        self.assertEqual(self.ctest(self.folder, CTEST_FAILED), {"hyrax.first-fling": False, "hyrax.corner-fling": True})

    def test_the_core_is_a_test_of_its_own_whatever_the_folder_is_called(self):
        shutil.move(self.folder / "scenarios/flings", self.folder / "throws")
        self.write("CMakeLists.txt", PLAIN.format(arguments="throws GOLDEN accepted", language="NONE"))
        self.expect(AGREED, "bless", "throws", "--golden", "accepted", "--reason", "first", "--accept", "shape")
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        names = ("hyrax.first-fling", "hyrax.corner-fling", "hyrax.accepted_core")
        self.assertEqual(self.all_tests(self.folder, 0), dict.fromkeys(names, True))
        step = self.folder / "accepted/core/step.txt"
        step.write_bytes(step.read_bytes() + b"\n")
        self.assertFalse(self.all_tests(self.folder, CTEST_FAILED)["hyrax.accepted_core"])

    def test_wrong_arguments_are_refused(self):
        self.expect_refused("nowhere", "no scenario file, *.json, in")
        self.expect_refused("scenarios SPEED 3", "unknown or without a value: SPEED;3; allowed: DIR [GOLDEN DIR]")
        self.expect_refused("scenarios GOLDEN", "unknown or without a value: GOLDEN; allowed:")
        self.expect_refused("scenarios NAME box", "NAME needs PHYSICS")
        self.expect_refused("scenarios PHYSICS none.h", "PHYSICS: no such file")
        self.expect_refused("scenarios PHYSICS CMakeLists.txt NAME a/b", "NAME: must be of letters, digits")


COUNTING = """#pragma once
class physics {
 public:
  physics(double x, double y, double vx, double vy) : m_x(x), m_y(y), m_vx(vx), m_vy(vy) {}
  void update(double dt, int width, int height, int object_width, int object_height) {
    m_vy += 980.0 * dt;
    m_x += m_vx * dt;
    m_y += m_vy * dt;
    if (m_x < 0.0) {
      m_x = 0.0;
      m_vx = -m_vx * 0.7;
    }
    if (m_x > width - object_width) {
      m_x = width - object_width;
      m_vx = -m_vx * 0.7;
    }
    if (m_y > height - object_height) {
      m_y = height - object_height;
      m_vy = -m_vy * 0.7;
      if (++bounces % 3 == 0) m_vy -= 300.0;
    }
  }
  double x() const { return m_x; }
  double y() const { return m_y; }
  double vx() const { return m_vx; }
  double vy() const { return m_vy; }
  void setPos(double x, double y) { m_x = x, m_y = y; }
  void setVelocity(double vx, double vy) { m_vx = vx, m_vy = vy; }
  void resetVelocity() { m_vx = m_vy = 0.0; }

 private:
  int bounces = 0;
  double m_x, m_y, m_vx, m_vy;
};
"""


def counting_rows(steps, state, bounds):
    """COUNTING in Python: x, y, vx, vy of each row, and how often each wall was met."""
    x, y, vx, vy = state
    dt, bounces, walls = 1.0 / 60.0, 0, {"left": 0, "right": 0, "top": 0, "ground": 0}
    rows = [(x, y, vx, vy)]
    for _ in range(steps):
        vy += 980.0 * dt
        x, y = x + vx * dt, y + vy * dt
        if x < 0.0:
            x, vx = 0.0, -vx * 0.7
            walls["left"] += 1
        if x > bounds[0]:
            x, vx = bounds[0], -vx * 0.7
            walls["right"] += 1
        if y > bounds[1]:
            y, vy, bounces = bounds[1], -vy * 0.7, bounces + 1
            walls["ground"] += 1
            if bounces % 3 == 0:
                vy -= 300.0
        rows.append((x, y, vx, vy))
    return np.array(rows), walls


class FurtherMembers(OutsideProject):
    """A core that counts its bounces, and bounces by them."""

    def test_its_rows_and_contacts_are_its_own(self):
        self.write("scenarios/fling.json", program.fling(
            name="fling", window={"width_px": 800, "height_px": 600}, steps=3000, sprite={"width_px": 100, "height_px": 100},
            start={"x_px": 350.25, "y_px": 251, "vx_px_per_s": 401.5, "vy_px_per_s": -303.25}))
        self.write("counting.h", COUNTING)
        self.write("CMakeLists.txt", PLAIN.format(arguments="scenarios PHYSICS counting.h", language="CXX"))
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        succeed("cmake", "--build", self.folder / "build")
        counting = self.folder / "build/counting-sim"
        self.assertRegex(run(counting, "info").out, r"\nstep +complete, 12 paths\n")
        outcome = run(counting, "run", "scenarios/fling.json", "--json", "-o", "run.h5", cwd=self.folder)
        self.assertEqual(outcome.exit_code, AGREED, outcome)
        rows, walls = counting_rows(3000, (350.25, 251.0, 401.5, -303.25), (700.0, 500.0))
        with h5py.File(self.folder / "run.h5") as file:
            stored = np.column_stack([file[f"trajectory/{name}"] for name in ("x", "y", "vx", "vy")])
            self.assertEqual(stored.tobytes(), rows.tobytes())
        clamped = outcome.json["runs"][0]["clamped_steps"]
        self.assertEqual({wall: clamped[wall] for wall in walls}, walls)


SHIPPED = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
# Constants of its own, under names of its own.
MOON = {"GRAVITY": ("PULL", 980.0), "RESTITUTION": ("BOUNCE", 0.75), "AIR_DRAG": ("AIR", 0.9985),
        "GROUND_FRICTION": ("FLOOR", 0.65), "REST_THRESHOLD": ("STILL", 12.0)}
WALLS = """    m_x += m_vx * dt;
    m_y += m_vy * dt;
"""
# The cores of other shapes: what is written for what, and the first expression that is not the paper's.
SHAPES = {
    "spin": (WALLS, "    m_vx += m_spin * dt;\n    m_spin *= 0.99;\n" + WALLS, "dt * member_5"),
    "shelf": ("  }\n\n  double x()", "    if (m_y > 500.0 && m_x < 200.0) m_vy = -m_vy;\n  }\n\n  double x()", "> 500"),
    "halves": (WALLS, "    for (int half = 0; half < 2; ++half) {\n      m_x += m_vx * (0.5 * dt);\n      m_y += m_vy * (0.5 * dt);\n    }\n",
               "dt * 0.5"),
}


def moon_header():
    header = SHIPPED
    for name, (own_name, value) in MOON.items():
        header = re.sub(rf"double {name} = [0-9.]+", f"double {own_name} = {value}", header)
        header = re.sub(rf"\b{name}\b", own_name, header)
    return header


def moon_rows(steps, rate_hz, state, bounds, constants):
    """The paper's step in Python: x, y, vx, vy of each row."""
    gravity, bounce, air, floor, still = constants
    x, y, vx, vy = state
    dt = 1.0 / rate_hz
    rows = [state]
    for _ in range(steps):
        vy += gravity * dt
        vx, vy = vx * air, vy * air
        x, y = x + vx * dt, y + vy * dt
        if x < 0.0 or x > bounds[0]:
            x, vx = 0.0 if x < 0.0 else bounds[0], -vx * bounce
        if y < 0.0:
            y, vy = 0.0, -vy * bounce
        elif y > bounds[1]:
            y, vy, vx = bounds[1], -vy * bounce, vx * floor
            vy = 0.0 if abs(vy) < still else vy
        rows.append((x, y, vx, vy))
    return np.array(rows)


class Shapes(OutsideProject):
    """Cores of the paper's shape, and of others: what each gets."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        project = cls.root / "shapes"
        project.mkdir()
        calls = ""
        headers = {"moon": moon_header()}
        # A further member that counts, and that nothing of x, y, vx and vy reads.
        headers["counted"] = moon_header().replace("      m_y = bottomBound;\n", "      m_y = bottomBound;\n      ++m_bounces;\n").replace(
            "  double m_vx, m_vy;\n", "  double m_vx, m_vy;\n  int m_bounces = 0;\n")
        for name, (old, new, _) in SHAPES.items():
            headers[name] = SHIPPED.replace(old, new)
            assert headers[name] != SHIPPED
        headers["leak"] = SHIPPED.replace("m_x > rightBound)", "m_x > rightBound + 40.0)")
        headers["spin"] = headers["spin"].replace("  double m_vx, m_vy;\n", "  double m_vx, m_vy;\n  double m_spin = 3.0;\n")
        for name, header in headers.items():
            (project / f"{name}.h").write_text(header, encoding="utf-8")
            calls += f"hyrax_add_scenarios(scenarios PHYSICS {name}.h)\n"
        (project / "scenarios").mkdir()
        (project / "scenarios/fling.json").write_text(json.dumps(cls.fling()), encoding="utf-8")
        (project / "CMakeLists.txt").write_text(PLAIN.format(arguments="scenarios PHYSICS moon.h", language="CXX") + calls.split("\n", 1)[1],
                                                encoding="utf-8")
        assert cls.configure(project).exit_code == 0
        succeed("cmake", "--build", project / "build")
        cls.build = project / "build"

    @staticmethod
    def fling():
        return program.fling(name="fling", window={"width_px": 1920, "height_px": 1080}, steps=600,
                             sprite={"width_px": 128, "height_px": 128},
                             start={"x_px": 350.25, "y_px": 251, "vx_px_per_s": 1401.5, "vy_px_per_s": -903.25})

    def setUp(self):
        super().setUp()
        self.write("fling.json", self.fling())
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": "fling.json", "members": 300, "seed": 3, "vary": {
            "/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/rate_hz": {"choice": [60, 144]}}})

    def tearDown(self):
        program.PROGRAM = HYRAX_SIM

    def use(self, name):
        program.PROGRAM = self.build / f"{name}-sim"

    def expect_sweep_as_runs(self):
        """A member of the sweep has the bits of its own run. Returns the steps computed and all steps."""
        document = self.expect(AGREED, "sweep", "sweep.json", "--json").json
        for member in (0, 7, 299):
            self.expect(AGREED, "sweep", "sweep.json", "--member", str(member), "-o", "m.json", "--force")
            final = self.expect(AGREED, "run", "m.json", "-o", "m.h5", "--json").json["runs"][0]["final"]
            with h5py.File(self.folder / "sweep.h5") as file:
                for column, key in (("x", "x_px"), ("y", "y_px"), ("vx", "vx_px_per_s"), ("vy", "vy_px_per_s")):
                    self.assertEqual(file[f"members/{column}"][member], final[key], (member, column))
        return document["steps_computed"], document["steps"]

    def expect_page(self, path):
        """Its page is no fault, though that has no copy of the core. A program without pages says so."""
        outcome = self.hyrax_sim("report", path, "-o", "page.html")
        self.assertEqual(outcome.exit_code, CANNOT_ACCESS if "HYRAX_PAGE" in outcome.err else AGREED, outcome)

    def test_the_same_shape_has_everything_with_its_constants(self):
        self.use("moon")
        constants = [value for _, value in MOON.values()]
        rows = moon_rows(600, 60, (350.25, 251.0, 1401.5, -903.25), (1792.0, 952.0), constants)
        self.assertIn(f"reference and energy ({program.PROGRAM} drift)", self.expect(AGREED, "run", "fling.json").out)
        self.expect(AGREED, "run", "fling.json", "-o", "run.h5", "--drift")
        with h5py.File(self.folder / "run.h5") as file:
            stored = np.column_stack([file[f"trajectory/{name}"] for name in ("x", "y", "vx", "vy")])
            self.assertEqual(stored.tobytes(), rows.tobytes())
            np.testing.assert_array_equal(file.attrs["constants"], constants)
        drift = self.expect(AGREED, "drift", "fling.json", "--json").json["runs"][0]
        self.assertLess(drift["worst"]["implementation_px"], 1e-9)
        self.assertEqual(self.expect(AGREED, "drift", "run.h5", "--json").json["runs"][0]["worst"], drift["worst"])
        self.assertIn("the model's is 0.75", self.expect(AGREED, "drift", "fling.json").out)
        self.expect_page("run.h5")
        # Another program measures the file by its constants, and replays it with them where rows are missing.
        self.write("seldom.json", {**self.fling(), "record": {"every": 100}})
        self.expect(AGREED, "run", "seldom.json", "-o", "seldom.h5")
        program.PROGRAM = HYRAX_SIM
        for path in ("run.h5", "seldom.h5"):
            outcome = self.expect(AGREED, "drift", path, "--json")
            self.assertEqual(outcome.json["runs"][0]["worst"], drift["worst"], path)
        self.assertNotIn("STATE HASH DIFFERS", self.expect(AGREED, "drift", "seldom.h5").out)
        self.use("moon")
        # The control: with other constants in the file, its rows are not those of the laws.
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file.attrs["constants"] = np.array([1200.0] + constants[1:])
        self.assertGreater(self.expect(AGREED, "drift", "run.h5", "--json").json["runs"][0]["worst"]["implementation_px"], 1.0)
        computed, steps = self.expect_sweep_as_runs()
        self.assertLess(computed, steps)  # The kernels leave steps at rest out.
        self.assertIn("all invariants hold", self.expect(AGREED, "fuzz", "--runs", "300").out)
        rest = self.expect(AGREED, "study", "rest", "--quick", "--no-figures", "--gate").out
        self.assertIn("zero speed above, two-cycle below    61.158", rest)  # (1 + e a) a G / threshold; the paper's: 191.8.
        self.expect(AGREED, "study", "needs", "fling.json", "--quick", "--no-figures", "--within", "1px")
        self.expect(BAD_INPUT, "study", "paper", says="is about the paper's own constants (found the core moon)")
        self.assertIn("the paper's step with constants of its own", self.expect(AGREED).out)
        self.expect(AGREED, "bless", "fling.json", "--golden", "golden", "--reason", "x")
        self.expect(AGREED, "check", "fling.json", "--golden", "golden")

    def test_a_further_member_that_nothing_reads_keeps_the_shape(self):
        self.use("counted")
        drift = self.expect(AGREED, "drift", "fling.json", "--json").json["runs"][0]
        self.assertLess(drift["worst"]["implementation_px"], 1e-9)
        self.expect_sweep_as_runs()

    def test_another_shape_is_refused_by_its_first_expression_and_has_the_rest(self):
        for name, (_, _, expression) in SHAPES.items():
            with self.subTest(name):
                self.use(name)
                for arguments in (("drift", "fling.json"), ("study", "needs"), ("run", "fling.json", "--drift")):
                    outcome = self.expect(BAD_INPUT, *arguments, says="needs the paper's step, with any constants")
                    self.assertRegex(outcome.err, rf"\(found in the core {name}: .*{re.escape(expression)}\)\n")
                computed, steps = self.expect_sweep_as_runs()
                self.assertGreater(computed, 0)
                self.assertLessEqual(computed, steps)
                self.assertIn("all invariants hold", self.expect(AGREED, "fuzz", "--runs", "100").out)
                golden = f"golden-{name}"
                self.expect(AGREED, "bless", "fling.json", "--golden", golden, "--reason", "x")
                self.expect(AGREED, "check", "fling.json", "--golden", golden)
                self.expect(AGREED, "run", "fling.json", "-o", f"{name}.h5")
                self.expect(AGREED, "diff", f"{golden}/fling.h5", f"{name}.h5")
                self.expect_page(f"{name}.h5")
                with h5py.File(self.folder / f"{name}.h5") as file:
                    self.assertNotIn("constants", file.attrs)
                self.expect(AGREED, "shrink", "fling.json", "--fails", "false {}", "-o", f"small-{name}.json")

    def test_control_fuzz_finds_a_core_that_leaves_the_window(self):
        self.use("leak")
        outcome = self.expect(DISAGREED, "fuzz", "--runs", "200")
        self.assertIn("breaks an invariant: in-bounds", outcome.out)
        self.assertIn(f"\n  {program.PROGRAM} run ", outcome.out)  # No study of hard cases for this shape.


class OwnPhysics(OutsideProject):
    """The example: another world, its golden files blessed by its own program."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.example = cls.root / "example"
        shutil.copytree(EXAMPLE, cls.example)
        start = time.monotonic()
        assert cls.configure(cls.example).exit_code == 0
        succeed("cmake", "--build", cls.example / "build")
        print(f"configured and built in {time.monotonic() - start:.1f} s")
        cls.program = shutil.copy(cls.example / "build/elastic_box-sim", cls.root)

    def setUp(self):
        super().setUp()
        shutil.copytree(self.example / "scenarios", self.folder / "scenarios")
        program.PROGRAM = self.program

    def tearDown(self):
        program.PROGRAM = HYRAX_SIM

    def blessed(self):
        """Makes the golden files of the copied scenarios."""
        self.bless("scenarios")

    def test_the_project_is_red_until_blessed_then_green_then_red_for_another_constant(self):
        project = self.example  # The other tests use a copy of its program.
        names = ("elastic_box.billiard", "elastic_box.long/many-bounces")
        self.assertEqual(self.ctest(project, CTEST_FAILED), dict.fromkeys(names, False))
        succeed(project / "build/elastic_box-sim", "bless", project / "scenarios", "--reason", "first results")
        self.assertEqual(self.ctest(project, 0), dict.fromkeys(names, True))
        header = project / "elastic_box.h"
        header.write_text(header.read_text(encoding="utf-8").replace("RESTITUTION = 1.0", "RESTITUTION = 0.999"),
                          encoding="utf-8")
        succeed("cmake", "--build", project / "build")
        self.assertEqual(self.ctest(project, CTEST_FAILED), dict.fromkeys(names, False))
        outcome = run(project / "build/elastic_box-sim", "check", "--json", cwd=project)
        self.assertEqual(outcome.exit_code, DISAGREED)
        long_run = outcome.json["results"][1]  # Its golden file has blocks and no rows: row checks find the row.
        self.assertEqual((long_run["class"], long_run["first_divergence"]["step"]), ("contacts", 28))
        self.assertEqual([(group["operation"], group["detail"]) for group in outcome.json["groups"]],
                         [("core", "RESTITUTION 1 -> 0.999")])
        text = run(project / "build/elastic_box-sim", "check", cwd=project).out
        self.assertIn("core: changed\n", text)
        self.assertIn(f"to accept it    {project}/build/elastic_box-sim bless scenarios", text)

    def test_rows_are_those_of_the_core_bit_for_bit(self):
        scenario = program.fling(window={"width_px": 800, "height_px": 600}, steps=3000,
                                 sprite={"width_px": 100, "height_px": 100},
                                 start={"x_px": 350.25, "y_px": 251, "vx_px_per_s": 401.5, "vy_px_per_s": -303.25})
        self.expect(AGREED, "run", self.write("fling.json", scenario), "-o", "run.h5", "--no-skip")
        rows = elastic_rows(3000, 60, (350.25, 251.0, 401.5, -303.25), (700.0, 500.0))
        with h5py.File(self.folder / "run.h5") as file:
            stored = np.column_stack([file[f"trajectory/{name}"] for name in ("x", "y", "vx", "vy")])
            self.assertEqual(stored.tobytes(), rows.tobytes())
            self.assertNotEqual(stored.tobytes(), (rows + 0.0 + np.finfo(float).eps).tobytes())  # The control.
            contacts = file["contacts"]
            first = contacts["step"][:]
            self.assertGreater(len(first), 50)
            for wall, axis, bound in ((1, 0, 0.0), (2, 0, 700.0), (4, 1, 0.0), (8, 1, 500.0)):
                met = contacts["wall"][:] == wall
                self.assertTrue(met.any())
                before, after, name = rows[first[met] - 1], rows[first[met]], "xy"[axis]
                np.testing.assert_array_equal(contacts[f"v{name}_before"][met], before[:, 2 + axis])
                np.testing.assert_array_equal(contacts[f"v{name}_after"][met], after[:, 2 + axis])
                moved = before[:, axis] + before[:, 2 + axis] * (1.0 / 60.0)
                np.testing.assert_array_equal(contacts["overshoot"][met], abs(moved - bound))
            turned = np.flatnonzero((rows[1:, 2] != rows[:-1, 2]) | (rows[1:, 3] != rows[:-1, 3])) + 1
            self.assertEqual(sorted(set(first)), list(turned))

    def test_files_say_whose_core_it_was(self):
        self.blessed()
        with h5py.File(self.folder / "golden/billiard.h5") as file:
            self.assertEqual(file.attrs["physics"], "elastic_box")
            self.assertNotIn("constants", file.attrs)
        self.assertIn("\nphysics: elastic_box\n", (self.folder / "golden/billiard.txt").read_text(encoding="utf-8"))
        self.assertRegex(self.expect(AGREED, "info").out, r"\nphysics +elastic_box\n")

    def test_golden_files_of_another_core_are_refused_by_both(self):
        self.blessed()
        before = self.state_of("golden")
        program.PROGRAM = HYRAX_SIM
        outcome = self.expect(BAD_INPUT, "check")
        self.assertIn("golden/billiard.h5: attribute physics: is of another core (found elastic_box); this program's "
                      "core is hyrax-physics/1", outcome.out)
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "by mistake")
        self.expect(BAD_INPUT, "drift", "golden/billiard.h5",
                    says="golden/billiard.h5: needs the paper's step, with any constants (found the core elastic_box, whose step is another)")
        program.PROGRAM = self.program
        outcome = self.expect(BAD_INPUT, "check", SOURCE / FLING)
        self.assertIn("is of another core (found hyrax-physics/1); this program's core is elastic_box", outcome.out)

    def test_the_accepted_core_of_another_class_is_not_replaced_without_accept(self):
        self.blessed()
        for path in self.folder.glob("golden/**/billiard.*"):
            path.unlink()
        shutil.rmtree(self.folder / "golden/long")
        before = self.state_of("golden")
        program.PROGRAM = HYRAX_SIM
        says = "the accepted core is of another class (found elastic_box); this program's is hyrax-physics/1"
        self.assertEqual(self.expect(BAD_INPUT, "check", "--core").out, f"core: not proved equal to the accepted one: {says}\n")
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "by mistake",
                    says="nothing written: golden/core: the accepted core is of another class (found elastic_box); --accept shape replaces it")
        self.assertEqual(self.state_of("golden"), before)
        self.expect(AGREED, "bless", "scenarios", "--reason", "x", "--accept", "shape")
        self.expect(AGREED, "check", "--core")

    def test_a_still_sprite_has_the_same_bits_in_both_and_is_told_apart_all_the_same(self):
        self.write("scenarios/still.json", program.fling(name="still", steps=0))
        self.blessed()
        program.PROGRAM = HYRAX_SIM
        self.expect(BAD_INPUT, "check", "scenarios/still.json")

    def test_what_needs_the_papers_step_is_refused(self):
        self.blessed()
        found = "needs the paper's step, with any constants (found in the core elastic_box: dt * vx)"
        for arguments in (("drift", "scenarios/billiard.json"), ("study", "needs")):
            self.expect(BAD_INPUT, *arguments, says=f"hyrax-sim {arguments[0]}: {found}")
        self.expect(BAD_INPUT, "run", "scenarios/billiard.json", "--drift", says=f"--drift: {found}")
        self.assertEqual(self.names(), ["golden", "scenarios"])
        bounded = program.fling(expect={"in_bounds": True, "truncation_px_max": 1.0})
        path = self.write("scenarios/bounded.json", bounded)
        sentence = f"{path}: /expect/truncation_px_max: {found}"
        self.expect(BAD_INPUT, "run", path, says=sentence)
        self.assertIn(sentence, self.expect(BAD_INPUT, "check", path).out)
        self.expect(BAD_INPUT, "bless", path, "--reason", "x", says=sentence)
        first_screen = self.expect(AGREED).out
        self.assertIn("This program's core is elastic_box, not the paper's step", first_screen)
        self.assertNotIn("\n  drift ", first_screen)
        self.assertIn("\n  sweep ", first_screen)

    def test_run_diff_and_figures_serve_it(self):
        self.blessed()
        text = self.expect(AGREED, "run", "scenarios/billiard.json", "-o", "run.h5", "--figure", "run.svg").out
        self.assertRegex(text, r"\n  core +elastic_box\n")
        self.assertRegex(text, r"\n  exercised +left wall, right wall, top, ground\n")
        self.assertIn("agrees bit for bit with golden/billiard.h5", text)
        self.assertIn("</svg>", (self.folder / "run.svg").read_text(encoding="utf-8"))
        self.assertNotIn("energy", self.expect(AGREED, "diff", "golden/billiard.h5", "run.h5").out)
        self.expect(AGREED, "run", "scenarios/billiard.json", "-o", "75.h5", "--set", "/clock/rate_hz=75")
        text = self.expect(DISAGREED, "diff", "run.h5", "75.h5", "--figure", "diff.svg").out
        self.assertNotIn("energy", text)
        self.expect(AGREED, "shrink", "scenarios/billiard.json", "--fails", "false {}", "-o", "small.json")

    def test_the_pre_commit_hook_passes_and_fails_as_check_does(self):
        config = (EXAMPLE / ".pre-commit-config.yaml").read_text(encoding="utf-8")
        self.assertIn(config, (SOURCE / "tools/own_core/README.md").read_text(encoding="utf-8"))
        entry = re.search("^ +entry: (.*)$", config, re.MULTILINE)[1]
        self.assertEqual(run("sh", "-c", entry, cwd=self.folder).exit_code, 1)  # No build folder: cmake fails.
        self.write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\nproject(none LANGUAGES NONE)\n")
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        shutil.copy(self.program, self.folder / "build")
        self.blessed()
        self.assertEqual(run("sh", "-c", entry, cwd=self.folder).exit_code, AGREED)
        (self.folder / "golden/billiard.txt").unlink()
        self.assertEqual(run("sh", "-c", entry, cwd=self.folder).exit_code, program.GOLDEN_MISSING)
        files = re.search("^ +files: (.*)$", config, re.MULTILINE)[1]
        for path in ("scenarios/long/many-bounces.json", "golden/billiard.h5", "elastic_box.h"):
            self.assertRegex(path, files)
        self.assertNotRegex("README.md", files)

    def test_a_core_that_cannot_be_copied_does_not_compile(self):
        header = self.example / "elastic_box.h"
        self.write("uncopied.h", header.read_text(encoding="utf-8").replace("double m_vx, m_vy;",
                                                                             "double m_vx, m_vy; physics(const physics&);"))
        self.write("CMakeLists.txt", PLAIN.format(arguments="scenarios PHYSICS uncopied.h", language="CXX"))
        self.assertEqual(self.configure(self.folder, "-DCMAKE_BUILD_TYPE=Debug").exit_code, 0)
        outcome = run("cmake", "--build", self.folder / "build")
        self.assertNotEqual(outcome.exit_code, 0)
        self.assertIn("class physics must be trivially copyable", outcome.out + outcome.err)

    def test_one_name_is_one_core(self):
        header = self.example / "elastic_box.h"
        self.expect_refused(f"scenarios PHYSICS {header})\nhyrax_add_scenarios(scenarios PHYSICS {EXAMPLE}/elastic_box.h",
                            "NAME: elastic_box is the core of", language="CXX")


if __name__ == "__main__":
    main()
