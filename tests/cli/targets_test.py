"""With Makefiles every target builds alone: what it needs of other targets is built before it.

A Makefile of a target knows what another target makes as a file, which must be there; Ninja knows how it is made.
"""

import os
import pathlib
import re
import shutil
import tempfile
import unittest

from process import run, skip_unless_installed, succeed
from program import SOURCE

RULE = re.compile(r"^([^\s#:=][^:=]*):\s+(\S+)$", re.MULTILINE)


class Targets(unittest.TestCase):
    def test_a_project_whose_path_is_a_pattern_is_refused(self):
        for name in ("[2]", "a*", "b?"):
            with tempfile.TemporaryDirectory(prefix=name) as folder:
                shutil.copy(SOURCE / "CMakeLists.txt", folder)
                self.assertRegex(run("cmake", "-S", folder, "-B", f"{folder}/build").err, r"the path\s+of\s+the\s+project\s+must\s+not\s+have")

    def test_a_file_that_a_target_needs_is_made_by_it_or_by_a_target_that_is_built_before(self):
        skip_unless_installed("make")
        with tempfile.TemporaryDirectory() as folder:
            succeed("cmake", "-S", SOURCE, "-B", folder, "-G", "Unix Makefiles", f"-DCMAKE_CXX_COMPILER={os.environ['HYRAX_CXX']}")
            order = RULE.findall((pathlib.Path(folder) / "CMakeFiles/Makefile2").read_text())
            rules = {str(path.parent.relative_to(folder)): RULE.findall(path.read_text()) for path in pathlib.Path(folder).rglob("build.make")}
        self.assertGreater(len(rules), 50)
        makers = {}
        for target, lines in rules.items():
            for file, _ in lines:
                makers.setdefault(file, set()).add(target)
        before = {target: {target} for target in rules}  # Those that are built before it, and itself.
        direct = [(after.removesuffix("/all"), first.removesuffix("/all")) for after, first in order if after.endswith(".dir/all") and first.endswith(".dir/all")]
        while any(before[after] != before[after] | before[first] for after, first in direct):
            for after, first in direct:
                before[after] |= before[first]
        for target, lines in rules.items():
            for file, needed in lines:
                self.assertTrue(before[target] & makers.get(needed, {target}), f"{target}: {file} needs {needed}")
