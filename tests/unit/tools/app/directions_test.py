"""A folder of tools/app includes only what its line of CMakeLists.txt names, and no program includes another's files."""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["HYRAX_SOURCE_DIR"])
APP = SOURCE / "tools/app"
# Targets of one folder.
TARGETS = {"sim/compare": {"hyrax_compare", "hyrax_expectations"},
           "sim/reference": {"hyrax_reference", "hyrax_reference_gsl"},
           "tools/files": {"hyrax_files", "hyrax_golden"}, "tools/platform": {"hyrax_platform", "hyrax_process"},
           "tools/report": {"hyrax_report", "hyrax_pages"}, "tools/report/wasm": {"hyrax_page_record"}}
NOT_INCLUDED = {"hyrax_reference_gsl"}  # Links that need no header of their own.


def includes_of(folder):
    """The folders of the project whose headers a folder's files include."""
    return {str(pathlib.PurePath(name).parent) for path in sorted(folder.iterdir()) if path.suffix in (".h", ".cpp")
            for name in re.findall(r'^#include "([^"]*/[^"]*)"', path.read_text(encoding="utf-8"), re.MULTILINE)}


def declared_in(text):
    """{folder: what it uses} of each line hyrax_app(FOLDER USED...), in their order."""
    return {words[0]: set(words[1:]) for words in map(str.split, re.findall(r"^hyrax_app\(([^)]*)\)", text, re.MULTILINE))}


def faults(folder, included, declared):
    """Sentences on what a folder of tools/app includes and does not declare, and the other way round."""
    unused = declared - NOT_INCLUDED
    for name in sorted(included - {f"tools/app/{folder}"}):
        parent, last = name.rsplit("/", 1)
        targets = {last} if parent == "tools/app" else TARGETS.get(name, {f"hyrax_{last}"})
        if not targets & declared:
            yield f"{folder} includes headers of {name}, which it does not use"
        unused -= targets
    yield from (f"{folder} uses {name}, and includes no header of it" for name in sorted(unused))


class Directions(unittest.TestCase):
    """CMake refuses a folder that uses one below it, so there is no circle where includes and lines agree."""

    def setUp(self):
        self.declared = declared_in((APP / "CMakeLists.txt").read_text(encoding="utf-8"))

    def test_each_folder_has_its_line(self):
        self.assertEqual({path.name for path in APP.iterdir() if path.is_dir()}, {"expect", *self.declared})

    def test_includes_and_lines_agree(self):
        self.assertEqual([fault for folder, declared in self.declared.items()
                          for fault in faults(folder, includes_of(APP / folder), declared)], [])

    def test_expect_uses_no_other_folder(self):
        self.assertFalse({name for name in includes_of(APP / "expect") if name.startswith("tools/")} -
                         {"tools/app/expect", "tools/files"})

    def test_no_program_includes_another(self):
        for program in sorted((SOURCE / "tools").glob("hyrax*")):
            others = {name for name in includes_of(program) if name.startswith("tools/hyrax")} - {f"tools/{program.name}"}
            self.assertEqual(others, set(), program.name)

    def test_nothing_below_includes_the_application(self):
        below = [path for folder in ("sim", "tools/files", "tools/store", "tools/report")
                 for path in (SOURCE / folder, *(SOURCE / folder).rglob("*/"))]
        self.assertEqual([str(path) for path in below for name in includes_of(path)
                          if name.startswith(("tools/app", "tools/hyrax-"))], [])

    def test_faults_are_found(self):
        self.assertEqual(list(faults("play", {"tools/app/play", "tools/app/drift", "sim/replay"}, {"hyrax_replay", "diff"})),
                         ["play includes headers of tools/app/drift, which it does not use",
                          "play uses diff, and includes no header of it"])
