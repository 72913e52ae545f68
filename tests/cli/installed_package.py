"""The package of `cmake --install`, and projects that use nothing else of hyrax.

HYRAX_BUILD is the folder of a build; HYRAX_CXX, HYRAX_CXX_FLAGS and HYRAX_GENERATOR are its own.
"""

import functools
import json
import math
import os
import pathlib
import shutil
import tempfile

import program
from process import run, succeed
from program import AGREED, DISAGREED, ProgramTest

PLAIN = """cmake_minimum_required(VERSION 3.25)
project(plain LANGUAGES {language})
find_package(hyrax 0.2 REQUIRED)
hyrax_add_scenarios({arguments})
"""


_FOLDER = tempfile.TemporaryDirectory(prefix="hyrax-test-")


@functools.cache
def package():
    """The package, installed once for all tests of a process, and moved, into a folder of a difficult name: it must not remember where it was made."""
    first = pathlib.Path(_FOLDER.name) / "first"
    environment = {key: value for key, value in os.environ.items() if key != "DESTDIR"}
    succeed("cmake", "--install", os.environ["HYRAX_BUILD"], "--prefix", first, env=environment)
    return first.rename(first.with_name("package (x86) [2]"))


class InstalledPackage(ProgramTest):
    """A folder for projects, which use the package."""

    @classmethod
    def setUpClass(cls):
        cls.package = package()
        cls.root = pathlib.Path(tempfile.mkdtemp(dir=_FOLDER.name))

    @classmethod
    def configure(cls, source, *options):
        """Runs cmake in SOURCE/build."""
        return run("cmake", "-S", source, "-B", source / "build", "-G", os.environ["HYRAX_GENERATOR"],
                   f"-DCMAKE_PREFIX_PATH={cls.package}", f"-DCMAKE_CXX_COMPILER={os.environ['HYRAX_CXX']}",
                   f"-DCMAKE_CXX_FLAGS={os.environ['HYRAX_CXX_FLAGS']}", *options)

    def ctest(self, source, exit_code):
        """Runs the project's tests, which must end with this exit code; returns {name: is passed}, without the accepted core."""
        outcome = run("ctest", "--test-dir", source / "build", "--output-on-failure", exit_code=exit_code)
        lines = [line.split() for line in outcome.out.splitlines() if " Test " in line and "#" in line]
        return {line[3]: "Passed" in line for line in lines if not line[3].endswith(".accepted_core")}

    def expect_recording_replays(self, game):
        """What a program records replays to its hash; with the next larger dt of a frame it does not."""
        succeed(game, cwd=self.folder)
        self.expect(AGREED, "run", "my-fling.json", "-o", "recorded.h5")
        document = json.loads((self.folder / "my-fling.json").read_text(encoding="utf-8"))
        document["clock"]["dt_s"][45] = math.nextafter(document["clock"]["dt_s"][45], math.inf)
        self.write("nudged.json", document)
        self.expect(DISAGREED, "run", "nudged.json", "-o", "nudged.h5")
        return document

    def expect_refused(self, arguments, says, language="NONE"):
        """A project that cannot be configured."""
        source = self.folder / "refused"
        shutil.rmtree(source, ignore_errors=True)
        self.write("refused/scenarios/fling.json", program.fling())
        self.write("refused/CMakeLists.txt", PLAIN.format(arguments=arguments, language=language))
        outcome = self.configure(source)
        self.assertNotEqual(outcome.exit_code, 0, outcome)
        self.assertIn(says, " ".join(outcome.err.split()))
