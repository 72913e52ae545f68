"""A project with a class physics of its own, and one without, which use hyrax as an installed package only."""

import os
import re
import shutil
import time

import h5py
import numpy as np

from installed_package import PLAIN, InstalledPackage
from process import run, succeed
from program import AGREED, BAD_INPUT, CANNOT_ACCESS, DISAGREED, GOLDEN_MISSING, PROGRAM, SOURCE, fling

EXAMPLE = SOURCE / "tests/cli/own_physics"
CTEST_FAILED = 8

FLING = "scenarios/flings/first-fling.json"


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


class WithoutPhysics(InstalledPackage):
    """Scenarios of the shipped core."""

    def setUp(self):
        super().setUp()
        for name in ("flings/first-fling", "flings/corner-fling"):
            for path in (f"scenarios/{name}.json", f"golden/{name}.h5", f"golden/{name}.txt"):
                target = self.folder / path.replace("golden/", "accepted/")
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(SOURCE / path, target)
        shutil.copytree(SOURCE / "golden/core", self.folder / "accepted/core")
        self.write("CMakeLists.txt", PLAIN.format(arguments="scenarios/flings GOLDEN accepted", language="NONE"))

    def test_each_file_is_a_test_a_new_file_a_new_one_an_edited_and_a_deleted_one_turn_red(self):
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        tests = {"hyrax.first-fling": True, "hyrax.corner-fling": True, "hyrax.unreferenced_golden": True}
        self.assertEqual(self.ctest(self.folder, 0), tests)
        scenario = (self.folder / FLING).read_text(encoding="utf-8")
        self.write("scenarios/flings/new/other-file.json", scenario)
        succeed("cmake", "--build", self.folder / "build")
        tests["hyrax.new/other-file"] = False  # It has no golden file yet.
        self.assertEqual(self.ctest(self.folder, CTEST_FAILED), tests)
        self.write(FLING, scenario.replace('"x_px": 60', '"x_px": 61'))
        self.assertEqual(self.ctest(self.folder, CTEST_FAILED), {**tests, "hyrax.first-fling": False})
        (self.folder / FLING).unlink()
        succeed("cmake", "--build", self.folder / "build")
        del tests["hyrax.first-fling"]
        self.assertEqual(self.ctest(self.folder, CTEST_FAILED), {**tests, "hyrax.unreferenced_golden": False})

    def test_names_are_those_of_files_and_each_library_has_two_tests_more(self):
        project = "in [brackets], a*"
        for path in ("a/scenarios/LOUD.JSON", "a/scenarios/fling.json", "a/scenarios/deep/fling.json", "b/scenarios/fling.json", "c/scenarios/fling.json"):
            self.write(f"{project}/{path}", fling(name="one"))
        self.write(f"{project}/a/scenarios/scenario.schema.json", self.expect(AGREED, "schema").out)
        libraries = ")\nhyrax_add_scenarios(".join(f"{name}/scenarios" for name in "abc")
        self.write(f"{project}/CMakeLists.txt", PLAIN.format(arguments=libraries, language="NONE"))
        self.assertEqual(self.configure(self.folder / project).exit_code, 0)
        listed = run("ctest", "--test-dir", self.folder / project / "build", "-N").out
        self.assertEqual(sorted(re.findall(r"Test +#\d+: (\S+)", listed)), sorted(
            f"hyrax.{name}" for name in ("LOUD.JSON", "deep/fling", *(f"{name}{library}" for library in ("", "_of_scenarios", "_of_c/scenarios")
                                                                      for name in ("fling", "accepted_core", "unreferenced_golden")))))
        self.assertIn("LOUD.JSON", self.expect(BAD_INPUT, "check", f"{project}/a/scenarios/LOUD.JSON").out)

    def test_a_build_whose_programs_are_on_the_path_is_no_package(self):
        path = f"{os.environ['HYRAX_BUILD']}/bin{os.pathsep}{os.environ['PATH']}"
        run("cmake", "-S", self.folder, "-B", self.folder / "build", env={**os.environ, "PATH": path})
        cache = (self.folder / "build/CMakeCache.txt").read_text(encoding="utf-8")
        self.assertNotIn(f"hyrax_DIR:PATH={os.environ['HYRAX_BUILD']}", cache)

    def test_wrong_arguments_are_refused(self):
        self.expect_refused("nowhere", "no scenario file, *.json, in")
        self.expect_refused("scenarios SPEED 3", "unknown or without a value: SPEED;3; allowed: DIR [GOLDEN DIR]")
        self.expect_refused("scenarios GOLDEN", "unknown or without a value: GOLDEN; allowed:")
        self.expect_refused("scenarios NAME box", "NAME needs PHYSICS")
        self.expect_refused(".)\nfind_package(none REQUIRED", "no folder named scenarios in")  # A warning.
        self.expect_refused("scenarios PHYSICS none.h", "PHYSICS: no such file")
        self.expect_refused("scenarios PHYSICS CMakeLists.txt NAME a/b", "NAME: must be of letters, digits")


class CheckHeader(InstalledPackage):
    """tools/check of an installed hyrax."""

    def test_a_header_is_judged_in_place_of_the_shipped_one(self):
        for path in ("scenarios/flings/first-fling.json", "golden/flings/first-fling.h5", "golden/flings/first-fling.txt", "golden/core"):
            (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if path == "golden/core" else shutil.copy)(SOURCE / path, self.folder / path)
        shipped = (SOURCE / "sim/physics/physics.h").read_text(encoding="utf-8")
        self.write("my_physics.h", shipped.replace("RESTITUTION = 0.6;", "RESTITUTION = 0.62;"))
        check = (self.package / "share/hyrax/source/tools/check", "my_physics.h")
        options = {"cwd": self.folder, "env": {**os.environ, "CXX": os.environ["HYRAX_CXX"], "XDG_CACHE_HOME": str(self.folder / "cache")}}
        core, = run(*check, "--json", "--flings", "50", exit_code=DISAGREED, **options).json["cores"]
        self.assertEqual((core["status"], core["changes"][0]["detail"], core["beyond"]["flings"]), ("changed", "RESTITUTION 0.6 -> 0.62", 50))
        self.assertIn(f"to accept it    {self.folder}/cache/hyrax-sim/check/my_physics.h-", run(*check, **options).out)
        self.write("my_physics.h", shipped)
        self.assertEqual(run(*check, "--core", **options).out, "core: the accepted one\n")
        self.assertEqual(len(list((self.folder / "cache/hyrax-sim/check").iterdir())), 1)
        self.write("my_physics.h", shipped + "nonsense")
        self.assertIn("my_physics.h could not be built; see the output above.", run(*check, exit_code=CANNOT_ACCESS, **options).err)
        self.assertIn("tools/check: an installed hyrax has no sources to build; name a HEADER", run(check[0], **options).err)


class OwnPhysics(InstalledPackage):
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
        cls.program, cls.game = (shutil.copy(cls.example / f"build/{name}", cls.root) for name in ("elastic_box-sim", "game"))

    def setUp(self):
        super().setUp()
        shutil.copytree(self.example / "scenarios", self.folder / "scenarios")

    def test_the_project_is_red_until_blessed_then_green_then_red_for_another_constant(self):
        project = self.example  # The other tests use copies of its programs.
        names = ("elastic_box.billiard", "elastic_box.long/many-bounces")
        unreferenced = {"elastic_box.unreferenced_golden": True}
        self.assertEqual(self.ctest(project, CTEST_FAILED), dict.fromkeys(names, False) | unreferenced)
        succeed(project / "build/elastic_box-sim", "bless", project / "scenarios", "--reason", "first results")
        self.assertEqual(self.ctest(project, 0), dict.fromkeys(names, True) | unreferenced)
        header = project / "elastic_box.h"
        header.write_text(header.read_text(encoding="utf-8").replace("RESTITUTION = 1.0", "RESTITUTION = 0.999"),
                          encoding="utf-8")
        succeed("cmake", "--build", project / "build")
        self.assertEqual(self.ctest(project, CTEST_FAILED), dict.fromkeys(names, False) | unreferenced)
        outcome = run(project / "build/elastic_box-sim", "check", "--json", cwd=project, exit_code=DISAGREED)
        long_run = outcome.json["results"][1]  # Its golden file has blocks and no rows: row checks find the row.
        self.assertEqual((long_run["class"], long_run["first_divergence"]["step"]), ("contacts", 28))
        self.assertEqual([(group["operation"], group["detail"]) for group in outcome.json["groups"]],
                         [("core", "RESTITUTION 1 -> 0.999")])
        text = run(project / "build/elastic_box-sim", "check", cwd=project).out
        self.assertIn("core: changed\n", text)
        self.assertIn(f"to accept it    {project}/build/elastic_box-sim bless scenarios", text)

    def test_rows_are_those_of_the_core_bit_for_bit(self):
        scenario = fling(window={"width_px": 800, "height_px": 600}, steps=3000,
                                 sprite={"width_px": 100, "height_px": 100},
                                 start={"x_px": 350.25, "y_px": 251, "vx_px_per_s": 401.5, "vy_px_per_s": -303.25})
        self.expect(AGREED, "run", self.write("fling.json", scenario), "-o", "run.h5", "--no-skip")
        rows = elastic_rows(3000, 60, (350.25, 251.0, 401.5, -303.25), (700.0, 500.0))
        with h5py.File(self.folder / "run.h5") as file:
            stored = np.column_stack([file[f"trajectory/{name}"] for name in ("x", "y", "vx", "vy")])
            self.assertEqual(stored.tobytes(), rows.tobytes())

    def test_golden_files_of_another_core_are_refused_by_both(self):
        self.write("scenarios/still.json", fling(name="still", steps=0))  # It has the same bits in both.
        self.bless("scenarios")
        self.assertIn("\nphysics: elastic_box\n", (self.folder / "golden/billiard.txt").read_text(encoding="utf-8"))
        before = self.state_of("golden")
        self.program = PROGRAM
        outcome = self.expect(BAD_INPUT, "check")
        self.assertIn("golden/billiard.h5: attribute physics: is of another core (found elastic_box); this program's "
                      "core is hyrax-physics/1", outcome.out)
        self.expect(BAD_INPUT, "check", "scenarios/still.json")
        self.expect(DISAGREED, "bless", "scenarios", "--reason", "by mistake")
        self.assertEqual(self.state_of("golden"), before)
        self.program = OwnPhysics.program
        outcome = self.expect(BAD_INPUT, "check", SOURCE / FLING)
        self.assertIn("is of another core (found hyrax-physics/1); this program's core is elastic_box", outcome.out)

    def test_what_needs_the_papers_step_is_refused_in_the_programs_own_name(self):
        self.expect(BAD_INPUT, "drift", says="elastic_box-sim drift: needs the paper's step")
        self.expect(BAD_INPUT, "run", "--drifts", says="see `elastic_box-sim run --help`")
        path = self.write("scenarios/bounded.json", fling(expect={"truncation_px_max": 1.0}))
        self.expect(BAD_INPUT, "run", path, says=f"{path}: /expect/truncation_px_max: needs the paper's step, with any constants")
        first_screen = self.expect(AGREED).out
        self.assertIn("This program's core is elastic_box, not the paper's step", first_screen)
        self.assertNotIn("\n  drift ", first_screen)
        self.assertIn("\n  sweep ", first_screen)
        self.assertRegex(self.expect(AGREED, "info").out, r"\nphysics +elastic_box\n")

    def test_the_pre_commit_hook_passes_and_fails_as_check_does(self):
        config = (EXAMPLE / ".pre-commit-config.yaml").read_text(encoding="utf-8")
        self.assertIn(config, (SOURCE / "tools/own_core/README.md").read_text(encoding="utf-8"))
        entry = re.search("^ +entry: (.*)$", config, re.MULTILINE)[1]
        self.assertEqual(run("sh", "-c", entry, cwd=self.folder).exit_code, 1)  # No build folder: cmake fails.
        self.write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\nproject(none LANGUAGES NONE)\n")
        self.assertEqual(self.configure(self.folder).exit_code, 0)
        shutil.copy(self.program, self.folder / "build")
        self.bless("scenarios")
        self.assertEqual(run("sh", "-c", entry, cwd=self.folder).exit_code, AGREED)
        (self.folder / "golden/billiard.txt").unlink()
        self.assertEqual(run("sh", "-c", entry, cwd=self.folder).exit_code, GOLDEN_MISSING)
        files = re.search("^ +files: (.*)$", config, re.MULTILINE)[1]
        for path in ("scenarios/long/many-bounces.json", "golden/billiard.h5", "elastic_box.h"):
            self.assertRegex(path, files)
        self.assertNotRegex("README.md", files)

    def built(self, header, *commands):
        """What building a core as box.h ends with, in a project with these commands of CMake."""
        self.write("box.h", header)
        self.write("CMakeLists.txt", PLAIN.format(arguments="scenarios PHYSICS box.h", language=")\n".join(("CXX", *commands))))
        self.assertEqual(self.configure(self.folder, "-DCMAKE_BUILD_TYPE=Debug").exit_code, 0)
        return run("cmake", "--build", self.folder / "build")

    def test_a_core_that_would_go_wrong_does_not_compile(self):
        header = (EXAMPLE / "elastic_box.h").read_text(encoding="utf-8")
        for edited, command, says in (
                (header.replace("double m_vx, m_vy;", "double m_vx, m_vy; physics(const physics&);"), (), "class physics must be trivially copyable"),
                (header.replace("resetVelocity", "halt"), (), "hyrax: class physics has no void resetVelocity()"),
                ("struct hyrax_core {};", (), "hyrax: the header has no global class physics"),
                (header, ("add_compile_options(-ffast-math",), "-ffast-math changes the bits of the core"),
                (header, ("add_compile_definitions(_M_FP_FAST",), "-ffast-math changes the bits of the core"),  # MSVC's /fp:fast.
                (header, ("add_compile_definitions(_GLIBCXX_DEBUG",), "-D_GLIBCXX_DEBUG gives containers another layout")):
            outcome = self.built(edited, *command)
            self.assertNotEqual(outcome.exit_code, 0)
            self.assertIn(says, outcome.out + outcome.err)

    def test_a_core_of_float_builds_without_warnings_and_files_have_its_flags(self):
        header = (EXAMPLE / "elastic_box.h").read_text(encoding="utf-8")
        outcome = self.built(header.replace("double", "float"), "add_compile_options([[-DTEXT=\"a b\"]] -Wall -Wextra -Wpedantic -Werror")
        self.assertEqual(outcome.exit_code, 0, outcome)
        self.program = self.folder / "build/box-sim"
        self.expect(AGREED, "run", "scenarios/billiard.json", "-o", "run.h5")
        with h5py.File(self.folder / "run.h5") as file:
            self.assertRegex(file["provenance"].attrs["flags"], "-Werror.* -ffp-contract=off")

    def test_what_a_program_records_replays(self):
        document = self.expect_recording_replays(self.game)
        self.assertEqual([next(key for key in event if key != "step") for event in document["events"]],
                         ["fling", "grab", "place", "fling", *["place"] * 9, "release", "resize"])
        # With another core it has another hash.
        self.write("box.h", (EXAMPLE / "elastic_box.h").read_text(encoding="utf-8").replace("RESTITUTION = 1.0", "RESTITUTION = 0.999"))
        self.assertEqual(self.built((self.folder / "box.h").read_text(encoding="utf-8")).exit_code, 0)
        self.program = self.folder / "build/box-sim"
        self.expect(DISAGREED, "run", "my-fling.json", "-o", "other.h5")

    def test_one_name_is_one_core(self):
        header = self.example / "elastic_box.h"
        self.expect_refused(f"scenarios PHYSICS {header})\nhyrax_add_scenarios(scenarios PHYSICS {EXAMPLE}/elastic_box.h",
                            "NAME: elastic_box is the core of", language="CXX")
