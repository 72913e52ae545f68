"""mutation.py distinguishes all fates, in a project of one source, two programs and two tests.

Its unit test checks the sign of -5 and of 5 only, so a change that matters only at 0 survives.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).with_name("mutation.py")
SOURCES = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES CXX)
enable_testing()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS sum_test)
add_library(compare STATIC sim/compare/sign.cpp)
add_executable(hyrax-sim main.cpp)
set_target_properties(hyrax-sim PROPERTIES RUNTIME_OUTPUT_DIRECTORY bin)
target_link_libraries(hyrax-sim PRIVATE compare)
add_test(NAME cli.sum COMMAND sh ${PROJECT_SOURCE_DIR}/sum_test ${PROJECT_BINARY_DIR}/bin)
add_subdirectory(tests/unit/sim/compare)
set_tests_properties(cli.sum PROPERTIES LABELS everyday)
""",
    "sim/compare/sign.cpp": """static_assert(sizeof(int) > 1);

int sign(int number) {
  if (number < 0) return -1;
  return 1;
}

int sum_to(int last) {
  int sum = 0;
  for (long long each = 1; each <= last; ++each) sum += each;
  return sum;
}
""",
    "sum_test": """: > "${0%/*}/left"
test -z "$HYRAX_TEST_IS_RED" && test "$("$1/hyrax-sim")" = 6
""",
    "main.cpp": "#include <cstdio>\nint sum_to(int last);\nint main() { std::printf(\"%d\", sum_to(3)); }\n",
    "tests/unit/sim/compare/CMakeLists.txt": """add_executable(compare_test sign_test.cpp)
target_link_libraries(compare_test PRIVATE compare)
add_test(NAME unit.compare COMMAND compare_test)
set_tests_properties(unit.compare PROPERTIES LABELS everyday TIMEOUT 300)
""",
    "tests/unit/sim/compare/sign_test.cpp":
        "int sign(int number);\nint main() { return sign(-5) == -1 && sign(5) == 1 ? 0 : 1; }\n",
}
SURVIVOR = "sign: if (number < 0) return -1; -> if (number <= 0) return -1;"


def programs_running_in(folder):
    """The programs below a folder that processes run, deleted ones too."""
    running = []
    for link in pathlib.Path("/proc").glob("[0-9]*/exe"):
        try:
            running.append(os.readlink(link))
        except OSError:
            continue  # It has ended, or is another user's.
    return [path for path in running if path.startswith(f"{folder}/")]


class Fates(unittest.TestCase):
    """Each test is a run of the tool."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="hyrax-test-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.source = cls.folder / "small"
        for name, text in SOURCES.items():
            path = cls.source / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        for command in (["cmake", "-S", cls.source, "-B", cls.source / "build/some", "-G", "Ninja"],
                        ["ninja", "-C", cls.source / "build/some"]):
            subprocess.run(command, check=True, capture_output=True)

    def run_tool(self, *options, reasons=(), **environment):
        """Exit code and standard output."""
        path = self.folder / "reasons.json"
        path.write_text(json.dumps(reasons), encoding="utf-8")
        temporary = self.folder / "tmp"
        temporary.mkdir(exist_ok=True)
        outside = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}  # Those of a user.
        tool = subprocess.run([sys.executable, TOOL, "--build", self.source / "build/some", "--source", self.source,
                               "--reasons", path, "--test-seconds", "2", *options], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**outside, **environment, "TMPDIR": str(temporary)})
        self.assertEqual(list(temporary.iterdir()), [], "it left something behind")
        self.assertEqual(programs_running_in(self.folder), [])
        self.assertFalse((self.source / "left").exists(), "a test wrote to the project, not to the copy")
        return tool.returncode, tool.stdout

    def fates(self, only, *options):
        """{change: (fate, by)} of the mutants whose name matches."""
        _, said = self.run_tool("--only", only, *options)
        rows = [[cell.strip() for cell in line.split(" | ")] for line in said.splitlines() if "sign.cpp:" in line]
        return {cells[1].strip("`"): (cells[2], cells[3]) for cells in rows if len(cells) == 5}

    def test_what_a_test_notices_is_caught_by_it_the_nearest_first(self):
        self.assertEqual(self.fates("number > 0|sum = 1"), {
            "sign: if (number < 0) return -1; -> if (number > 0) return -1;": ("caught", "unit.compare Failed"),
            "sum_to: int sum = 0; -> int sum = 1;": ("caught", "cli.sum Failed")})

    def test_what_never_ends_does_not_compile_or_makes_the_same_code(self):
        for only, fate in (("last; --each", ("caught", "cli.sum Timeout")), ("sizeof.int. < 1", ("refused", "")),
                           ("sizeof.int. >= 1", ("equivalent", "same code"))):
            self.assertEqual(list(self.fates(only).values()), [fate], only)

    def test_a_survivor_is_named_and_fails_the_run_unless_a_reason_makes_it_equivalent(self):
        exit_code, said = self.run_tool("--only", "number <= 0")
        self.assertEqual(exit_code, 1, said)
        self.assertIn("Score: 0 of 1 caught, 0.0%; 95 % interval 0.0% to 79.3% (Wilson)", said)
        self.assertIn(f"FAULT: sim/compare/sign.cpp:4: {SURVIVOR}: survived; add a test", said)
        reasons = [{"reason": "For the test.", "mutants": {"sim/compare/sign.cpp": [SURVIVOR]}}]
        exit_code, said = self.run_tool("--only", "number <= 0", reasons=reasons)
        self.assertEqual(exit_code, 0, said)
        self.assertIn("Score: none", said)

    def test_with_a_test_that_fails_without_a_change_nothing_is_tried(self):
        exit_code, said = self.run_tool("--only", "number <= 0", HYRAX_TEST_IS_RED="1")
        self.assertEqual(exit_code, 3, said)
        self.assertIn("tests fail, or take too long, without any change: cli.sum", said)

    def test_what_the_time_limit_leaves_is_not_tried(self):
        exit_code, said = self.run_tool("--minutes", "0", "--count", "3")
        self.assertEqual(exit_code, 1, said)
        self.assertIn("| all | 3 | 0 | 0 | 0 | 0 | 0 | 3 |", said)
        self.assertIn("FAULT: no mutant was tried within 0 minutes", said)
