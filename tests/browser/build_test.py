"""How the page gets into hyrax-sim: after each change of it, and without a part in the builds between."""

import os
import pathlib

from process import succeed
from program import SOURCE, ProgramTest

BUILD = pathlib.Path(os.environ["HYRAX_BUILD"])


class PageBuildTest(ProgramTest):
    """Builds of hyrax-sim with HYRAX_PAGE."""

    def test_a_second_build_does_nothing(self):
        first, second = (succeed("cmake", "--build", BUILD, "--target", "hyrax-sim", timeout=600) for _ in range(2))
        self.assertIn("no work to do", second.out, first)

    def test_the_program_depends_on_the_page_in_a_unity_build_too(self):
        succeed("cmake", "-S", SOURCE, "-B", self.folder, "-G", "Ninja", "-DHYRAX_PAGE=ON", timeout=600)
        inputs = succeed("ninja", "-C", self.folder, "-t", "query",
                         "tools/CMakeFiles/hyrax_page.dir/report/page_template.cpp.o").out
        for page in ("runs", "sweeps"):
            self.assertIn(f"page/{page}.html", inputs)
