"""Cores of the paper's shape with constants of their own, and cores of other shapes, in a project that uses the package."""

import json
import re
import sys
import unittest.mock

import h5py
import numpy as np

import program
from installed_package import PLAIN, InstalledPackage
from process import succeed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, NOT_STRICT, PROGRAM, SOURCE

sys.path.insert(0, str(SOURCE / "tests/oracle"))
import replay  # noqa: E402 pylint: disable=wrong-import-position

HARD = str(SOURCE / "scenarios/hard")

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


def moon_rows(steps, rate_hz, state, bounds):
    """The second program with the constants of MOON: x, y, vx, vy of each row."""
    constants = {next(each for each in vars(replay) if each.startswith(name)): value for name, (_, value) in MOON.items()}
    sprite, rows = replay.Sprite(*state), [state]
    with unittest.mock.patch.multiple(replay, **constants):
        for _ in range(steps):
            sprite.update(1.0 / rate_hz, *bounds)
            rows.append((sprite.x, sprite.y, sprite.vx, sprite.vy))
    return np.array(rows)


class Shapes(InstalledPackage):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        project = cls.root / "shapes"
        project.mkdir()
        headers = {"moon": moon_header()}
        for name, (old, new, _) in SHAPES.items():
            headers[name] = SHIPPED.replace(old, new)
            assert headers[name] != SHIPPED
        headers["single"] = SHIPPED.replace("double", "float")
        headers["leak"] = SHIPPED.replace("m_x > rightBound)", "m_x > rightBound + 40.0)")
        headers["leak"] = headers["leak"].replace(WALLS, "    if (objWidth == 13) throw std::out_of_range(\"13 px\");\n" + WALLS)
        headers["leak"] = headers["leak"].replace("#pragma once", "#pragma once\n#include <stdexcept>", 1)
        headers["spin"] = headers["spin"].replace("  double m_vx, m_vy;\n", "  double m_vx, m_vy;\n  double m_spin = 3.0;\n")
        headers["round"] = SHIPPED.replace(WALLS, "    if (m_y > 700.0) std::fesetround(FE_DOWNWARD);\n" + WALLS)
        headers["round"] = headers["round"].replace("#pragma once", "#pragma once\n#include <cfenv>", 1)
        for name, header in headers.items():
            (project / f"{name}.h").write_text(header, encoding="utf-8")
        (project / "scenarios").mkdir()
        (project / "scenarios/fling.json").write_text(json.dumps(cls.fling()), encoding="utf-8")
        calls = ")\nhyrax_add_scenarios(".join(f"scenarios PHYSICS {name}.h" for name in headers)
        (project / "CMakeLists.txt").write_text(PLAIN.format(arguments=calls, language="CXX"), encoding="utf-8")
        assert cls.configure(project).exit_code == 0
        succeed("cmake", "--build", project / "build")
        cls.build = project / "build"

    @staticmethod
    def fling():
        """One that meets all walls."""
        return program.fling(name="fling", window={"width_px": 1920, "height_px": 1080}, steps=600,
                             sprite={"width_px": 128, "height_px": 128},
                             start={"x_px": 350.25, "y_px": 251, "vx_px_per_s": 1401.5, "vy_px_per_s": -903.25})

    def setUp(self):
        super().setUp()
        self.write("fling.json", self.fling())
        self.write("sweep.json", {"format": "hyrax-sweep/1", "base": "fling.json", "members": 300, "seed": 3, "vary": {
            "/start/vx_px_per_s": {"uniform": [-2000, 2000]}, "/clock/rate_hz": {"choice": [60, 144]}}})

    def use(self, name):
        self.program = self.build / f"{name}-sim"

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
        rows = moon_rows(600, 60, (350.25, 251.0, 1401.5, -903.25), (1792.0, 952.0))
        self.assertIn(f"reference and energy ({self.program} drift)", self.expect(AGREED, "run", "fling.json").out)
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
        self.program = PROGRAM
        for path in ("run.h5", "seldom.h5"):
            outcome = self.expect(AGREED, "drift", path, "--json")
            self.assertEqual(outcome.json["runs"][0]["worst"], drift["worst"], path)
        self.assertNotIn("STATE HASH DIFFERS", self.expect(AGREED, "drift", "seldom.h5").out)
        self.use("moon")
        # The control: with other constants in the file, its rows are not those of the laws.
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file.attrs["constants"] = np.array([1200.0] + constants[1:])
        self.assertGreater(self.expect(DISAGREED, "drift", "run.h5", "--json").json["runs"][0]["worst"]["implementation_px"], 1.0)
        computed, steps = self.expect_sweep_as_runs()
        self.assertLess(computed, steps)  # The kernels leave steps at rest out.
        self.assertIn("all invariants hold", self.expect(AGREED, "fuzz", "--runs", "300").out)
        self.assertIn("404 of 404 flings have settled", self.expect(AGREED, "study", "frame-rate", "--quick", "--no-figures", "--gate").out)
        self.expect(AGREED, "study", "needs", "fling.json", "--quick", "--no-figures", "--within", "1px")
        self.assertIn("the paper's step with constants of its own", self.expect(AGREED).out)
        self.expect(AGREED, "bless", "fling.json", "--golden", "golden", "--reason", "x")
        self.expect(AGREED, "check", "fling.json", "--golden", "golden")

    def test_parameters_go_by_the_cores_own_names_and_give_the_bits_of_a_core_that_has_them(self):
        self.write("as-moon.json", {**self.fling(), "parameters": {name: value for name, (_, value) in MOON.items()}})
        as_moon = self.expect(AGREED, "run", "as-moon.json", "--json").json["runs"][0]
        paper = self.expect(AGREED, "run", "fling.json", "-o", "paper.h5", "--json").json["runs"][0]
        drift = self.expect(AGREED, "drift", "as-moon.json", "--json").json["runs"][0]
        self.write("as-paper.json", {**self.fling(), "parameters": {
            own: next(value for each, value in vars(replay).items() if each.startswith(name)) for name, (own, _) in MOON.items()}})
        self.write("floor.json", {**self.fling(), "parameters": {"FLOOR": 0.7}})
        self.use("moon")
        moon = self.expect(AGREED, "run", "fling.json", "--json").json["runs"][0]
        self.assertEqual(as_moon["state_hash"], moon["state_hash"])
        self.assertNotEqual(paper["state_hash"], moon["state_hash"])
        self.assertEqual(drift["worst"], self.expect(AGREED, "drift", "fling.json", "--json").json["runs"][0]["worst"])
        self.assertEqual(self.expect(AGREED, "run", "as-paper.json", "--json").json["runs"][0]["state_hash"], paper["state_hash"])
        self.assertIn("with FLOOR 0.7, not the core's own 0.65\n", self.expect(AGREED, "run", "floor.json").out)
        # All are named at once, by validate, too.
        for command in ("run", "validate"):
            outcome = self.expect(BAD_INPUT, command, "as-moon.json")
            self.assertEqual(outcome.err.count(": unknown constant of the core (found "), len(MOON))
            self.assertIn("/parameters/AIR_DRAG: unknown constant of the core (found AIR_DRAG); allowed: PULL, AIR, ", outcome.err)
        self.write("own.json", {**self.fling(), "parameters": {"FLOOR": 0.65}})
        self.assertNotIn("not the core's own", self.expect(AGREED, "run", "own.json").out)
        self.use("spin")
        for command in ("run", "check", "drift", "validate"):
            self.expect(BAD_INPUT, command, "floor.json")
        self.expect(BAD_INPUT, "run", "floor.json", says="floor.json: /parameters: needs a core of the same shape")

    def test_the_accepted_core_is_played_with_the_parameters_of_a_scenario(self):
        for name, parameters in (("plain", {}), ("weaker", {"PULL": 700}), ("dull", {"BOUNCE": 0.5, "PULL": 700})):
            self.write(f"scenarios/{name}.json", {**self.fling(), "name": name, "parameters": parameters})
        self.use("moon")
        self.expect(AGREED, "bless", "scenarios", "--reason", "x")
        self.write("moon.h", moon_header().replace("BOUNCE = 0.75", "BOUNCE = 0.8"))
        self.write("CMakeLists.txt", PLAIN.format(arguments="scenarios PHYSICS moon.h", language="CXX"))
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        succeed("cmake", "--build", self.folder / "build")
        self.program = self.folder / "build/moon-sim"
        document = self.expect(DISAGREED, "check", "--json", "--flings", "0").json
        (group,) = document["groups"]
        self.assertEqual((group["operation"], group["detail"]), ("core", "BOUNCE 0.75 -> 0.8"))
        # Its parameters leave nothing of what changed.
        self.assertEqual(group["scenarios"], ["scenarios/plain.json", "scenarios/weaker.json"])
        self.assertEqual({each["scenario"]: each["status"] for each in document["results"]}["scenarios/dull.json"], "agreed")

    def test_another_shape_is_refused_by_its_first_expression_and_has_the_rest(self):
        for name, (_, _, expression) in SHAPES.items():
            with self.subTest(name):
                self.use(name)
                for arguments in (("drift", "fling.json"), ("study", "needs"), ("run", "fling.json", "--drift")):
                    outcome = self.expect(BAD_INPUT, *arguments, says="needs the paper's step, with any constants")
                    self.assertRegex(outcome.err, rf"\(found in the core {name}: .*{re.escape(expression)}\)\n")
                rates = self.expect(AGREED, "study", "frame-rate", "--quick").out
                self.assertIn("\nFrom 2000 Hz, 60 Hz is up to ", rates)
                self.assertIn("the fling does not converge: from 125 to 250 Hz it changes by up to ", rates)  # Drag acts once a frame.
                self.assertIn("; no value loses half its digits.\n", rates)
                if name == "spin":  # It has a further member.
                    hard = self.expect(AGREED, "study", "hard-cases", HARD, "--quick", "--no-figures", "--json").json
                    self.assertEqual({each["verdict"] for case in hard["cases"] for invariant, each in case["invariants"].items() if invariant != "expectations"},
                                     {"held"})  # What they expect is of the paper's core.
                computed, steps = self.expect_sweep_as_runs()
                self.assertGreater(computed, 0)
                self.assertLessEqual(computed, steps)
                self.assertIn("all invariants hold", self.expect(AGREED, "fuzz", "--runs", "100").out)
                golden = f"golden-{name}"
                self.expect(AGREED, "bless", "fling.json", "--golden", golden, "--reason", "x")
                self.expect(AGREED, "check", "fling.json", "--golden", golden)
                self.expect(AGREED, "run", "fling.json", "-o", f"{name}.h5", "--figure", f"{name}.svg")
                self.assertNotIn("energy", self.expect(AGREED, "diff", f"{golden}/fling.h5", f"{name}.h5", "--figure", "diff.svg").out)
                self.expect_page(f"{name}.h5")
                with h5py.File(self.folder / f"{name}.h5") as file:
                    self.assertNotIn("constants", file.attrs)
                self.write("wrong.json", program.fling(expect={"final_x_px": [-2, -1]}))
                self.assertIn("kept: final_x_px is above", self.expect(AGREED, "shrink", "wrong.json", "-o", f"small-{name}.json").out)

    def test_a_core_of_float_is_told_whether_float_matters(self):
        self.use("single")
        outcome = self.expect(AGREED, "study", "frame-rate", "--quick", "--json", "--report", "page.html")
        self.assertRegex(outcome.json["answer"], r"^From the run at its own clock, 144 Hz is up to [\d,.]+ px away, 240 Hz up to [\d,.]+ px\.$")
        self.assertEqual([(row["rate_hz"], row["off_px"]) for row in outcome.json["rates"]][-1], (2000, 0))
        self.assertEqual([row["rate_hz"] for row in outcome.json["roundings"]], [24, 60, 144, 240])
        self.assertIn("Does float matter here? No: that is less than half a pixel.", (self.folder / "page.html").read_text(encoding="utf-8"))
        self.expect(BAD_INPUT, "study", "needs", says="needs the paper's step")
        self.use("round")  # It cannot be traced, and does not calculate as it should.
        self.expect(NOT_STRICT, "study", "frame-rate", "--quick", "--no-figures")

    def test_control_fuzz_finds_a_core_that_leaves_the_window(self):
        self.use("leak")
        outcome = self.expect(DISAGREED, "fuzz", "--runs", "200")
        self.assertIn("breaks an invariant: in-bounds", outcome.out)
        self.assertIn(f"\n  {self.program} study hard-cases ", outcome.out)
        self.expect(DISAGREED, "study", "hard-cases", HARD, "--quick", "--no-figures", "--gate", says="in-bounds is broken by ")

    def test_fuzz_writes_the_scenario_in_which_a_core_throws(self):
        self.use("leak")
        rules = [word for rule in ("in-bounds", "listing", "mirror", "step-energy") for word in ("--without", rule)]
        failure, = self.expect(DISAGREED, "fuzz", "--runs", "3000", "--json", *rules).json["failures"]
        self.assertEqual((failure["rule"], failure["steps"], failure["events"], failure["fails_again"]), ("throws", 1, 0, True))
        self.assertRegex(failure["found"], r"^the core throws in the step that makes row \d+: 13 px$")
        self.expect(DISAGREED, "run", failure["scenario"], says="the core throws in the step that makes row 1: 13 px")

    def test_a_core_that_changes_how_the_processor_calculates_is_not_played(self):
        self.expect(AGREED, "run", "fling.json", "-o", "run.csv")
        heights = [float(line.split(",")[4]) for line in (self.folder / "run.csv").read_text(encoding="utf-8").splitlines()[1:]]
        self.use("round")
        row = next(row for row, height in enumerate(heights) if height > 700.0) + 1
        self.expect(NOT_STRICT, "run", "fling.json", "-o", "run.h5", says=f"in the step that makes row {row};")
        self.assertIn(f"in the step that makes row {row};", self.expect(NOT_STRICT, "check", "fling.json", "--golden", "golden").out)
        self.expect(NOT_STRICT, "sweep", "sweep.json")
        self.assertIn("the step calls fesetround", self.expect(AGREED, "info").out)
