"""hyrax_add_scenarios in a MinGW build: its tests are the checks of hyrax-replay.exe, under Wine."""

import json
import math
import os
import shutil

from hyrax_program import FLING, FLINGER, FOLDER, HyraxTest, TIMEOUT_S, WM_CLOSE
from process import run, skip_without, succeed
from program import AGREED, DISAGREED, SOURCE
from wine import Screen, Wine

skip_without("Xvfb")

EXAMPLE = SOURCE / "tests/cli/own_physics"
CTEST_FAILED = 8


class MinGW(HyraxTest):
    """A project that has hyrax as a package of the machine that builds it: scenarios of its own core, and of the shipped one."""

    def setUp(self):
        super().setUp()
        self.package = self.folder / "package"
        environment = {key: value for key, value in os.environ.items() if key != "DESTDIR"}
        succeed("cmake", "--install", os.environ["HYRAX_BUILD"], "--prefix", self.package, env=environment)
        shutil.copytree(EXAMPLE, self.folder, dirs_exist_ok=True)

    def build(self, folder, *options):
        succeed("cmake", "-S", ".", "-B", folder, "-G", "Ninja", f"-DCMAKE_UNITY_BUILD={os.environ['HYRAX_UNITY']}",
                *options, cwd=self.folder)
        succeed("cmake", "--build", folder, cwd=self.folder, timeout=900)

    def replace(self, path, old, new):
        text = (self.folder / path).read_text(encoding="utf-8")
        self.assertIn(old, text)
        self.write(path, text.replace(old, new))

    def ctest(self, exit_code):
        """{test: is passed} under Wine, and all that the tests print."""
        outcome = run("ctest", "--test-dir", "windows", "--verbose", cwd=self.folder, env=self.wine.environment,
                      keeps_children=True, timeout=300, exit_code=exit_code)
        lines = [line.split() for line in outcome.out.splitlines() if " Test " in line and "#" in line and " sec" in line]
        return {line[3]: "Passed" in line for line in lines}, outcome.out

    def test_what_a_program_records_replays_here_and_there(self):
        shutil.copy(SOURCE / "tools/recorder/example/window.cpp", self.folder)
        with open(self.folder / "CMakeLists.txt", "a", encoding="utf-8") as file:
            file.write("if(WIN32)\nadd_executable(window window.cpp)\nhyrax_add_recorder(window PHYSICS elastic_box.h)\nendif()\n")
        self.build("host", f"-DCMAKE_PREFIX_PATH={self.package}")
        self.build("windows", "--toolchain", SOURCE / "tools/cmake/mingw.cmake", f"-Dhyrax_DIR={self.package}/lib/cmake/hyrax")
        screen = Screen(1280, 720)
        self.addCleanup(screen.end)
        for name, wine in (("game", self.wine), ("null", self.wine), ("x11", Wine(FOLDER / "prefix-x11", screen.display))):
            with self.subTest(name):
                recorded = self.folder / "my-fling.json"
                recorded.unlink(missing_ok=True)
                if name == "game":
                    self.assertEqual(wine.run(self.folder / "windows/game.exe", cwd=self.folder).exit_code, 0)
                else:
                    self.wine.end()
                    self.addCleanup(wine.end)
                    with wine.start(self.folder / "windows/window.exe", cwd=self.folder) as process:
                        thrown = wine.run(FLINGER, "find", 120, *FLING, "sleep", 500, "post", WM_CLOSE, 0, 0, timeout=TIMEOUT_S)
                        self.assertEqual((thrown.exit_code, process.wait(TIMEOUT_S).exit_code), (0, 0), thrown.err)
                document = json.loads(recorded.read_text())
                self.assertTrue({"grab", "release"} <= {kind for event in document["events"] for kind in event}, document["events"])
                nudged = self.folder / "nudged.json"
                document["clock"]["dt_s"][-3] = math.nextafter(document["clock"]["dt_s"][-3], math.inf)
                nudged.write_text(json.dumps(document))
                for path, exit_code in ((recorded, AGREED), (nudged, DISAGREED)):
                    here = run(self.folder / "host/elastic_box-sim", "run", path, "-o", "run.h5", cwd=self.folder)
                    there = wine.run(self.folder / "windows/elastic_box-replay.exe", path.name, cwd=self.folder)
                    self.assertEqual((here.exit_code, there.exit_code), (exit_code, exit_code), f"{here} {there}")

    def test_scenarios_agree_until_a_constant_or_a_golden_file_changes(self):
        self.build("host", f"-DCMAKE_PREFIX_PATH={self.package}")
        succeed("host/elastic_box-sim", "bless", "scenarios", "--reason", "first results", cwd=self.folder)
        for path in ("scenarios/flings/first-fling.json", "golden/flings/first-fling.h5", "golden/flings/first-fling.txt"):
            target = self.folder / path.replace("scenarios/", "throws/").replace("golden/flings", "accepted")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(SOURCE / path, target)
        with open(self.folder / "CMakeLists.txt", "a", encoding="utf-8") as file:
            file.write("hyrax_add_scenarios(throws/flings GOLDEN accepted)\n")
        self.build("windows", "--toolchain", SOURCE / "tools/cmake/mingw.cmake", f"-Dhyrax_DIR={self.package}/lib/cmake/hyrax")
        self.assertTrue((self.folder / "windows/elastic_box-replay.exe").read_bytes().startswith(b"MZ"))
        names = ("elastic_box.billiard", "elastic_box.long/many-bounces")
        passed, text = self.ctest(0)
        self.assertEqual(passed, dict.fromkeys((*names, "hyrax.first-fling"), True))
        self.assertEqual(text.count("1 checked: 1 agreed, 0 disagreed"), 3)
        self.replace("elastic_box.h", "RESTITUTION = 1.0", "RESTITUTION = 0.999")
        self.build("windows")
        failed, text = self.ctest(CTEST_FAILED)
        self.assertEqual(failed, {**dict.fromkeys(names, False), "hyrax.first-fling": True})
        self.assertIn("billiard.txt: state hash differs (found ", text)
        self.replace("accepted/first-fling.txt", "state hash: ", "state hash: 0")
        self.assertFalse(self.ctest(CTEST_FAILED)[0]["hyrax.first-fling"])
